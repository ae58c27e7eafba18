//! What the overlay can draw of joints: their frames, and how far they let a child turn.

use ch00_maths::f32::swing_twist::decompose;
use ch00_scenes::{Drawing, Rgb, palette};
use ch02_rigid_bodies::RigidBody;
use glam::{Quat, Vec3};

use crate::constraints::{Bound, Row};
use crate::{AngleConstraint, AngleLimits, Assembly, RigidJoint};

const GAP: Rgb = palette::VERMILLION;
const ARM: Rgb = palette::GREY;
const WITHIN: Rgb = palette::GREEN;
const AT_LIMIT: Rgb = palette::VERMILLION;
const TWIST: Rgb = palette::SKY;
const CONE: Rgb = palette::ORANGE;

/// A joint is at its limit where it has less room than this, rad.
const NEAR: f32 = 0.02;

/// A gap is drawn larger than it is, so that it can be seen.
const MAGNIFIED: f32 = 20.0;

/// Of every joint: its arms o₁ and o₂, the child's rest frame and its frame, and the gap.
pub fn frames(joints: &Assembly) -> Drawing {
    let mut drawing = Drawing::default();
    for joint in joints.joints() {
        let (parent, child) = (joint.bodies().0.borrow(), joint.bodies().1.borrow());
        let (one, two) = joint.points();
        let size = size_of(&child);
        for (body, point) in [(&parent, one), (&child, two)] {
            if !body.is_static() {
                drawing.line(body.position(), point, 1.2, ARM);
            }
        }
        if let Some(angle) = joint.angle() {
            let rest = parent.orientation() * angle.rest();
            drawing.frame(one, rest, 0.6 * size, 1.0);
            drawing.frame(two, child.orientation(), size, 2.0);
        }
        if one != two {
            drawing.line(two, two + MAGNIFIED * (one - two), 3.0, GAP);
        }
    }
    drawing.explain(ARM, "from the bodies' centres to the joint");
    drawing.explain(palette::VERMILLION, "x, and gaps (20 times as long)");
    drawing.explain(palette::GREEN, "y, the bone");
    drawing.explain(palette::BLUE, "z; thin: where the child rests");
    drawing
}

/// Of every joint with limits: the cone that its bone may swing in, the sector of its twist, and
/// where the bone is.
pub fn limits(joints: &Assembly) -> Drawing {
    let mut drawing = Drawing::default();
    for joint in joints.joints() {
        if let Some(angle) = joint.angle() {
            draw_limits(&mut drawing, joint, angle);
        }
    }
    drawing.explain(CONE, "directions that the bone may take");
    drawing.explain(TWIST, "turns that it may make about itself");
    drawing.explain(WITHIN, "the bone, within its limits");
    drawing.explain(AT_LIMIT, "the bone, at a limit");
    drawing
}

fn draw_limits(drawing: &mut Drawing, joint: &RigidJoint, angle: &AngleConstraint) {
    let (parent, child) = (joint.bodies().0.borrow(), joint.bodies().1.borrow());
    let at = joint.points().1;
    let size = size_of(&child);
    let frame = parent.orientation() * angle.rest();
    let bone = match *angle.limits() {
        AngleLimits::ConeTwist { cone, twist } => {
            let towards = towards_child(&child, at);
            if let Some(cone) = cone {
                drawing.cone(at, frame * Vec3::Y * towards, cone, size, CONE);
            }
            draw_twist(drawing, at, frame, &child, twist, size);
            child.orientation() * Vec3::Y * towards
        }
        AngleLimits::PitchYawRoll { pitch, yaw, roll } => {
            let towards = towards_child(&child, at);
            let turned = if towards < 0.0 {
                Quat::from_xyzw(1.0, 0.0, 0.0, 0.0)
            } else {
                Quat::IDENTITY
            };
            drawing.swing_cone(
                at,
                frame * turned,
                |azimuth| widest(pitch, roll, azimuth),
                size,
                CONE,
            );
            draw_twist(drawing, at, frame, &child, Some(yaw), size);
            child.orientation() * Vec3::Y * towards
        }
        AngleLimits::Hinge {
            axis_parent, range, ..
        } => {
            let axis = parent.orientation() * axis_parent;
            let out = (child.position() - at).reject_from(axis);
            let reach = out.length().max(size);
            let local = child.orientation().conjugate() * out.normalize_or(Vec3::X);
            drawing.line(at - size * axis, at + size * axis, 2.5, TWIST);
            if let Some(range) = range {
                drawing.sector(at, axis, frame * local, range, reach, CONE);
            }
            child.orientation() * local
        }
    };
    let near = |row: &Row| row.bound != Bound::Fixed && row.room < NEAR;
    let at_limit = angle.rows(&parent, &child).iter().any(near);
    let color = if at_limit { AT_LIMIT } else { WITHIN };
    drawing.arrow(at, at + 1.15 * size * bone, 2.5, color);
}

/// The sector that a mark on the child's side may turn through, and where it is.
fn draw_twist(
    drawing: &mut Drawing,
    at: Vec3,
    frame: Quat,
    child: &RigidBody,
    range: Option<[f32; 2]>,
    size: f32,
) {
    let Some(range) = range else {
        return;
    };
    let now = child.orientation();
    let twist = decompose(frame.conjugate() * now).twist;
    let axis = now * Vec3::Y;
    let mark = now * Vec3::X;
    let zero = Quat::from_axis_angle(axis, -twist) * mark;
    drawing.sector(at, axis, zero, range, 0.45 * size, TWIST);
    drawing.arrow(at, at + 0.5 * size * mark, 1.5, TWIST);
}

/// How far an elliptic swing may go towards an azimuth, from x to z. A bone that tilts towards x turns
/// about −z: that is roll; towards z it turns about x: pitch.
fn widest(pitch: [f32; 2], roll: [f32; 2], azimuth: f32) -> f32 {
    let (toward_x, toward_z) = (azimuth.cos(), azimuth.sin());
    let to_x = if toward_x > 0.0 { -roll[0] } else { roll[1] };
    let to_z = if toward_z > 0.0 { pitch[1] } else { -pitch[0] };
    let reach = |side: f32, most: f32| {
        if side.abs() < 1e-3 {
            f32::INFINITY
        } else {
            most / side.abs()
        }
    };
    reach(toward_x, to_x)
        .min(reach(toward_z, to_z))
        .clamp(0.0, 3.1)
}

/// Whether the child lies along its y axis from the joint or against it.
fn towards_child(child: &RigidBody, at: Vec3) -> f32 {
    let out = child.position() - at;
    if out.dot(child.orientation() * Vec3::Y) < 0.0 {
        -1.0
    } else {
        1.0
    }
}

/// How large a joint is drawn.
fn size_of(child: &RigidBody) -> f32 {
    0.9 * child.collider().bounding_radius()
}
