//! Scenario 24: a ragdoll before it touches anything.

use ch00_scenes::builtin::ragdolls::{BONES, body};
use ch00_scenes::measures::Conserved;
use ch00_scenes::{Joint, Scene, State};
use glam::DVec3;

use crate::{built_in, excess, near, separation, watch};

/// A ragdoll in the air, every bone of it thrown another way: the limbs strain at their pins and run
/// into their limits.
fn thrown_ragdoll() -> Scene {
    let mut scene = built_in("ragdolls", Some(1));
    // In the void.
    scene.drag = 0.0;
    scene.bodies.drain(..body(0, 0));
    for joint in &mut scene.joints {
        if let Joint::Ball { a, b, .. } = joint {
            *a -= body(0, 0);
            *b -= body(0, 0);
        }
    }
    scene.meta.clear();
    let middle = centre_of_mass(&scene, &State::start_of(&scene));
    let spin = DVec3::new(1.5, 0.5, -1.0);
    for (i, bone) in scene.bodies.iter_mut().enumerate() {
        let k = i as f64;
        bone.position -= middle;
        bone.linear_velocity = spin.cross(bone.position);
        bone.angular_velocity = spin + 3.0 * DVec3::new(k.sin(), (2.0 * k).cos(), (3.0 * k).sin());
    }
    scene
}

fn centre_of_mass(scene: &Scene, state: &State) -> DVec3 {
    let mass: f64 = scene.bodies.iter().map(|body| body.mass).sum();
    let sum: DVec3 = scene
        .bodies
        .iter()
        .zip(&state.position)
        .map(|(body, p)| body.mass * *p)
        .sum();
    sum / mass
}

#[test]
fn a_ragdoll_in_the_air_falls_as_a_stone_does() {
    let mut scene = thrown_ragdoll();
    // A step that an f32 holds exactly.
    scene.dt = 1.0 / 64.0;
    assert_eq!(scene.bodies.len(), BONES.len());
    let mass: f64 = scene.bodies.iter().map(|body| body.mass).sum();
    let start = Conserved::of(&scene, &State::start_of(&scene));
    let v0 = start.momentum / mass;
    let turning = |c: &Conserved, x: DVec3| c.angular_momentum - x.cross(c.momentum);
    watch(&scene, 64, |step, state| {
        let t = f64::from(step) * scene.dt;
        let x = centre_of_mass(&scene, state);
        let now = Conserved::of(&scene, state);
        // Rounding: half an ulp of 5 m, 2.4e-7 m, a step, and what it makes of a velocity.
        near(x.distance(v0 * t + 0.5 * scene.gravity * t * t), 0.0, 5e-5);
        let v = v0 + scene.gravity * t;
        near(now.momentum.distance(mass * v) / mass, 0.0, 3e-4);
        // Of 23 N m s; of second order in the step.
        let left = turning(&now, x).distance(turning(&start, DVec3::ZERO));
        near(left / start.angular_momentum.length(), 0.0, 2e-3);
        assert!(separation(&scene, state) <= 2e-5 && excess(&scene, state) <= 2e-5);
    });
}
