//! Limits.

use std::f64::consts::PI;

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Body, Joint, Scene, Shape, State};
use glam::DVec3;

use crate::{excess, hook, watch};

/// An upper arm on a joint at the origin, without weight, that turns about it with ω.
fn limb(cone: Option<f64>, twist: Option<[f64; 2]>, omega: DVec3) -> Scene {
    let mut scene = Scene::new("limb");
    scene.gravity = DVec3::ZERO;
    let shape = Shape::Capsule {
        radius: 0.05,
        half_height: 0.11,
    };
    let arm = DVec3::NEG_Y * 0.16;
    scene.bodies = vec![
        hook(DVec3::ZERO),
        Body {
            angular_velocity: omega,
            linear_velocity: omega.cross(arm),
            ..Body::new(shape, 2.0, arm)
        },
    ];
    scene.joints = vec![Joint::Ball {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: -arm,
        cone,
        twist,
        limits: None,
        rest: None,
    }];
    scene
}

/// The largest excess over the limits, rad, and the largest energy over its start, in two seconds.
fn thrown(scene: &Scene) -> (f64, f64) {
    let energy = |state: &State| Conserved::of(scene, state).kinetic_energy;
    let start = energy(&State::start_of(scene));
    let (mut beyond, mut most) = (0.0_f64, 0.0_f64);
    watch(scene, 120, |_, state| {
        beyond = beyond.max(excess(scene, state));
        most = most.max(energy(state) / start);
    });
    (beyond, most)
}

#[test]
fn a_limb_that_is_thrown_against_its_cone_stops_within_it() {
    for omega in [
        DVec3::new(3.0, 0.0, 2.0),
        DVec3::new(30.0, 0.0, 20.0),
        DVec3::new(5.0, 4.0, -3.0),
        DVec3::new(15.0, 14.0, -13.0),
    ] {
        for twist in [None, Some([-0.3, 0.3])] {
            let (beyond, most) = thrown(&limb(Some(1.0), twist, omega));
            // An angle of 1e-5 rad counts as none; a limit takes energy and gives none.
            assert!(beyond <= 2e-5 && most <= 1.001, "{omega}: {beyond} {most}");
        }
    }
}

#[test]
fn a_cone_just_under_pi_is_a_limit_like_any_other() {
    for omega in [DVec3::new(6.0, 1.0, 0.0), DVec3::new(30.0, 2.0, 10.0)] {
        for twist in [None, Some([-0.3, 0.3])] {
            let (beyond, most) = thrown(&limb(Some(PI - 1e-3), twist, omega));
            assert!(beyond <= 2e-5 && most <= 1.005, "{omega}: {beyond} {most}");
        }
    }
}

#[test]
fn a_limb_may_swing_through_the_singular_direction() {
    for omega in [
        DVec3::X * 15.0,
        DVec3::new(15.0, 0.1, 0.05),
        DVec3::new(15.0, 1.0, 0.0),
    ] {
        // No cone: once round in less than half a second, past where the twist has no value.
        let (_, most) = thrown(&limb(None, Some([-0.3, 0.3]), omega));
        assert!(most <= 1.01, "{omega}: {most}");
    }
}
