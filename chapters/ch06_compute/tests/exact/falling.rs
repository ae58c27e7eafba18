//! Points that fall: scenarios 1 to 3, and drag.

use glam::DVec3;

use super::{G, after, ball, exact, near, vector, weightless};
use ch00_scenes::{Scene, State};

/// The parabola after 2 s with these steps, from (0, 10, 0) m at (5, 8, 0) m/s.
fn thrown(steps: impl IntoIterator<Item = f64>) -> State {
    let mut scene = Scene::new("thrown");
    scene.bodies.push(ball(0.1, 1.0, DVec3::Y * 10.0));
    scene.bodies[0].linear_velocity = DVec3::new(5.0, 8.0, 0.0);
    let mut engine = super::load(&scene, super::SUBSTEPS);
    for dt in steps {
        engine.step(dt as f32);
    }
    let mut state = State::default();
    engine.read_state(&mut state);
    state
}

/// What f32 may add in 2 s: 1200 substeps round a position of 10 m by ½ ulp, 4.8e-7 m, each, and a
/// velocity of 12 m/s by as much, which stays for 1 s on average.
const ROUNDING: f64 = 1200.0 * 4.8e-7 * 2.0;

#[test]
fn a_thrown_ball_follows_its_parabola() {
    let end = vector(&exact("01_verlet_startup")["end_position"]);
    let state = thrown([1.0 / 60.0; 120]);
    near(state.position[0].distance(end), 0.0, ROUNDING);
    let velocity = DVec3::new(5.0, 8.0 - 2.0 * G, 0.0);
    near(state.linear_velocity[0].distance(velocity), 0.0, ROUNDING);
}

#[test]
fn steps_of_uneven_length_end_at_the_same_place() {
    let alternating = (0..80).map(|step| [1.0 / 60.0, 1.0 / 30.0][step % 2]);
    let end = vector(&exact("02_variable_dt_alternating")["end_position"]);
    let state = thrown(alternating);
    near(state.position[0].distance(end), 0.0, ROUNDING);
    let hitch = (0..115).map(|step| if step == 60 { 0.1 } else { 1.0 / 60.0 });
    let end = vector(&exact("02_variable_dt_hitch")["end_position"]);
    near(thrown(hitch).position[0].distance(end), 0.0, ROUNDING);
}

#[test]
fn a_ball_falls_from_where_positions_alone_would_stand_still() {
    // Scenario 3: with ten substeps and no velocities it would never leave 1000 m.
    for height in [200.0, 1000.0, 4000.0] {
        let mut scene = Scene::new("high up");
        scene.bodies.push(ball(0.1, 1.0, DVec3::Y * height));
        let fallen = height - after(&scene, 1.0).position[0].y;
        // A substep is rounded by at most ½ ulp: 600 of 1.2e-4 m at 4000 m.
        let ulp = 2.0_f64.powi(height.log2().floor() as i32 - 23);
        near(fallen, 0.5 * G, 600.0 * 0.5 * ulp + 1e-4);
    }
}

#[test]
fn drag_slows_a_ball_as_the_exponential_does() {
    let mut scene = weightless("drag");
    scene.drag = 0.25;
    scene.bodies.push(ball(0.5, 1.0, DVec3::ZERO));
    scene.bodies[0].linear_velocity = DVec3::X;
    scene.bodies[0].angular_velocity = DVec3::Y;
    let state = after(&scene, 4.0);
    let left = (-1.0_f64).exp();
    // 2400 factors, each rounded by 6e-8.
    near(state.linear_velocity[0].x, left, 1.5e-4);
    near(state.angular_velocity[0].y, left, 1.5e-4);
}
