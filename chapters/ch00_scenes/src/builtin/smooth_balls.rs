//! The balls of `balls` in the same box, without friction and without spin. Nothing ever turns one of
//! them: a place, a velocity, a radius and a mass are all that a body needs.

use glam::DVec3;

use super::balls;
use super::parts::of_one_stuff;
use crate::Scene;

/// The scene with `count` balls.
pub(super) fn build(count: u64, seed: u64) -> Scene {
    let mut scene = balls::build(count, seed);
    "smooth_balls".clone_into(&mut scene.name);
    for body in &mut scene.bodies {
        body.angular_velocity = DVec3::ZERO;
    }
    of_one_stuff(&mut scene.bodies, 0.95, 0.0);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_differ_from_the_balls_in_friction_and_spin_alone() {
        let mut smooth = build(60, 1);
        let rough = balls::build(60, 1);
        assert!(
            smooth
                .bodies
                .iter()
                .all(|body| body.static_friction() == 0.0)
        );
        for (ours, theirs) in smooth.bodies.iter_mut().zip(&rough.bodies) {
            assert_eq!(ours.angular_velocity, DVec3::ZERO);
            ours.angular_velocity = theirs.angular_velocity;
            ours.friction = theirs.friction;
        }
        assert_eq!(smooth.bodies, rough.bodies);
        assert_eq!(smooth.meta, rough.meta);
    }
}
