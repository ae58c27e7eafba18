//! The joints: who is joined in one table, how in others, so that a scene without rods has no column
//! of lengths. A joint names the row of its pin or rod, and that of its limit if it has one.

use ch04_ragdolls::{AngleLimits, Bound};
use glam::{Mat3, Quat, Vec3};

/// No such row.
pub const NONE: u32 = u32::MAX;

crate::table! {
    /// What joins bodies: first the trees, parents before children, then what closes loops.
    pub struct Joints of
    /// A joint.
    Joint in "joints" {
        /// Row of the parent.
        parent: u32, "1", "";
        /// Row of the child.
        child: u32, "2", "";
        /// Index of the joint in the scene.
        scene_joint: u32, "#", "";
        /// 0 for a pin, 1 for a rod.
        kind: u32, "kind", "";
        /// Row of the pin or the rod.
        part: u32, "part", "";
        /// Row of the angle limit; 4294967295 if it has none.
        limit: u32, "limit", "";
        /// o₁, in the parent's axes.
        anchor_parent: Vec3, "o₁", "m";
        /// o₂, in the child's axes.
        anchor_child: Vec3, "o₂", "m";
        /// From the parent's centre to its point.
        arm_parent: Vec3, "t₁", "m";
        /// From the child's centre to its point.
        arm_child: Vec3, "t₂", "m";
        /// The visit that last looked at it.
        seen: u32, "seen", "";
        /// How far off that visit found it.
        off: f32, "off", "m";
    }
}

crate::table! {
    /// Points of two bodies that stay together.
    pub struct Pins of
    /// A pin.
    Pin in "pins" {
        /// K⁻¹: how the points yield.
        yielding: Mat3, "K⁻¹", "kg";
        /// Relative velocity of the points in the middle of the last step.
        parted: Vec3, "v_r*", "m/s";
        /// What the parent received in the last step.
        impulse: Vec3, "D", "N s";
        /// The gap that the last step left.
        left: Vec3, "d*", "m";
    }
}

crate::table! {
    /// Points of two bodies that keep their distance.
    pub struct Rods of
    /// A rod.
    Rod in "rods" {
        /// The distance.
        length: f32, "l", "m";
        /// The unit vector along it.
        along: Vec3, "d̂", "";
        /// What a unit impulse along it changes.
        response: f32, "w", "1/kg";
        /// The stretch's rate in the middle of the last step.
        parted: f32, "ḋ*", "m/s";
        /// What the parent received along it in the last step.
        impulse: f32, "D", "N s";
        /// The stretch that the last step left.
        left: f32, "d* − l", "m";
    }
}

crate::table! {
    /// How far children may turn away from their rest.
    pub struct Limits of
    /// An angle limit.
    Limit in "limits" {
        /// j: the child's orientation in the parent at rest.
        rest: Quat, "j", "";
        /// 0 cone and twist, 1 pitch, yaw and roll, 2 hinge.
        kind: u32, "kind", "";
        /// A hinge's axis in the parent.
        axis_parent: Vec3, "Â", "";
        /// A hinge's axis in the child.
        axis_child: Vec3, "B̂", "";
        /// Lower bounds; of a cone 0, twist, 0; of a hinge its range, 0, 0. −∞ for none.
        low: Vec3, "low", "rad";
        /// Upper bounds in the same order. ∞ for none.
        high: Vec3, "high", "rad";
    }
}

crate::table! {
    /// Turns that a limit bounds: three rows for each row of limits.
    pub struct Turns of
    /// A bounded turn.
    Turn in "turns" {
        /// g: the turn's rate is g·(ω₂ − ω₁).
        axis: Vec3, "g", "";
        /// How much further it may turn against g.
        room: f32, "room", "rad";
        /// 0 free, 1 from below, 2 from above, 3 fixed.
        bound: u32, "bound", "";
        /// Impulse at the pin that goes with a unit angular impulse.
        pin: Vec3, "lever", "1/m";
        /// What a unit angular impulse changes.
        response: f32, "w_g", "1/(kg m²)";
        /// Largest rate against g at which the limit isn't passed in the next step.
        slack: f32, "slack", "rad/s";
        /// The angular impulse by which it has been nudged.
        nudged: f32, "s_g", "kg m²";
        /// The angular impulse that held it in the last step.
        impulse: f32, "G", "N m s";
        /// How far beyond the limit the last step left it.
        left: f32, "g*", "rad";
    }
}

crate::table! {
    /// Runs of joints that hang on each other in one way only.
    pub struct Trees of
    /// A tree.
    Tree in "trees" {
        /// Row of its first joint.
        first: u32, "first", "";
        /// Row after its last joint.
        end: u32, "end", "";
    }
}

/// A limit as columns: kind, axes, lower and upper bounds.
#[must_use]
pub fn limit_columns(limits: &AngleLimits) -> Limit {
    let free = [f32::NEG_INFINITY, f32::INFINITY];
    let bounds = |x: [f32; 2], y: [f32; 2], z: [f32; 2]| Limit {
        low: Vec3::new(x[0], y[0], z[0]),
        high: Vec3::new(x[1], y[1], z[1]),
        ..Limit::default()
    };
    match *limits {
        AngleLimits::ConeTwist { cone, twist } => Limit {
            kind: 0,
            ..bounds(
                [0.0, cone.unwrap_or(f32::INFINITY)],
                twist.unwrap_or(free),
                [0.0; 2],
            )
        },
        AngleLimits::PitchYawRoll { pitch, yaw, roll } => Limit {
            kind: 1,
            ..bounds(pitch, yaw, roll)
        },
        AngleLimits::Hinge {
            axis_parent,
            axis_child,
            range,
        } => Limit {
            kind: 2,
            axis_parent,
            axis_child,
            ..bounds(range.unwrap_or(free), [0.0; 2], [0.0; 2])
        },
    }
}

/// The way back.
#[must_use]
pub fn limits_of(kind: u32, axes: [Vec3; 2], low: Vec3, high: Vec3) -> AngleLimits {
    let range = |low: f32, high: f32| high.is_finite().then_some([low, high]);
    match kind {
        0 => AngleLimits::ConeTwist {
            cone: high.x.is_finite().then_some(high.x),
            twist: range(low.y, high.y),
        },
        1 => AngleLimits::PitchYawRoll {
            pitch: [low.x, high.x],
            yaw: [low.y, high.y],
            roll: [low.z, high.z],
        },
        _ => AngleLimits::Hinge {
            axis_parent: axes[0],
            axis_child: axes[1],
            range: range(low.x, high.x),
        },
    }
}

/// A bound as a number.
#[must_use]
pub fn bound_code(bound: Bound) -> u32 {
    match bound {
        Bound::Free => 0,
        Bound::Low => 1,
        Bound::High => 2,
        Bound::Fixed => 3,
    }
}

/// The way back.
#[must_use]
pub fn bound_of(code: u32) -> Bound {
    match code {
        0 => Bound::Free,
        1 => Bound::Low,
        2 => Bound::High,
        _ => Bound::Fixed,
    }
}
