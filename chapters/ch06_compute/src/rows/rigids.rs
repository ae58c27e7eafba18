//! What the kernels for bodies of any shape know: a body as its pairs gather it, whom it may touch, and
//! the pairs. Rows stay in the order of the scene, so a body's row is its ID.

use glam::{Quat, Vec3, Vec4};

use super::balls::STATUS;
use super::layout::{numbers, rows};

numbers! {
    /// What a [`Rigid`] can be in the broad phase, and what its list of rows tells.
    pub const ROLES;

    /// A body in the grid.
    pub const IN_GRID = 0;
    /// A body that is too large for the grid.
    pub const LARGE = 1;
    /// A body on a fixed point: it touches nothing.
    pub const ON_POINT = 2;
    /// In a body's list, in the place of twice a row and the body's side: the row is a limit's.
    pub const OF_LIMIT = 1 << 31;
}

rows! {
    /// A body. What its pairs gather lies in one run of 128 bytes, which a GPU fetches as a whole.
    pub struct Rigid {
        /// World position of its origin.
        position: Vec3, "p", "m";
        /// Radius of the ball about its origin that holds it.
        reach: f32, "r", "m";
        /// Body to world.
        attitude: Quat, "q", "";
        /// World velocity of its origin.
        velocity: Vec3, "v", "m/s";
        /// Among how many active pairs and limits its mass is shared, at least 1.
        shares: f32, "n", "";
        /// World angular velocity.
        angular_velocity: Vec3, "ω", "rad/s";
        /// 0 for a static body, and for one on a fixed point.
        inverse_mass: f32, "1/m", "1/kg";
        /// Inverse of its principal moments of inertia, in its own axes; 0 for a static body.
        inverse_inertia: Vec3, "1/I", "1/(kg m²)";
        /// 0 ball, 1 box, 2 capsule, 3 cylinder: the kinds of chapter 5.
        kind: u32, "", "";
        /// Ball: radius, 0, 0. Box: half extents. Capsule and cylinder: radius, half height, 0.
        size: Vec3, "s", "m";
        /// 0 in the grid, 1 too large for it, 2 on a fixed point: touches nothing.
        role: u32, "", "";
        /// Coefficient of restitution; a pair has the mean of the two.
        restitution: f32, "e", "";
        /// Kinetic coefficient of friction; a pair has the geometric mean of the two.
        friction: f32, "μ", "";
        /// Static coefficient of friction.
        static_friction: f32, "μ_s", "";
        /// Its number among the large bodies that move; 4294967295 if it is none.
        large: u32, "", "";
        /// Where the bodies begin that it passes through.
        ignored: u32, "", "";
        /// How many these are.
        ignored_count: u32, "", "";
        /// How many limits and loops end at it.
        ends: u32, "", "";
        /// Its row among the nodes of trees, or among the bodies on a fixed point; 4294967295 for none.
        seat: u32, "", "";
    }

    /// Where a body may be in the step.
    pub struct Bound {
        /// The lower corner.
        low: Vec3, "", "m";
        /// Its row, its kind, and whether it is static.
        body: u32, "", "";
        /// The upper corner.
        high: Vec3, "", "m";
        /// Whether it is too large or too fast for the grid.
        flags: u32, "", "";
    }

    /// In a body's list of those that it may touch, in the order of their rows: one of them, and the
    /// pair. The first row of a list says how many there are.
    pub struct Partner {
        /// Its row, where the pair is listed among the kinds, and whether it is listed by this body.
        body: u32, "", "";
        /// The row of the pair.
        pair: u32, "", "";
    }

    /// Where a pair touches or soon may, and what becomes of it there: a `Manifold` and a `Material`.
    pub struct Contact {
        /// Unit vector from a to b: in the world, or in the axes of the body that it turns with.
        normal: Vec3, "n", "";
        /// How the normal turns: 0 by the core points, 1 with a, 2 with b, 3 not at all.
        turns: u32, "", "";
        /// What a's surface is away from its core points.
        round_a: f32, "ρ_a", "m";
        /// What b's surface is away from its core points.
        round_b: f32, "ρ_b", "m";
        /// Row of the body with the smaller ID.
        a: u32, "a", "";
        /// Row of the other.
        b: u32, "b", "";
        /// Coefficient of restitution.
        restitution: f32, "e", "";
        /// Kinetic coefficient of friction.
        friction: f32, "μ", "";
        /// Static coefficient of friction.
        static_friction: f32, "μ_s", "";
        /// How many points there are, up to 4.
        points: u32, "", "";
        /// Of each point its core point in a's axes, then that in b's.
        cores: [Vec4; 8], "l", "m";
    }

    /// What a pair remembers: an `Impulse` and what else goes on into the next step.
    pub struct Memory {
        /// Normal impulses of up to four points.
        normal: Vec4, "λ", "N s";
        /// Friction at the mean of the points, in the world.
        friction: Vec3, "λ_t", "N s";
        /// Friction against turning about the normal.
        twist: f32, "λ_w", "N m s";
        /// How fast each point came this step, negative; 0 where it didn't.
        approach: Vec4, "u", "m/s";
        /// The bits of the points' features; 0 where there is no point.
        features: Vec4, "", "";
    }

    /// What a pair does to its two bodies in a substep: a `Press` as bodies gather it.
    pub struct Pressed {
        /// Impulse that b receives; a the opposite.
        linear: Vec3, "P", "N s";
        /// 1 where the pair counts among those that share the bodies' masses in the next substep.
        counts: f32, "", "";
        /// Push that b receives; a the opposite.
        push: Vec3, "P_p", "N s";
        /// 1 where the pair bounces at the end of the step.
        bounces: f32, "", "";
        /// Turning impulse and turning push that a receives; then b's. The fourth number of the impulses is
        /// 1 where the next substep begins with them.
        turning: [Vec4; 4], "T", "N m s";
    }

    /// All that pulls and presses on a body, summed.
    pub struct Total {
        /// Impulses.
        linear: Vec3, "P", "N s";
        /// How many pairs and limits count.
        counts: f32, "", "";
        /// Turning impulses.
        angular: Vec3, "T", "N m s";
        /// How many pairs bounce.
        bounces: f32, "", "";
        /// Those impulses with which the next substep begins.
        stays_linear: Vec3, "P", "N s";
        /// How many pairs and loops count.
        touches: f32, "", "";
        /// Those angular impulses.
        stays_angular: Vec3, "T", "N m s";
        /// Unused.
        spare_2: f32, "", "";
        /// Pushes.
        push: Vec3, "P_p", "N s";
        /// Unused.
        spare_3: f32, "", "";
        /// Turning pushes.
        push_angular: Vec3, "T_p", "N m s";
        /// Unused.
        spare_4: f32, "", "";
    }

    /// What holds a body, and its angular momentum: what only itself reads.
    pub struct Holding {
        /// Impulse with which the next substep begins.
        linear: Vec3, "P", "N s";
        /// Unused.
        spare_1: f32, "", "";
        /// The angular impulse.
        angular: Vec3, "T", "N m s";
        /// Unused.
        spare_2: f32, "", "";
        /// World angular momentum. A ball doesn't need it.
        momentum: Vec3, "L", "kg m²/s";
        /// Unused.
        spare_3: f32, "", "";
    }

    /// How a body moved before a substep's kick: what counts as the speed of an impact.
    pub struct Before {
        /// World velocity.
        velocity: Vec3, "v", "m/s";
        /// Unused.
        spare_1: f32, "", "";
        /// World angular velocity.
        angular_velocity: Vec3, "ω", "rad/s";
        /// Unused.
        spare_2: f32, "", "";
    }

    /// How pairs are listed, and how much room there is.
    pub struct PairsOf {
        /// For how many pairs there is memory.
        room: u32, "", "";
        /// How many kinds of pairs the scene can have.
        kinds: u32, "", "";
        /// How many large bodies move.
        larges: u32, "", "";
        /// For how many pairs of large bodies that move there is memory.
        large_room: u32, "", "";
        /// Where kinds 0 to 7 are listed: four bits each.
        low_slots: u32, "", "";
        /// The same for kinds 8 and 9.
        high_slots: u32, "", "";
        /// How many poles there are.
        poles: u32, "", "";
        /// How many rows of joints that close loops stand before those of pairs.
        before: u32, "", "";
        /// How many limits there are.
        limits: u32, "", "";
        /// The farthest that a body in the grid reaches.
        widest: f32, "", "m";
        /// Unused.
        spare_1: u32, "", "";
        /// Unused.
        spare_2: u32, "", "";
    }

    /// How many counts a scan makes starts of.
    pub struct Scan {
        /// So many.
        counts: u32, "", "";
        /// While more neighbours need room than this, no start is written; 4294967295 for always.
        room: u32, "", "";
        /// Unused.
        spare_1: u32, "", "";
        /// Unused.
        spare_2: u32, "", "";
    }

    /// A critically damped spring between a point of a body and the mouse.
    pub struct Mouse {
        /// Where the body is held, in its axes.
        anchor: Vec3, "", "m";
        /// Row of the body; 4294967295 if the mouse holds none.
        body: u32, "", "";
        /// Where it is pulled to, world.
        towards: Vec3, "", "m";
        /// The body's mass.
        mass: f32, "m", "kg";
    }

    /// A body that turns about a point fixed in the world.
    pub struct Pivot {
        /// The fixed point, world.
        point: Vec3, "", "m";
        /// The body's mass.
        mass: f32, "m", "kg";
        /// From the point to the body's origin, in the body's axes.
        arm: Vec3, "", "m";
        /// Row of the body.
        body: u32, "", "";
    }

    /// A magnetic pole in a body.
    pub struct Pole {
        /// In the body's axes.
        place: Vec3, "", "m";
        /// Row of the body.
        body: u32, "", "";
        /// Its strength, √N m.
        strength: f32, "s", "";
        /// The distance ε that keeps the pull of poles in one place finite.
        softening: f32, "ε", "m";
        /// Which of the scene's forces it belongs to: poles feel those of their own.
        force: u32, "", "";
        /// Unused.
        spare: u32, "", "";
    }
}

/// What the kernels for pairs say of how it goes, behind [`STATUS`].
pub const PAIR_STATUS: [(&str, &str); 10] = [
    (
        "HALTED",
        "1 where a step was not made, since something had no room.",
    ),
    ("PAIRS_NEEDED", "For how many pairs there must be room."),
    (
        "LARGE_NEEDED",
        "For how many pairs of large bodies that move there must be room.",
    ),
    ("LIVE", "How many pairs touch or soon may."),
    (
        "AHEAD",
        "How far the fastest body of the grid looks ahead in this step, m: the bits of the number.",
    ),
    (
        "LOOK",
        "A body that looks farther ahead is not in the grid, m: the bits of the number.",
    ),
    (
        "HALF_CELL",
        "How many bodies look farther ahead than half a cell in this step.",
    ),
    ("ONE_CELL", "How many look farther than a cell."),
    ("TWO_CELLS", "How many look farther than two."),
    (
        "KIND_FIRST",
        "Here and behind: where the pairs of each kind begin; one more at the end.",
    ),
];

/// How many numbers `status` has where there are pairs.
pub const PAIR_STATUS_LEN: usize =
    STATUS.len() + PAIR_STATUS.len() + crate::own_row::narrow::PAIR_KINDS as usize;

/// The place of a number in `status`.
#[must_use]
pub fn status_place(name: &str) -> usize {
    let all = STATUS.iter().chain(&PAIR_STATUS);
    all.map(|(known, _)| *known)
        .position(|known| known == name)
        .unwrap_or(PAIR_STATUS_LEN)
}
