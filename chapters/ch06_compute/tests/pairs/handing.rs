//! What is handed to the device and taken from it between steps.

use ch00_scenes::State;
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::forces::Spring;
use ch06_compute::rows::{Drawn, Mouse, Seen};
use glam::Vec3;

use super::{DT, after, built_in, gpu, largest_gap, pairs, read, rules};

#[test]
fn a_state_that_is_taken_over_is_the_state_that_goes_on() {
    let (gpu, scene) = (gpu(), built_in("ragdoll_field", Some(2)));
    let mut one = pairs(&gpu, &scene);
    let half = after(&mut one, 40);
    let mut other = pairs(&gpu, &scene);
    let elsewhere = after(&mut other, 7);
    assert!(largest_gap(&half, &elsewhere) > 0.01);
    other.write(&half).expect("the device is there");
    assert_eq!(read(&mut other).position, half.position);
    let mut lanes = <Lanes>::of(&scene, rules(&scene)).expect("it is supported");
    lanes.write_state(&half);
    for _ in 0..3 {
        lanes.step(DT, |_| ());
    }
    let mut by_lanes = State::default();
    lanes.bodies.read(&mut by_lanes);
    let gap = largest_gap(&after(&mut other, 3), &by_lanes);
    assert!(gap < 1e-5, "{gap} m apart");
}

#[test]
fn the_mouse_pulls_as_it_does_on_the_cpu() {
    let (gpu, scene) = (gpu(), built_in("slide", None));
    let mut pairs = pairs(&gpu, &scene);
    let mut lanes = <Lanes>::of(&scene, rules(&scene)).expect("it is supported");
    let (body, anchor, towards) = (4, Vec3::new(0.1, 0.1, 0.0), Vec3::new(0.0, 2.0, 0.0));
    let mass = scene.bodies[body].mass as f32;
    lanes.forces.mouse = Some(Spring {
        body,
        anchor,
        target: towards,
        mass,
    });
    let mouse = Mouse {
        anchor,
        body: body as u32,
        towards,
        mass,
    };
    pairs.pull(Some(mouse)).expect("the device is there");
    for _ in 0..30 {
        lanes.step(DT, |_| ());
    }
    let mut by_lanes = State::default();
    lanes.bodies.read(&mut by_lanes);
    let state = after(&mut pairs, 30);
    assert!(state.position[body].y > 0.5, "it is lifted");
    let gap = largest_gap(&state, &by_lanes);
    assert!(gap < 1e-4, "{gap} m apart");
    pairs.pull(None).expect("the device is there");
    assert!(after(&mut pairs, 60).position[body].y < state.position[body].y);
}

#[test]
fn what_is_drawn_is_the_state_after_the_last_step_and_before_it() {
    let (gpu, scene) = (gpu(), built_in("slide", None));
    let mut pairs = pairs(&gpu, &scene);
    pairs.draw().expect("there is room");
    let before = after(&mut pairs, 4);
    let now = after(&mut pairs, 1);
    let drawn: Vec<Drawn> = pairs.columns().read("drawn").expect("a column");
    let seen: Vec<Seen> = pairs.columns().read("seen").expect("a column");
    for row in 0..now.len() {
        assert_eq!(drawn[row].position.as_dvec3(), now.position[row]);
        assert_eq!(drawn[row].position_last.as_dvec3(), before.position[row]);
        assert_eq!(seen[row].velocity.as_dvec3(), now.linear_velocity[row]);
    }
}

#[test]
fn a_late_look_at_the_status_finds_steps_that_had_no_room() {
    let (gpu, scene) = (gpu(), built_in("stack", Some(4)));
    let mut pairs = super::tight(&gpu, &scene);
    pairs.step(DT, 3).expect("it runs");
    let status: Vec<u32> = pairs.columns().read("status").expect("a column");
    assert!(
        pairs.take_status(&status).expect("it grows"),
        "none was made"
    );
    let status: Vec<u32> = pairs.columns().read("status").expect("a column");
    assert!(
        !pairs.take_status(&status).expect("all is well"),
        "all were made"
    );
    assert_eq!((pairs.says("STEPS"), pairs.counters().contacts), (3, 4));
}
