//! What the kernels know of joints: bodies that hang on each other in one way only make a tree, and a
//! row of it is a body with the joint that holds it.

use glam::{Quat, Vec3};

use super::layout::{numbers, rows};

numbers! {
    /// What [`Node`] and [`Limit`] hold in numbers.
    pub const JOINT_NUMBERS;

    /// No such row.
    pub const NONE = u32::MAX;

    /// A row that holds nothing: it fills a workgroup up.
    pub const EMPTY = 0;
    /// Nothing holds the body: it is the root of a free tree.
    pub const FREE = 1;
    /// Two points stay together: three rows of the constraint matrix.
    pub const PIN = 2;
    /// Two points and two axes stay together: five rows.
    pub const HINGE = 3;
    /// Two points keep their distance: one row.
    pub const ROD = 4;
    /// A point keeps its distance from two others: two rows.
    pub const TWO_RODS = 5;

    /// The tilt of an axis, and the twist about it, are limited.
    pub const CONE_TWIST = 1;
    /// Pitch, yaw and roll are limited.
    pub const EULER = 2;
}

/// An angle that no turn reaches, rad: the bound of what isn't limited.
pub const FREE_ANGLE: f32 = 10.0;

rows! {
    /// A body in a tree of joints, and the joint by which it hangs on its parent.
    ///
    /// A tree's rows lie together, parents before children and siblings side by side.
    pub struct Node {
        /// Row of the body.
        body: u32, "i", "";
        /// Row of the body that it hangs on, which may be static; 4294967295 for none.
        parent_body: u32, "p", "";
        /// Node of the body that it hangs on; 4294967295 if that isn't in the tree.
        parent: u32, "", "";
        /// 0 empty, 1 free, 2 pin, 3 hinge, 4 rod, 5 two rods.
        kind: u32, "", "";
        /// The joint's point, in the body's axes.
        anchor: Vec3, "o_i", "m";
        /// Nodes above it in its tree.
        depth: u32, "", "";
        /// The joint's point, in the parent's axes.
        parent_anchor: Vec3, "o_p", "m";
        /// Node of its first child; the others follow.
        first_child: u32, "", "";
        /// A hinge's unit axis, in the body's axes.
        axis: Vec3, "a_i", "";
        /// How many children it has.
        children: u32, "", "";
        /// A hinge's unit axis, in the parent's axes; where the second rod hangs, in its parent's axes.
        parent_axis: Vec3, "a_p", "";
        /// Length of the rod.
        length: f32, "l", "m";
        /// What the joint gave the body in the last substep; the parent got the opposite.
        impulse: Vec3, "λ", "N s";
        /// Length of the second rod.
        second_length: f32, "l₂", "m";
        /// The angular impulse of a hinge that closes a loop, beyond that of its impulse at the point.
        turning: Vec3, "λ_w", "N m s";
        /// Row of the body that the second rod hangs on; 4294967295 for none.
        second_parent: u32, "", "";
        /// The largest depth among the nodes of its workgroup.
        levels: u32, "", "";
        /// Index in the scene of the joint, or of the first of those that it stands for.
        joint: u32, "", "";
        /// Node of the root of its tree, where it is on the device.
        root: u32, "", "";
        /// Unused.
        spare_2: u32, "", "";
    }

    /// How far b may turn away from its rest in a.
    ///
    /// Both bodies have a frame of the joint: at rest the frames are one, and their y is the bone.
    pub struct Limit {
        /// Row of the body that it is measured in.
        a: u32, "a", "";
        /// Row of the body that turns.
        b: u32, "b", "";
        /// Index in the scene of the joint.
        joint: u32, "", "";
        /// 1 cone and twist, 2 pitch, yaw and roll.
        kind: u32, "", "";
        /// The joint's frame in a.
        frame_a: Quat, "f_a", "";
        /// The joint's frame in b.
        frame_b: Quat, "f_b", "";
        /// Lower bounds of tilt, twist and nothing, or of pitch, yaw and roll. −10 for none.
        low: Vec3, "φ_min", "rad";
        /// Unused.
        spare_1: f32, "", "";
        /// Upper bounds. 10 for none.
        high: Vec3, "φ_max", "rad";
        /// Unused.
        spare_2: f32, "", "";
        /// What held each of the three in the last substep: positive from below.
        impulses: Vec3, "λ", "N m s";
        /// Unused.
        spare_3: f32, "", "";
        /// The joint's point, in a's axes.
        anchor_a: Vec3, "o_a", "m";
        /// Unused.
        spare_4: f32, "", "";
        /// The joint's point, in b's axes.
        anchor_b: Vec3, "o_b", "m";
        /// Unused.
        spare_5: f32, "", "";
    }

    /// What a limit does to its two bodies in a substep: the row that bodies gather from.
    pub struct Turned {
        /// Turning impulse that b receives; a the opposite.
        turning: Vec3, "T", "N m s";
        /// 1 where it counts among those that share the bodies' masses in the next substep.
        counts: f32, "", "";
        /// Turning push that b receives; a the opposite.
        push: Vec3, "T_p", "N m s";
        /// Unused.
        spare: f32, "", "";
    }
}
