//! Scenario 10: the hanging chain.

use std::f64::consts::TAU;

use ch00_scenes::{Body, Joint, Scene, State};
use glam::{DQuat, DVec3};

use crate::{G, hook, near, rod, watch};

const LINKS: usize = 10;
const LINK: f64 = 0.1;

/// Frequency of the first mode, rad/s, of thin links of mass 1 with these moments about their
/// middles, and its angles, the largest of them 1.
///
/// With the angles a of the links, ½ ȧ·M ȧ is the kinetic and ½ a·K a the potential energy. K is
/// diagonal, so a ← K⁻¹ M a finds the slowest mode.
fn first_mode(moment: f64) -> (f64, [f64; LINKS]) {
    // How far the middle of link i moves sideways by a unit angle of link j.
    let moves = |i: usize, j: usize| match j.cmp(&i) {
        std::cmp::Ordering::Less => LINK,
        std::cmp::Ordering::Equal => 0.5 * LINK,
        std::cmp::Ordering::Greater => 0.0,
    };
    let m = |j: usize, k: usize| {
        let sum: f64 = (0..LINKS).map(|i| moves(i, j) * moves(i, k)).sum();
        sum + if j == k { moment } else { 0.0 }
    };
    let stiffness = |j: usize| G * (0..LINKS).map(|i| moves(i, j)).sum::<f64>();
    let (mut a, mut size) = ([1.0; LINKS], 0.0);
    for _ in 0..200 {
        let next: [f64; LINKS] =
            std::array::from_fn(|j| (0..LINKS).map(|k| m(j, k) * a[k]).sum::<f64>() / stiffness(j));
        size = next.iter().fold(0.0, |most, x| x.max(most));
        a = next.map(|x| x / size);
    }
    (1.0 / size.sqrt(), a)
}

#[test]
fn the_first_mode_of_thin_rods_is_that_of_the_reference() {
    let (omega, _) = first_mode(LINK * LINK / 12.0);
    near(omega, 3.767_208_518, 1e-8);
}

/// The chain in its first mode, at 0.01 rad, under a hook at the origin; and its frequency.
fn chain_in_first_mode() -> (Scene, f64) {
    let mut scene = Scene::new("chain in its first mode");
    let link = rod(LINK, 0.01);
    let (omega, angles) = first_mode(link.inertia(1.0).z);
    scene.bodies.push(hook(DVec3::ZERO));
    let mut end = DVec3::ZERO;
    for (i, angle) in angles.into_iter().enumerate() {
        let tilt = DQuat::from_rotation_z(0.01 * angle);
        let half = tilt * DVec3::Y * (0.5 * LINK);
        scene.bodies.push(Body {
            orientation: tilt,
            ..Body::new(link, 1.0, end - half)
        });
        end -= 2.0 * half;
        let of_parent = if i == 0 { 0.0 } else { -0.5 * LINK };
        scene.joints.push(Joint::pin(
            i,
            i + 1,
            DVec3::Y * of_parent,
            DVec3::Y * (0.5 * LINK),
        ));
    }
    (scene, omega)
}

/// Where the lower end of the chain is.
fn end_of_chain(state: &State) -> DVec3 {
    state.position[LINKS] + state.orientation[LINKS] * DVec3::Y * (-0.5 * LINK)
}

/// Times at which the chain's end passes the middle, s, and largest stretch, m, after the first half
/// second and before.
fn swings_of_chain(scene: &Scene, seconds: f64) -> (Vec<f64>, f64, f64) {
    let (mut crossings, mut last) = (Vec::new(), 0.0);
    let (mut later, mut at_first) = (0.0_f64, 0.0_f64);
    watch(scene, (seconds / scene.dt) as u32, |step, state| {
        let end = end_of_chain(state);
        if last * end.x < 0.0 {
            crossings.push((f64::from(step) - 1.0 + last / (last - end.x)) * scene.dt);
        }
        last = end.x;
        let stretch = end.length() - LINK * LINKS as f64;
        let largest = if step > 30 { &mut later } else { &mut at_first };
        *largest = largest.max(stretch);
    });
    (crossings, later, at_first)
}

#[test]
fn a_hanging_chain_swings_in_its_first_mode() {
    let (scene, omega) = chain_in_first_mode();
    let exact = TAU / omega;
    let (crossings, stretch, at_first) = swings_of_chain(&scene, 5.6 * exact);
    let period = (crossings[10] - crossings[0]) / 5.0;
    near(period / exact, 1.0, 1e-3);
    // Eleven gaps that are closed to 1e-6 m each.
    assert!(stretch <= 1.1e-5, "{stretch}");
    // The sums begin at zero, and eight sweeps a step carry the weight up to the hook only slowly.
    assert!(at_first <= 5e-3, "{at_first}");
}
