//! Bar magnets that meet: eight bars of three shapes lie on a smooth table, pull each other
//! round and in, and hold together in a chain or a ring.
//!
//! What to watch: a bar turns before it slides, since the near poles pull hardest; then two snap
//! together, north to south, and take the next one in. The contacts carry what the poles pull.

use glam::{DQuat, DVec3};

use super::parts::{floor, of_one_stuff, poles_of};
use crate::{Body, Force, Scene, Shape};

/// Strength of a pole, √(N m²): two of them at 0.5 m pull with 2.5 N.
const STRENGTH: f64 = 0.8;
/// Softening length, m: two poles pull with 32 N at most where bars lie end to end.
const SOFTENING: f64 = 0.1;
/// From the middle of a bar to its ends, and to its poles, m.
const HALF_LENGTH: f64 = 0.3;
const POLE: f64 = 0.25;
/// From its axis to its side, m.
const RADIUS: f64 = 0.06;
/// Places on the table, m, and how each bar lies, rad about the vertical.
const BARS: [[f64; 3]; 8] = [
    [-0.9, -0.6, 0.2],
    [-0.1, -0.8, 1.9],
    [0.8, -0.5, -0.7],
    [-1.0, 0.3, -1.4],
    [-0.2, 0.1, 0.5],
    [0.7, 0.3, 2.6],
    [-0.5, 0.9, -2.3],
    [0.5, 1.0, 1.1],
];

/// The scene: body 0 is the table, bar i is body i + 1; its poles are 2 i (north, on its +y side)
/// and 2 i + 1.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("magnets_on_a_table");
    scene.bodies = vec![floor(3.0, 3.0)];
    scene.bodies.extend((0..BARS.len()).map(bar));
    of_one_stuff(&mut scene.bodies, 0.1, 0.1);
    let poles = (1..scene.bodies.len())
        .flat_map(|body| poles_of(body, POLE, STRENGTH))
        .collect();
    scene.forces.push(Force::Magnets {
        poles,
        softening: SOFTENING,
    });
    scene
}

/// Capsules, boxes and cylinders by turns, lying down.
fn bar(i: usize) -> Body {
    let [x, z, turn] = BARS[i];
    let shape = match i % 3 {
        0 => Shape::Capsule {
            radius: RADIUS,
            half_height: HALF_LENGTH - RADIUS,
        },
        1 => Shape::Box {
            half_extents: DVec3::new(RADIUS, HALF_LENGTH, RADIUS),
        },
        _ => Shape::Cylinder {
            radius: RADIUS,
            half_height: HALF_LENGTH,
        },
    };
    let lying = DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2);
    Body {
        orientation: DQuat::from_rotation_y(turn) * lying,
        ..Body::new(shape, 1.0, DVec3::new(x, RADIUS, z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::Penetration;

    #[test]
    fn the_bars_lie_on_the_table_and_start_apart() {
        let scene = build();
        for body in &scene.bodies[1..] {
            assert!((body.orientation * DVec3::Y).y.abs() < 1e-12);
        }
        let found = Penetration::of(&scene, &State::start_of(&scene));
        assert!(found.deepest < 1e-12, "{found:?}");
    }
}
