//! Scenario 17: the cradle.

use ch00_scenes::{Scene, State};

use crate::{G, built_in, near, watch};

/// Speed that each ball has, or would have, at the bottom of its swing: √(v² + 2 g h).
fn speeds_at_bottom(scene: &Scene, state: &State) -> Vec<f64> {
    (2..7)
        .map(|i| {
            let height = state.position[i].y - scene.bodies[6].position.y;
            let squared = state.linear_velocity[i].length_squared() + 2.0 * G * height;
            squared.max(0.0).sqrt()
        })
        .collect()
}

#[test]
fn a_cradle_hands_its_speed_to_the_last_ball() {
    let scene = built_in("cradle", Some(1));
    watch(&scene, 23, |step, state| {
        if step == 23 {
            for (i, velocity) in state.linear_velocity[2..7].iter().enumerate() {
                near(velocity.x, if i == 4 { 1.0 } else { 0.0 }, 0.01);
            }
        }
    });
}

#[test]
fn two_balls_come_and_two_balls_leave() {
    let scene = built_in("cradle", Some(2));
    watch(&scene, 30, |step, state| {
        if step == 30 {
            let speeds = speeds_at_bottom(&scene, state);
            near(speeds[3], 1.0, 0.01);
            near(speeds[4], 1.0, 0.01);
            // The others rest, but where the overlaps of the impacts have pushed them: up to 24 mm aside.
            assert!(speeds[..3].iter().all(|speed| *speed < 0.12), "{speeds:?}");
        }
    });
}
