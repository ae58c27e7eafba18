//! What a scene needs: one question a part, answered from the scene alone.

use ch00_scenes::{Body, Force, Joint, Scene, Shape};
use glam::{DQuat, DVec3};

use super::Part;
use crate::world::Method;

// ANCHOR: needs
/// Whether this scene needs a part.
pub fn needs(scene: &Scene, method: Method, part: Part) -> bool {
    let corrected = method == Method::Corrected;
    match part {
        Part::Corrected => corrected,
        Part::Printed => !corrected,
        Part::Turning => !corrected || something_turns(scene),
        Part::Axes => {
            needs(scene, method, Part::Turning) && (!corrected || something_has_axes(scene))
        }
        Part::Orientations => {
            needs(scene, method, Part::Turning) || scene.bodies.iter().any(is_turned)
        }
        Part::Collisions => two_could_touch(scene),
        Part::Resolution => !scene.joints.is_empty() || (corrected && two_could_touch(scene)),
        Part::Bouncing => {
            two_could_touch(scene) && (!corrected || scene.bodies.iter().any(bounces))
        }
        Part::Friction => corrected && two_could_touch(scene) && two_rub(scene),
        Part::Joints => !scene.joints.is_empty(),
        Part::Rods => scene.joints.iter().any(is_rod),
        Part::Limits => scene.joints.iter().any(limits_angles),
        Part::Forces => !scene.forces.is_empty(),
        Part::FixedPoints => scene.forces.iter().any(|force| held(force).is_some()),
        Part::Round | Part::Mouse | Part::Obstacles | Part::IdleVisits => false,
    }
}
// ANCHOR_END: needs

fn movers(scene: &Scene) -> impl Iterator<Item = &Body> {
    scene.bodies.iter().filter(|body| !body.is_static())
}

// ANCHOR: turns
/// Whether anything could turn a body that moves, or turns it already. The normal of a ball's contact
/// goes through its centre; friction, joints and forces need not.
fn something_turns(scene: &Scene) -> bool {
    let could_turn = |body: &Body| {
        !matches!(body.shape, Shape::Sphere { .. })
            || body.static_friction() > 0.0
            || body.angular_velocity != DVec3::ZERO
            || is_turned(body)
    };
    !scene.joints.is_empty() || !scene.forces.is_empty() || movers(scene).any(could_turn)
}
// ANCHOR_END: turns

/// Whether the inertia of something that moves depends on how it is turned. Joints reckon with axes.
fn something_has_axes(scene: &Scene) -> bool {
    !scene.joints.is_empty()
        || scene.forces.iter().any(|force| held(force).is_some())
        || movers(scene).any(|body| !matches!(body.shape, Shape::Sphere { .. }))
}

fn bounces(body: &Body) -> bool {
    body.restitution > 0.0
}

fn is_turned(body: &Body) -> bool {
    body.orientation != DQuat::IDENTITY
}

/// Whether two bodies that don't hang on fixed points could meet: one of them must move.
fn two_could_touch(scene: &Scene) -> bool {
    let is_held = |i: usize| scene.forces.iter().any(|force| held(force) == Some(i));
    let free: Vec<&Body> = (0..scene.bodies.len())
        .filter(|&i| !is_held(i))
        .map(|i| &scene.bodies[i])
        .collect();
    free.len() > 1 && free.iter().any(|body| !body.is_static())
}

/// Whether two bodies have friction, one of which moves: a pair has the geometric mean of the two.
fn two_rub(scene: &Scene) -> bool {
    let rough = |body: &&Body| body.static_friction() > 0.0;
    scene.bodies.iter().filter(rough).count() > 1 && movers(scene).any(|body| rough(&body))
}

fn is_rod(joint: &Joint) -> bool {
    matches!(joint, Joint::Distance { .. })
}

fn limits_angles(joint: &Joint) -> bool {
    match joint {
        Joint::Ball {
            cone,
            twist,
            limits,
            ..
        } => cone.is_some() || twist.is_some() || limits.is_some(),
        Joint::Distance { .. } => false,
        Joint::Hinge { .. } => true,
    }
}

/// The body that a force holds on a fixed point.
fn held(force: &Force) -> Option<usize> {
    match force {
        Force::FixedPoint { body, .. } => Some(*body),
        Force::Magnets { .. } | Force::Constant { .. } => None,
    }
}
