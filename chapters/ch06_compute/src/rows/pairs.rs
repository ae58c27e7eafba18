//! What the kernels know of a pair of bodies that touch or soon may. a is the one with the smaller ID.

use glam::{Vec3, Vec4};

use super::layout::{numbers, rows};

numbers! {
    /// How the normal of a [`Manifold`] turns.
    pub const TURNS;

    /// The normal runs along the line between the two core points: ball or capsule against the same.
    pub const ROUND = 0;
    /// The normal turns with body a.
    pub const WITH_A = 1;
    /// The normal turns with body b.
    pub const WITH_B = 2;
    /// The normal keeps its world direction for the step: both bodies have faces.
    pub const FIXED = 3;
}

rows! {
    /// Where two bodies touch or soon may: up to four points with one normal.
    ///
    /// A point is held by its two core points, which stay where they are in their bodies for the step:
    /// the centre of a ball, a point on a capsule's segment, a point on the surface of a box or a
    /// cylinder. The distance there is that of the core points along the normal, less both round radii.
    pub struct Manifold {
        /// Unit vector from a to b: in the world, or in the axes of the body that it turns with.
        normal: Vec3, "n", "";
        /// How the normal turns: 0 by the core points, 1 with a, 2 with b, 3 not at all.
        turns: u32, "", "";
        /// What a's surface is away from its core points: a radius for ball and capsule, else 0.
        round_a: f32, "ρ_a", "m";
        /// What b's surface is away from its core points.
        round_b: f32, "ρ_b", "m";
        /// How many points there are, up to 4.
        points: u32, "", "";
        /// Which of the pair kinds it is.
        kind: u32, "", "";
        /// Core points in a's axes; the fourth number's bits are the point's feature.
        core_a: [Vec4; 4], "l_a", "m";
        /// Core points in b's axes; the fourth number is unused.
        core_b: [Vec4; 4], "l_b", "m";
    }

    /// What the points of a pair have pressed and rubbed by now, as b receives it; a the opposite.
    pub struct Impulse {
        /// Normal impulses of up to four points.
        normal: Vec4, "λ", "N s";
        /// Friction at the mean of the points, in the world.
        friction: Vec3, "λ_t", "N s";
        /// Friction against turning about the normal.
        twist: f32, "λ_w", "N m s";
    }

    /// What a pair does to its two bodies in a substep: the row that bodies gather from.
    pub struct Press {
        /// Impulse that b receives; a the opposite.
        linear: Vec3, "P", "N s";
        /// 1 where the pair counts among those that share the bodies' masses in the next substep.
        counts: f32, "", "";
        /// Turning impulse that a receives.
        angular_a: Vec3, "T_a", "N m s";
        /// 1 where the next substep begins with these impulses, 0 where they were an impact.
        stays: f32, "", "";
        /// Turning impulse that b receives.
        angular_b: Vec3, "T_b", "N m s";
        /// Unused.
        spare_2: f32, "", "";
        /// Push that b receives; a the opposite.
        push: Vec3, "P_p", "N s";
        /// Unused.
        spare_3: f32, "", "";
        /// Turning push that a receives.
        push_a: Vec3, "T_pa", "N m s";
        /// Unused.
        spare_4: f32, "", "";
        /// Turning push that b receives.
        push_b: Vec3, "T_pb", "N m s";
        /// Unused.
        spare_5: f32, "", "";
    }
}
