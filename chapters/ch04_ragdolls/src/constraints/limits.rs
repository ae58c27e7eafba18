//! How far a child may turn away from its rest: the four sorts of limits that a joint can have, each
//! read as up to three turns about an axis with some room left.

use std::f32::consts::PI;

use ch00_maths::f32::rotation::log;
use ch00_maths::f32::swing_twist::{cone, decompose, swing_axes, twist_axis};
use glam::{Quat, Vec3};

/// Rows that limits have at most.
pub const MOST_ROWS: usize = 3;

// ANCHOR: limits
/// How far a child may turn away from j, its rest in its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AngleLimits {
    /// How far its y axis may tilt, rad, and how far it may twist about it; each free if absent.
    ConeTwist {
        /// Largest tilt.
        cone: Option<f32>,
        /// Smallest and largest twist.
        twist: Option<[f32; 2]>,
    },
    /// The report's: φ about x, θ about y, ψ about z, rad.
    PitchYawRoll {
        /// φ: the x of the swing.
        pitch: [f32; 2],
        /// θ: the twist.
        yaw: [f32; 2],
        /// ψ: the z of the swing.
        roll: [f32; 2],
    },
    /// A hinge: its axis in the parent and in the child stay one; it may turn about it.
    Hinge {
        /// In the parent's coordinates, unit.
        axis_parent: Vec3,
        /// In the child's coordinates, unit.
        axis_child: Vec3,
        /// Smallest and largest turn, rad; free if absent.
        range: Option<[f32; 2]>,
    },
}
// ANCHOR_END: limits

// ANCHOR: row
/// One turn that is limited: its rate is g·(ω₂ − ω₁).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// g, world.
    pub axis: Vec3,
    /// How much further it may turn against g, rad; negative beyond the limit.
    pub room: f32,
    /// What of it is bounded.
    pub bound: Bound,
}

/// Which way a row bounds its turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Bound {
    /// No such limit.
    #[default]
    Free,
    /// From below.
    Low,
    /// From above: g and room are those of the turn backwards.
    High,
    /// It stays where it is.
    Fixed,
}
// ANCHOR_END: row

impl Bound {
    // ANCHOR: bound
    /// The sum of angular impulses with one more: a limit pushes back only.
    #[must_use]
    pub fn accumulated(self, sum: f32, change: f32) -> f32 {
        if self == Self::Fixed {
            sum + change
        } else {
            (sum + change).max(0.0)
        }
    }

    /// The angular impulse, N m s, with which a limit holds whose angle changes at `rate` and may
    /// change against its axis at `slack`, rad/s, at most.
    #[must_use]
    pub fn held(self, impulse: f32, rate: f32, slack: f32, response: f32) -> f32 {
        let off = if self == Self::Fixed {
            rate
        } else {
            rate + slack
        };
        self.accumulated(impulse, -(off / response))
    }
    // ANCHOR_END: bound
}

impl Row {
    /// How far to turn along g to be within the limit, rad, if `room` is what is left.
    #[must_use]
    pub fn missing(&self, room: f32) -> f32 {
        match self.bound {
            Bound::Free => 0.0,
            Bound::Fixed => -room,
            Bound::Low | Bound::High => (-room).max(0.0),
        }
    }

    /// Nothing is limited.
    pub const FREE: Self = Self {
        axis: Vec3::ZERO,
        room: f32::INFINITY,
        bound: Bound::Free,
    };

    // ANCHOR: nearer
    /// The nearer of the two limits of an angle whose rate is `axis`·ω.
    fn within(angle: f32, [low, high]: [f32; 2], axis: Vec3) -> Self {
        let (above, below) = (angle - low, high - angle);
        if low == high {
            return Self {
                axis,
                room: above,
                bound: Bound::Fixed,
            };
        }
        if above < below {
            Self {
                axis,
                room: above,
                bound: Bound::Low,
            }
        } else {
            Self {
                axis: -axis,
                room: below,
                bound: Bound::High,
            }
        }
    }
    // ANCHOR_END: nearer
}

impl AngleLimits {
    // ANCHOR: rows
    /// What is limited at these orientations, `rest` being j.
    #[must_use]
    pub fn rows(&self, parent: Quat, rest: Quat, child: Quat) -> [Row; MOST_ROWS] {
        match *self {
            Self::ConeTwist { cone, twist } => cone_twist(parent * rest, child, cone, twist),
            Self::PitchYawRoll { pitch, yaw, roll } => {
                pitch_yaw_roll(parent * rest, child, pitch, yaw, roll)
            }
            Self::Hinge {
                axis_parent,
                axis_child,
                range,
            } => hinge(parent, rest, child, axis_parent, axis_child, range),
        }
    }
    // ANCHOR_END: rows
}

// ANCHOR: cone_twist
/// The tilt of ŷ, and the twist about it; `frame` is the rest frame in the world.
fn cone_twist(
    frame: Quat,
    child: Quat,
    widest: Option<f32>,
    twist: Option<[f32; 2]>,
) -> [Row; MOST_ROWS] {
    let (y_rest, y) = (frame * Vec3::Y, child * Vec3::Y);
    let mut rows = [Row::FREE; MOST_ROWS];
    if let (Some(widest), (angle, Some(axis))) = (widest, cone(y_rest, y)) {
        rows[0] = Row {
            axis: -axis,
            room: widest - angle,
            bound: Bound::High,
        };
    }
    if let Some(range) = twist.filter(|range| is_a_limit(*range)) {
        let angle = decompose(frame.conjugate() * child).twist;
        rows[1] = Row::within(angle, range, twist_axis(y_rest, y));
    }
    rows
}
// ANCHOR_END: cone_twist

// ANCHOR: pitch_yaw_roll
/// The report's three angles, read from swing and twist.
fn pitch_yaw_roll(
    frame: Quat,
    child: Quat,
    pitch: [f32; 2],
    yaw: [f32; 2],
    roll: [f32; 2],
) -> [Row; MOST_ROWS] {
    let (y_rest, y) = (frame * Vec3::Y, child * Vec3::Y);
    let parts = decompose(frame.conjugate() * child);
    let (pitch_axis, roll_axis) = swing_axes(frame, parts.swing, y);
    let row = |angle, range, axis| {
        if is_a_limit(range) {
            Row::within(angle, range, axis)
        } else {
            Row::FREE
        }
    };
    [
        row(parts.swing.x, pitch, pitch_axis),
        row(parts.twist, yaw, twist_axis(y_rest, y)),
        row(parts.swing.z, roll, roll_axis),
    ]
}
// ANCHOR_END: pitch_yaw_roll

// ANCHOR: hinge
/// Two turns across the axis that stay zero, and the one about it.
///
/// To first order the axes' cross product Â × B̂ is the turn by which B̂ has left Â.
fn hinge(
    parent: Quat,
    rest: Quat,
    child: Quat,
    axis_parent: Vec3,
    axis_child: Vec3,
    range: Option<[f32; 2]>,
) -> [Row; MOST_ROWS] {
    let (a, b) = (parent * axis_parent, child * axis_child);
    let off = a.cross(b);
    let (u, w) = axis_parent.any_orthonormal_pair();
    let across = |local: Vec3| {
        let axis = parent * local;
        Row {
            axis,
            room: off.dot(axis),
            bound: Bound::Fixed,
        }
    };
    let about = range
        .filter(|range| is_a_limit(*range))
        .map_or(Row::FREE, |range| {
            let turned = log((parent * rest).conjugate() * child).dot(axis_child);
            Row::within(turned, range, b)
        });
    [across(u), across(w), about]
}
// ANCHOR_END: hinge

/// Whether a range leaves anything out: one that goes all the way round doesn't.
fn is_a_limit(range: [f32; 2]) -> bool {
    range[0] > -PI || range[1] < PI
}
