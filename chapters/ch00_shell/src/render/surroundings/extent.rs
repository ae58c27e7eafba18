//! How far a scene reaches, and what of it is worth seeing at the start.

use ch00_scenes::{Body, Scene, Shape};
use glam::{DMat3, DVec3, Vec3};

use super::Face;

/// The box about the moving bodies, where they circle, what walls enclose, and those floors
/// that are not much larger; of a larger floor only its height, so that the bodies can be
/// seen to land.
pub fn worth_seeing(
    scene: &Scene,
    moving_box: (DVec3, DVec3),
    floors: &[&Body],
    walls: &[Face],
) -> (Vec3, Vec3) {
    let (mut low, mut high) = if moving_box.0.is_finite() {
        moving_box
    } else {
        box_about(floors)
    };
    for i in 0..scene.orbits.len() {
        let reach = orbit_reach(scene, i);
        low = low.min(-reach);
        high = high.max(reach);
    }
    let size = (high - low).length();
    for wall in walls {
        // Walls may be very high; only where they stand is of interest.
        let foot = DVec3::new(f64::from(wall.centre.x), low.y, f64::from(wall.centre.z));
        low = low.min(foot);
        high = high.max(foot);
    }
    if !walls.is_empty() {
        // What falls into a box is of interest where it lands, not where it hangs.
        let across = (high.x - low.x).max(high.z - low.z);
        high.y = high.y.min(low.y + HIGHEST * across);
    }
    for floor in floors {
        let (floor_low, floor_high) = box_about(&[floor]);
        let is_small = (floor_high - floor_low).length() < 4.0 * size;
        if is_small && walls.is_empty() {
            low = low.min(DVec3::new(floor_low.x, floor_high.y, floor_low.z));
            high = high.max(floor_high);
        } else if floor_high.y > low.y - 100.0 * size {
            low.y = low.y.min(floor_high.y);
        }
    }
    if low.is_finite() && high.is_finite() {
        (low.as_vec3(), high.as_vec3())
    } else {
        (Vec3::NEG_ONE, Vec3::ONE)
    }
}

/// How high the box to see is at most beside its width, where walls stand around.
const HIGHEST: f64 = 2.5;

/// How long bodies that nothing holds or pulls down are followed, s.
const FREE_FLIGHT: f64 = 2.5;

/// The box about the moving bodies; in free space about where they fly to as well.
pub fn paths_box(scene: &Scene, moving: &[&Body]) -> (DVec3, DVec3) {
    let (mut low, mut high) = box_about(moving);
    if scene.gravity == DVec3::ZERO && scene.orbits.is_empty() && scene.forces.is_empty() {
        let all: Vec<&Body> = scene.bodies.iter().collect();
        let (all_low, all_high) = box_about(&all);
        let furthest = (all_high - all_low).length();
        for body in moving {
            let flight = FREE_FLIGHT * body.linear_velocity;
            let end = body.position + flight.clamp_length_max(furthest);
            low = low.min(end);
            high = high.max(end);
        }
    }
    (low, high)
}

/// How far from the world's origin an orbit may carry its body along each axis, m: its own
/// radius and those of the orbits that it is nested in.
fn orbit_reach(scene: &Scene, i: usize) -> DVec3 {
    let mut reach = DVec3::ZERO;
    let mut next = Some(i);
    // An orbit is nested in at most all others.
    for _ in 0..scene.orbits.len() {
        let Some(orbit) = next.map(|i| scene.orbits[i]) else {
            break;
        };
        reach += orbit.radius * DVec3::new(1.0, orbit.tilt.sin().abs(), 1.0);
        next = scene
            .orbits
            .iter()
            .position(|outer| Some(outer.body) == orbit.parent);
    }
    reach
}

/// Lower and upper corner of the box about these bodies; infinite about none.
pub fn box_about(bodies: &[&Body]) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    bodies.iter().fold(empty, |(low, high), body| {
        let reach = reach(body);
        (
            low.min(body.position - reach),
            high.max(body.position + reach),
        )
    })
}

/// How far a body reaches along each axis of the world, m.
pub fn reach(body: &Body) -> DVec3 {
    let axes = DMat3::from_quat(body.orientation);
    match body.shape {
        Shape::Box { half_extents } => {
            let reach_along = |axis: usize| axes.col(axis).abs() * half_extents[axis];
            reach_along(0) + reach_along(1) + reach_along(2)
        }
        _ => DVec3::splat(body.shape.bounding_radius()),
    }
}
