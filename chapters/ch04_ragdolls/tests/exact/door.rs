//! The door.

use ch00_scenes::State;
use glam::DVec3;

use crate::{built_in, excess, near, separation, watch};

/// How far the door is open, rad.
fn opening(state: &State) -> f64 {
    let front = state.orientation[1] * DVec3::X;
    (-front.z).atan2(front.x)
}

/// The angle between the door's upright edge and the line that it turns about, rad.
fn tilt(state: &State) -> f64 {
    let edge = state.orientation[1] * DVec3::Y;
    edge.cross(DVec3::Y).length().atan2(edge.y)
}

#[test]
fn a_door_keeps_its_line_and_its_stops_whatever_hits_it() {
    for name in ["door", "door_pins"] {
        let scene = built_in(name, None);
        watch(&scene, 300, |_, state| {
            // An angle of 1e-5 rad, a gap of 1e-6 m count as closed.
            assert!(tilt(state) <= 5e-5, "{name}: {}", tilt(state));
            assert!(excess(&scene, state) <= 5e-5, "{name}");
            assert!(separation(&scene, state) <= 5e-6, "{name}");
        });
    }
}

#[test]
fn a_door_on_two_pins_swings_as_one_on_a_hinge_does() {
    let angles = |name| {
        let mut angles = Vec::new();
        watch(&built_in(name, None), 300, |_, state| {
            angles.push(opening(state));
        });
        angles
    };
    let (hinge, pins) = (angles("door"), angles("door_pins"));
    // It has been open as far as it goes, and is closed again.
    near(hinge.iter().copied().fold(0.0, f64::max), 2.0, 1e-3);
    near(hinge[300], 0.0, 1e-3);
    for (step, (a, b)) in hinge.iter().zip(&pins).enumerate() {
        assert!((a - b).abs() <= 2e-3, "step {step}: {a} {b}");
    }
}
