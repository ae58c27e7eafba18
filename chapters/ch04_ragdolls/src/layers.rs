//! What the overlay can draw of joints: their frames, and how far they let a child turn. As in chapter 3,
//! all of it is drawn from plain values.

use ch00_maths::f32::swing_twist::decompose;
use ch00_scenes::{Drawing, Rgb, palette};
use ch03_collision::layers::BodyView;
use glam::{Quat, Vec3};

use crate::{AngleLimits, Bound, Row};

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

/// A joint as drawings see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointView {
    /// Its parent.
    pub parent: BodyView,
    /// Its child.
    pub child: BodyView,
    /// The points of parent and child that it holds, world, m.
    pub points: (Vec3, Vec3),
    /// The angles that it limits, if any.
    pub angle: Option<AngleView>,
}

/// Limits of a joint's angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleView {
    /// j: the child's orientation in the parent at rest.
    pub rest: Quat,
    /// How far the child may turn from it.
    pub limits: AngleLimits,
}

/// Of every joint: its arms o₁ and o₂, the child's rest frame and its frame, and the gap.
#[must_use]
pub fn frames(joints: impl IntoIterator<Item = JointView>) -> Drawing {
    let mut drawing = Drawing::default();
    for joint in joints {
        let (parent, child) = (&joint.parent, &joint.child);
        let (one, two) = joint.points;
        let size = size_of(child);
        for (body, point) in [(parent, one), (child, two)] {
            if !body.is_static() {
                drawing.line(body.position, point, 1.2, ARM);
            }
        }
        if let Some(angle) = joint.angle {
            let rest = parent.orientation * angle.rest;
            drawing.frame(one, rest, 0.6 * size, 1.0);
            drawing.frame(two, child.orientation, size, 2.0);
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
#[must_use]
pub fn limits(joints: impl IntoIterator<Item = JointView>) -> Drawing {
    let mut drawing = Drawing::default();
    for joint in joints {
        if let Some(angle) = &joint.angle {
            draw_limits(&mut drawing, &joint, angle);
        }
    }
    drawing.explain(CONE, "directions that the bone may take");
    drawing.explain(TWIST, "turns that it may make about itself");
    drawing.explain(WITHIN, "the bone, within its limits");
    drawing.explain(AT_LIMIT, "the bone, at a limit");
    drawing
}

fn draw_limits(drawing: &mut Drawing, joint: &JointView, angle: &AngleView) {
    let (parent, child) = (&joint.parent, &joint.child);
    let at = joint.points.1;
    let size = size_of(child);
    let frame = parent.orientation * angle.rest;
    let bone = match angle.limits {
        AngleLimits::ConeTwist { cone, twist } => {
            let towards = towards_child(child, at);
            if let Some(cone) = cone {
                drawing.cone(at, frame * Vec3::Y * towards, cone, size, CONE);
            }
            draw_twist(drawing, at, frame, child, twist, size);
            child.orientation * Vec3::Y * towards
        }
        AngleLimits::PitchYawRoll { pitch, yaw, roll } => {
            let towards = towards_child(child, at);
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
            draw_twist(drawing, at, frame, child, Some(yaw), size);
            child.orientation * Vec3::Y * towards
        }
        AngleLimits::Hinge {
            axis_parent, range, ..
        } => {
            let axis = parent.orientation * axis_parent;
            let out = (child.position - at).reject_from(axis);
            let reach = out.length().max(size);
            let local = child.orientation.conjugate() * out.normalize_or(Vec3::X);
            drawing.line(at - size * axis, at + size * axis, 2.5, TWIST);
            if let Some(range) = range {
                drawing.sector(at, axis, frame * local, range, reach, CONE);
            }
            child.orientation * local
        }
    };
    let near = |row: &Row| row.bound != Bound::Fixed && row.room < NEAR;
    let limits = &angle.limits;
    let rows = limits.rows(parent.orientation, angle.rest, child.orientation);
    let at_limit = rows.iter().any(near);
    let color = if at_limit { AT_LIMIT } else { WITHIN };
    drawing.arrow(at, at + 1.15 * size * bone, 2.5, color);
}

/// The sector that a mark on the child's side may turn through, and where it is.
fn draw_twist(
    drawing: &mut Drawing,
    at: Vec3,
    frame: Quat,
    child: &BodyView,
    range: Option<[f32; 2]>,
    size: f32,
) {
    let Some(range) = range else {
        return;
    };
    let now = child.orientation;
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
fn towards_child(child: &BodyView, at: Vec3) -> f32 {
    let out = child.position - at;
    if out.dot(child.orientation * Vec3::Y) < 0.0 {
        -1.0
    } else {
        1.0
    }
}

/// How large a joint is drawn.
fn size_of(child: &BodyView) -> f32 {
    0.9 * child.shape.bounding_radius()
}
