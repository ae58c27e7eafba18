//! Rows: what a kernel reads and writes at one index, laid out the same in Rust and in WGSL.
//!
//! A GPU fetches 16 bytes with one instruction, so properties that a kernel always reads together
//! share a row of 16 bytes, or of a multiple. A row is stated once, below; the WGSL that the kernels
//! are built with is generated from it, and a test compares every offset with the one that naga
//! computes.

mod balls;
mod bodies;
mod joints;
mod layout;
mod pairs;
mod rigids;
mod step;

pub use balls::{Ball, GridOf, Mover, STATUS, Wall};
pub use bodies::{Held, Material, Motion, Place, Push, Solid, Spin};
pub use joints::{
    CONE_TWIST, EMPTY, EULER, FREE, FREE_ANGLE, HINGE, JOINT_NUMBERS, Limit, NONE, Node, PIN, ROD,
    TWO_RODS, Turned,
};
pub(crate) use layout::rows;
pub use layout::{FieldSpec, Number, Row, WgslType, constants, declaration};
pub use pairs::{FIXED, Impulse, Manifold, Press, ROUND, TURNS, WITH_A, WITH_B};
pub use rigids::{
    Before, Bound, Contact, Holding, IN_GRID, LARGE, Memory, Mouse, OF_LIMIT, ON_POINT,
    PAIR_STATUS, PAIR_STATUS_LEN, PairsOf, Partner, Pivot, Pole, Pressed, ROLES, Rigid, Scan,
    Total, status_place,
};
pub use step::{Drawn, Seen, Step};

/// The WGSL of all rows, in the order in which they can be read.
#[must_use]
pub fn wgsl() -> String {
    [
        constants(JOINT_NUMBERS),
        constants(TURNS),
        constants(ROLES),
        declaration::<Place>(),
        declaration::<Motion>(),
        declaration::<Spin>(),
        declaration::<Push>(),
        declaration::<Held>(),
        declaration::<Solid>(),
        declaration::<Material>(),
        declaration::<Manifold>(),
        declaration::<Impulse>(),
        declaration::<Press>(),
        declaration::<Node>(),
        declaration::<Limit>(),
        declaration::<Turned>(),
        declaration::<Step>(),
        declaration::<Drawn>(),
        declaration::<Seen>(),
        declaration::<Mover>(),
        declaration::<Ball>(),
        declaration::<Wall>(),
        declaration::<GridOf>(),
        declaration::<Rigid>(),
        declaration::<Bound>(),
        declaration::<Partner>(),
        declaration::<Contact>(),
        declaration::<Memory>(),
        declaration::<Pressed>(),
        declaration::<Total>(),
        declaration::<Holding>(),
        declaration::<Before>(),
        declaration::<PairsOf>(),
        declaration::<Scan>(),
        declaration::<Mouse>(),
        declaration::<Pivot>(),
        declaration::<Pole>(),
        status(),
    ]
    .join("\n")
}

/// The places of the numbers in `status`, as WGSL.
fn status() -> String {
    let places = (0..).zip(STATUS.iter().chain(&PAIR_STATUS));
    let numbers = places.map(|(place, &(name, about))| (name, place, about));
    constants(&numbers.collect::<Vec<_>>())
}
