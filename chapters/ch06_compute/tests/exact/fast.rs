//! Fast balls and a thin wall: scenario 23, alone and in company.

use ch00_scenes::{Scene, State};
use glam::DVec3;

use super::{built_in, load, weightless};

/// Balls of each speed, in all phases of a step.
const BALLS: u64 = 50;

/// The scene's balls that are behind the wall in the end.
fn behind(state: &State) -> Vec<usize> {
    let balls = 1..state.len();
    balls.filter(|&row| state.position[row].x > 0.0).collect()
}

fn end_of(scene: &Scene, substeps: u32) -> State {
    let mut engine = load(scene, substeps);
    let mut state = State::default();
    for _ in 0..scene.steps {
        engine.step(scene.dt as f32);
    }
    engine.read_state(&mut state);
    state
}

#[test]
fn no_fast_ball_of_many_passes_a_thin_wall() {
    for substeps in [1, 2, 8, 10] {
        let state = end_of(&built_in("tunnelling", Some(BALLS)), substeps);
        assert_eq!(behind(&state), [0; 0], "with {substeps} substeps");
    }
}

#[test]
fn no_fast_ball_alone_passes_a_thin_wall() {
    let many = built_in("tunnelling", Some(BALLS));
    for substeps in [1, 8, 10] {
        for ball in &many.bodies[1..] {
            let mut scene = weightless("a ball and a wall");
            scene.steps = 20;
            scene.restitution_threshold = Some(0.0);
            scene.bodies = vec![many.bodies[0].clone(), ball.clone()];
            let (state, speed) = (end_of(&scene, substeps), ball.linear_velocity.dot(DVec3::X));
            assert_eq!(behind(&state), [0; 0], "{speed} m/s, {substeps} substeps");
        }
    }
}
