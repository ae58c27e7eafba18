//! Joints as rows: a pin is three, a hinge five, a distance one, and a limit one for each of its ends.

use ch00_scenes::{Joint as SceneJoint, Scene};

use super::bodies::Bodies;
use super::real::{Quat, Real, Vec3, atan2, quaternion, real, swing_twist, vector};
use super::row::Row;
use super::world::Pivot;

/// One row of a joint, and what it has pressed.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    /// Row of the body a in its table.
    pub a: usize,
    /// Row of the body b.
    pub b: usize,
    /// Point in a, m.
    pub anchor_a: Vec3,
    /// Point in b, m.
    pub anchor_b: Vec3,
    /// What it keeps.
    pub keeps: Keeps,
    /// What it pressed last, N s or N m s.
    pub impulse: Real,
}

/// What a row of a joint keeps.
#[derive(Clone, Copy, Debug)]
pub enum Keeps {
    /// The two points together along one axis of the world.
    Together(Vec3),
    /// The two points so far apart, m.
    Apart(Real),
    /// An axis of b square to one of a, each in its own body.
    Square(Vec3, Vec3),
    /// b's y axis within an angle, rad, of where it rests.
    Cone(Quat, Real),
    /// The turn about b's y axis above (1) or below (−1) an angle, rad, from where it rests.
    Twist(Quat, Real, Real),
    /// The turn about an axis of a above (1) or below (−1) an angle, rad, from where b was loaded.
    Turn(Vec3, Quat, Real, Real),
}

/// All rows of a scene's joints, in their order, then those of bodies on fixed points.
#[must_use]
pub fn joints_of(scene: &Scene, bodies: &Bodies, pivots: &[Pivot]) -> Vec<Joint> {
    let mut rows = Vec::new();
    for joint in &scene.joints {
        let (a, b) = joint.bodies();
        let (anchor_a, anchor_b) = joint.anchors();
        let mut add = |keeps| {
            rows.push(Joint {
                a,
                b,
                anchor_a: vector(anchor_a),
                anchor_b: vector(anchor_b),
                keeps,
                impulse: 0.0,
            });
        };
        keep(joint, bodies, &mut add);
    }
    for pivot in pivots {
        for axis in Vec3::AXES {
            rows.push(Joint {
                a: bodies.world(),
                b: pivot.body,
                anchor_a: pivot.point,
                anchor_b: -pivot.arm,
                keeps: Keeps::Together(axis),
                impulse: 0.0,
            });
        }
    }
    rows
}

fn keep(joint: &SceneJoint, bodies: &Bodies, add: &mut impl FnMut(Keeps)) {
    let (a, b) = joint.bodies();
    let loaded = bodies.attitude[a].conjugate() * bodies.attitude[b];
    match *joint {
        SceneJoint::Distance { length, .. } => add(Keeps::Apart(real(length))),
        SceneJoint::Ball {
            cone, twist, rest, ..
        } => {
            for axis in Vec3::AXES {
                add(Keeps::Together(axis));
            }
            let rest = rest.map_or(loaded, quaternion);
            if let Some(cone) = cone {
                add(Keeps::Cone(rest, real(cone)));
            }
            for (end, sign) in twist.into_iter().flatten().zip([1.0, -1.0]) {
                add(Keeps::Twist(rest, real(end), sign));
            }
        }
        SceneJoint::Hinge {
            axis_a,
            axis_b,
            range,
            ..
        } => {
            for axis in Vec3::AXES {
                add(Keeps::Together(axis));
            }
            let (axis_a, axis_b) = (vector(axis_a).normalize(), vector(axis_b).normalize());
            let (one, two) = axis_a.any_orthonormal_pair();
            add(Keeps::Square(one, axis_b));
            add(Keeps::Square(two, axis_b));
            for (end, sign) in range.into_iter().flatten().zip([1.0, -1.0]) {
                add(Keeps::Turn(axis_a, loaded, real(end), sign));
            }
        }
    }
}

impl Joint {
    // ANCHOR: joint_row
    /// The row where the bodies are now.
    #[must_use]
    pub fn row(&self, bodies: &Bodies) -> Row {
        let (a, b) = (self.a, self.b);
        let (q_a, q_b) = (bodies.attitude[a], bodies.attitude[b]);
        let (arm_a, arm_b) = (q_a * self.anchor_a, q_b * self.anchor_b);
        let apart = bodies.position[b] + arm_b - bodies.position[a] - arm_a;
        match self.keeps {
            Keeps::Together(axis) => Row::along((a, arm_a), (b, arm_b), axis, apart.dot(axis)),
            Keeps::Apart(length) => {
                let line = apart.normalize_or(Vec3::Y);
                Row::along((a, arm_a), (b, arm_b), line, apart.dot(line) - length)
            }
            Keeps::Square(of_a, of_b) => {
                let (one, two) = (q_a * of_a, q_b * of_b);
                Row::about(a, b, two.cross(one), one.dot(two))
            }
            Keeps::Cone(rest, most) => {
                let (angle, axis) = swing_twist::cone(q_a * rest * Vec3::Y, q_b * Vec3::Y);
                let axis = axis.unwrap_or(Vec3::ZERO);
                Row::about(a, b, -axis, most - angle).at_least_zero()
            }
            Keeps::Twist(rest, end, sign) => {
                let rest = q_a * rest;
                let twist = swing_twist::decompose(rest.conjugate() * q_b).twist;
                let axis = swing_twist::twist_axis(rest * Vec3::Y, q_b * Vec3::Y);
                Row::about(a, b, axis * sign, sign * (twist - end)).at_least_zero()
            }
            Keeps::Turn(of_a, loaded, end, sign) => {
                let turn = q_a.conjugate() * q_b * loaded.conjugate();
                let turn = if turn.w < 0.0 { -turn } else { turn };
                let about = Vec3::new(turn.x, turn.y, turn.z).dot(of_a);
                let angle = 2.0 * atan2(about, turn.w);
                Row::about(a, b, q_a * of_a * sign, sign * (angle - end)).at_least_zero()
            }
        }
    }
    // ANCHOR_END: joint_row
}
