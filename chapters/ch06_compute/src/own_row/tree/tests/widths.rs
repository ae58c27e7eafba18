//! As many lanes as you like, on as many threads: the bits are those of one.

use ch00_scenes::{EulerLimits, State, builtin};

use super::world::WorldOf;
use super::*;
use crate::simd::{Eight, Four};

/// Eleven ragdolls whose bones are thrown about so that they run into their limits, every second one with
/// a knee of pitch, yaw and roll; and a chain, a door and a cradle, of whose shapes there are few.
fn menagerie() -> Scene {
    let mut scene = Scene::new("menagerie");
    let mut random = SplitMix64::new(3);
    for (name, count) in [
        ("ragdolls", Some(11)),
        ("chain", Some(7)),
        ("door", None),
        ("cradle", None),
    ] {
        let part = builtin::build(name, count, None).expect("a built-in scene");
        let first = scene.bodies.len();
        scene.bodies.extend(part.bodies);
        scene
            .joints
            .extend(part.joints.into_iter().map(|mut joint| {
                let (Joint::Ball { a, b, .. }
                | Joint::Hinge { a, b, .. }
                | Joint::Distance { a, b, .. }) = &mut joint;
                *a += first;
                *b += first;
                joint
            }));
    }
    for joint in scene.joints.iter_mut().skip(5).step_by(23) {
        if let Joint::Ball { limits, .. } = joint {
            let range = [-0.3, 0.2];
            let (pitch, yaw, roll) = (range, [0.0, 0.0], range);
            *limits = Some(EulerLimits { pitch, yaw, roll });
        }
    }
    for body in scene.bodies.iter_mut().filter(|body| !body.is_static()) {
        body.angular_velocity = random.vector(6.0);
    }
    scene
}

/// Where all are after a while, and what the joints hold them with.
fn run<R: Real>(threads: usize) -> (State, Vec<Held>) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().expect("threads").install(|| {
        let mut world = WorldOf::<R>::of(&menagerie(), 8);
        for _ in 0..30 {
            world.step();
        }
        (world.state(), world.joined)
    })
}

#[test]
fn one_lane_and_four_and_eight_on_any_threads_have_the_same_bits() {
    let one = run::<f32>(1);
    assert_eq!(one.0.not_finite(), 0);
    assert!(one == run::<f32>(3), "one lane on three threads");
    assert!(one == run::<Four>(1), "four lanes");
    assert!(one == run::<Eight>(1), "eight lanes");
    assert!(one == run::<Eight>(2), "eight lanes on two threads");
}

#[test]
fn trees_of_one_shape_share_batches_and_their_bodies_sit_there() {
    let scene = menagerie();
    let world = WorldOf::<Eight>::of(&scene, 8);
    // Eight ragdolls and three single ones, a chain, a door, five balls of a cradle.
    assert_eq!(world.batches.count(), 7);
    let sitting = (0..scene.bodies.len()).filter(|&row| world.batches.at(row).is_some());
    assert_eq!(sitting.count(), 11 * 12 + 8 + 1 + 5);
}
