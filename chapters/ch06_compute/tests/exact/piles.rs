//! Many bodies in a box: none escapes, none makes energy, none sinks in. Scenario 19.

use ch00_scenes::measures::{Conserved, Measures, escaped};
use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Body, Scene, Shape, State};
use glam::DVec3;

use super::{at_most, ball, built_in, of_one_stuff, watch};

#[test]
fn a_settled_pile_overlaps_by_a_hundredth_of_a_radius() {
    let scene = built_in("pile", Some(1000));
    watch(&scene, 900, |step, state| {
        if step >= 600 && step % 60 == 0 {
            let measures = Measures::of(&scene, state);
            assert_eq!((measures.escaped, measures.not_finite), (Some(0), 0));
            let overlap = measures.penetration.relative;
            at_most(overlap.p99, 0.01, "99 of 100, of a radius");
            at_most(overlap.deepest, 0.05, "the deepest, of a radius");
            let each = measures.conserved.kinetic_energy / 1000.0;
            at_most(each, 1e-2, "J a ball");
        }
    });
}

/// The largest energy over its start, over ten seconds; nobody may leave the box meanwhile.
fn energy_gained(scene: &Scene) -> f64 {
    let energy = |state: &State| Conserved::of(scene, state).energy();
    let start = energy(&State::start_of(scene));
    let mut most = 0.0_f64;
    watch(scene, 600, |step, state| {
        most = most.max(energy(state) / start - 1.0);
        assert_eq!(
            escaped(scene, state),
            Some(0),
            "{}, step {step}",
            scene.name
        );
    });
    most
}

#[test]
fn no_ball_escapes_and_no_energy_is_made() {
    for (count, seed) in [(10, 1), (60, 1), (60, 2), (60, 3), (1000, 1)] {
        let scene = Scene::open("balls", Some(count), Some(seed)).expect("a built-in");
        // Chapter 3's bar.
        at_most(energy_gained(&scene), 1e-3, "energy gained");
    }
}

/// Walls so high that no light ball, shot up by heavy ones as elastic balls do, leaps over them.
fn raise_walls(scene: &mut Scene) {
    for body in &mut scene.bodies {
        if let Shape::Box { half_extents } = &mut body.shape
            && half_extents.y > 1.0
        {
            let foot = body.position.y - half_extents.y;
            half_extents.y = 200.0;
            body.position.y = foot + 200.0;
        }
    }
}

#[test]
fn elastic_balls_make_no_energy_either() {
    for (count, seed, mu) in [(10, 1, 0.0), (60, 1, 0.0), (60, 2, 0.5), (300, 1, 0.0)] {
        let mut scene = Scene::open("balls", Some(count), Some(seed)).expect("a built-in");
        of_one_stuff(&mut scene, 1.0, mu);
        raise_walls(&mut scene);
        at_most(energy_gained(&scene), 1e-3, "energy gained");
    }
}

#[test]
fn a_pile_of_every_shape_comes_to_rest_without_sinking_in() {
    let scene = built_in("mixed", Some(100));
    let measures = Measures::of(&scene, &super::after(&scene, 10.0));
    assert_eq!((measures.escaped, measures.not_finite), (Some(0), 0));
    // Chapter 3's bars.
    at_most(measures.penetration.p99, 0.002, "overlap, m");
    let each = measures.conserved.kinetic_energy / 100.0;
    at_most(each, 1e-2, "J a body");
}

/// Scenario 19: 6 × 6 × 6 balls a centimetre apart, without friction, on an open plane.
fn balls_666() -> Scene {
    let mut scene = Scene::new("666");
    scene.dt = 0.01;
    let half_extents = DVec3::new(100.0, 0.5, 100.0);
    scene.bodies = vec![Body::new(Shape::Box { half_extents }, 0.0, DVec3::Y * -0.5)];
    let mut random = SplitMix64::new(42);
    for i in 0..216 {
        let lattice = [i / 36, i / 6 % 6, i % 6].map(|k| 0.21 * f64::from(k));
        let shift = [0; 3].map(|_| 1e-3 * random.unit());
        // The reference counts z up.
        let [x, y, z] = [0, 1, 2].map(|k| lattice[k] + shift[k]);
        scene
            .bodies
            .push(ball(0.1, 10.0, DVec3::new(x, 0.101 + z, y)));
    }
    of_one_stuff(&mut scene, 0.0, 0.0);
    scene
}

/// Σ overlap² of all pairs, m².
fn squares_of_overlaps(state: &State) -> f64 {
    let places = &state.position[1..];
    let mut sum = 0.0;
    for (i, p) in places.iter().enumerate() {
        sum += (0.1 - p.y).max(0.0).powi(2);
        for q in &places[i + 1..] {
            sum += (0.2 - p.distance(*q)).max(0.0).powi(2);
        }
    }
    sum
}

#[test]
fn frictionless_balls_end_up_in_one_layer_and_never_overlap_much() {
    let scene = balls_666();
    let mut mean = 0.0;
    let mut highest = 0.0_f64;
    watch(&scene, 1000, |step, state| {
        if step > 0 {
            mean += squares_of_overlaps(state) / 1000.0;
        }
        highest = state.position[1..].iter().map(|p| p.y).fold(0.0, f64::max);
    });
    // The best that was published is 0.0152745 m².
    at_most(mean, 0.0152, "mean sum of squares, m²");
    at_most(highest, 0.101, "the highest centre, m");
}
