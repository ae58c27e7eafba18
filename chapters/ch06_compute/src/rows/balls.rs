//! What the kernels for balls know. A ball needs no tensor and no shape; static bodies are walls, which
//! are few, and so every ball looks at each.

use glam::{Quat, Vec3};

use super::layout::rows;

rows! {
    // ANCHOR: mover
    /// How a ball moves and turns: the 32 bytes that its neighbours gather beside its place.
    pub struct Mover {
        /// World velocity of its centre.
        velocity: Vec3, "v", "m/s";
        /// Among how many active contacts its mass is shared, at least 1.
        shares: f32, "n", "";
        /// World angular velocity.
        angular_velocity: Vec3, "ω", "rad/s";
        /// 0 for a ball that can't move.
        inverse_mass: f32, "1/m", "1/kg";
    }
    // ANCHOR_END: mover

    /// What stays with a ball when rows move.
    pub struct Ball {
        /// Its ID: its place in the scene.
        id: u32, "", "";
        /// Coefficient of restitution; a pair has the mean of the two.
        restitution: f32, "e", "";
        /// Kinetic coefficient of friction; a pair has the geometric mean of the two.
        friction: f32, "μ", "";
        /// Static coefficient of friction.
        static_friction: f32, "μ_s", "";
    }

    /// A static body.
    pub struct Wall {
        /// World position of its origin.
        position: Vec3, "p", "m";
        /// 0 ball, 1 box.
        kind: u32, "", "";
        /// Body to world.
        attitude: Quat, "q", "";
        /// Ball: radius, 0, 0. Box: half extents.
        size: Vec3, "s", "m";
        /// Coefficient of restitution.
        restitution: f32, "e", "";
        /// Kinetic coefficient of friction.
        friction: f32, "μ", "";
        /// Static coefficient of friction.
        static_friction: f32, "μ_s", "";
        /// The body's ID.
        id: u32, "", "";
        /// Unused.
        spare: u32, "", "";
    }

    /// The grid of a scene, and how much room there is.
    pub struct GridOf {
        /// Edge of a cell.
        edge: f32, "", "m";
        /// Slots along x: a power of two.
        slots_x: u32, "", "";
        /// Slots along y.
        slots_y: u32, "", "";
        /// Slots along z.
        slots_z: u32, "", "";
        /// How many balls there are.
        rows: u32, "", "";
        /// For how many there is memory: the neighbours of a row lie this far apart.
        capacity: u32, "", "";
        /// For how many neighbours a row has room.
        room: u32, "", "";
        /// How many walls there are.
        walls: u32, "", "";
        /// How many starts of slots there are: one for each, one for what is lost, one for the end.
        starts: u32, "", "";
        /// Two balls this near are neighbours even at rest.
        margin: f32, "", "m";
        /// No two are neighbours beyond this.
        most_margin: f32, "", "m";
        /// The largest radius.
        widest: f32, "", "m";
        /// Unused.
        spare: u32, "", "";
        /// Unused.
        spare_2: u32, "", "";
        /// Unused.
        spare_3: u32, "", "";
        /// Length of a step.
        dt: f32, "Δt", "s";
    }
}

/// What the kernels say of how it goes: a number each, with its name and what it is.
pub const STATUS: [(&str, &str); 5] = [
    (
        "NEEDED",
        "For how many neighbours a row must have room. If it has less, no step is made.",
    ),
    (
        "NOT_FINITE",
        "How many rows were not finite, summed over all steps.",
    ),
    (
        "FIRST_NOT_FINITE",
        "The smallest ID of a row that was not finite.",
    ),
    (
        "FAST",
        "How many rows moved farther in a step than the grid looks, summed over all steps.",
    ),
    ("STEPS", "How many steps were made."),
];
