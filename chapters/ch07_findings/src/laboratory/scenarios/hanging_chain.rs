//! 10: ten rods that hang from a pin and swing a little, in the shape that keeps its shape.

use ch00_scenes::{Body, Joint, Scene, Shape};
use glam::{DQuat, DVec3};

use super::swings::Swings;
use super::{G, block};
use crate::laboratory::scenario::{SOME_RATES, Scenario, timed};

const LINKS: usize = 10;
/// Of a link, m.
const LENGTH: f64 = 0.1;
/// Half of a rod's thickness, m.
const THIN: f64 = 5e-4;
/// Of the first shape, s.
const PERIOD: f64 = 1.667_862_365;
/// Of the lowest link, rad.
const AMPLITUDE: f64 = 0.01;

pub const SCENARIO: Scenario = Scenario {
    number: 10,
    name: "hanging_chain",
    title: "A hanging chain of ten rods",
    watch: "A solver that stops too early makes the chain a spring: it gets longer, and swings slower.",
    error: "mean period of small swings",
    unit: "",
    one_percent: 0.01,
    scale: "of the period",
    pass: 0.01,
    fails: "no swing: it never comes back",
    rates: SOME_RATES,
    scenes: |rate, _| Ok(vec![timed(scene(), rate, 4.3 * PERIOD)]),
    watcher: |_| Box::new(Swings::new(PERIOD, |state| state.position[LINKS].x)),
    steps: None,
    page: "ch06_ragdolls",
};

fn scene() -> Scene {
    let mut scene = Scene::new("hanging_chain");
    let mut joint = DVec3::Y * 2.0;
    scene.bodies.push(block(DVec3::splat(0.01), joint));
    let half_extents = DVec3::new(THIN, LENGTH / 2.0, THIN);
    let down = DVec3::NEG_Y * (LENGTH / 2.0);
    for (k, angle) in first_shape().into_iter().enumerate() {
        let orientation = DQuat::from_rotation_z(AMPLITUDE * angle);
        let body = Body::new(Shape::Box { half_extents }, 1.0, joint + orientation * down);
        scene.bodies.push(Body {
            orientation,
            ..body
        });
        let anchor = if k == 0 { DVec3::ZERO } else { down };
        scene.joints.push(Joint::pin(k, k + 1, anchor, -down));
        joint += orientation * down * 2.0;
    }
    scene
}

/// Angles of the first shape, the lowest 1: of ω² M a = g K a by inverse iteration, K being diagonal.
fn first_shape() -> [f64; LINKS] {
    let mut angles = [1.0; LINKS];
    for _ in 0..100 {
        let pushed = inertia_times(&angles);
        for (k, angle) in angles.iter_mut().enumerate() {
            *angle = pushed[k] / (G * LENGTH * ((LINKS - k) as f64 - 0.5));
        }
        let last = angles[LINKS - 1];
        angles = angles.map(|angle| angle / last);
    }
    angles
}

/// M a for rods of 1 kg: the centre of rod k is at Σ l θ_j over those above, and ½ l θ_k.
fn inertia_times(angles: &[f64; LINKS]) -> [f64; LINKS] {
    let arm = |k: usize, j: usize| match j.cmp(&k) {
        std::cmp::Ordering::Less => LENGTH,
        std::cmp::Ordering::Equal => LENGTH / 2.0,
        std::cmp::Ordering::Greater => 0.0,
    };
    let moved: Vec<f64> = (0..LINKS)
        .map(|k| (0..LINKS).map(|j| arm(k, j) * angles[j]).sum())
        .collect();
    std::array::from_fn(|i| {
        let along: f64 = (0..LINKS).map(|k| arm(k, i) * moved[k]).sum();
        along + LENGTH * LENGTH / 12.0 * angles[i]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_shape_has_the_period_of_the_reference() {
        let shape = first_shape();
        let pushed = inertia_times(&shape);
        for k in 0..LINKS {
            let held = G * LENGTH * ((LINKS - k) as f64 - 0.5) * shape[k];
            let omega = (held / pushed[k]).sqrt();
            assert!((omega - 3.767_208_518).abs() < 1e-8, "{omega}");
        }
    }
}
