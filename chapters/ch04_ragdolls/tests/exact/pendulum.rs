//! Scenario 9: the pendulum.

use std::f64::consts::TAU;

use ch00_scenes::{Body, Joint, Scene, Shape};
use glam::{DQuat, DVec3};

use crate::{G, hook, near, rod, separation, watch};

/// A pendulum, and the length of a simple one that swings alike, m.
struct Pendulum {
    scene: Scene,
    length: f64,
}

/// A body on a pin at the origin, `arm` above its centre, drawn aside by `theta`.
fn on_a_pin(shape: Shape, arm: f64, theta: f64) -> Pendulum {
    let mut scene = Scene::new("pendulum");
    let tilt = DQuat::from_rotation_z(theta);
    scene.bodies = vec![
        hook(DVec3::ZERO),
        Body {
            orientation: tilt,
            ..Body::new(shape, 1.0, tilt * DVec3::Y * -arm)
        },
    ];
    scene.joints = vec![Joint::pin(0, 1, DVec3::ZERO, DVec3::Y * arm)];
    let about_pin = shape.inertia(1.0).z + arm * arm;
    Pendulum {
        scene,
        length: about_pin / arm,
    }
}

/// A ball on a thread of 1 m, which keeps its centre at its distance and lets it turn.
fn on_a_thread(theta: f64) -> Pendulum {
    let ball = Shape::Sphere { radius: 0.05 };
    let mut scene = on_a_pin(ball, 1.0, theta).scene;
    scene.joints = vec![Joint::Distance {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: DVec3::ZERO,
        length: 1.0,
    }];
    Pendulum { scene, length: 1.0 }
}

/// Three that swing as one of 1 m does, with names.
fn pendulums(theta: f64) -> [(&'static str, Pendulum); 3] {
    let ball = Shape::Sphere { radius: 0.05 };
    [
        ("rod", on_a_pin(rod(1.5, 0.04), 0.75, theta)),
        ("ball", on_a_pin(ball, 1.0, theta)),
        ("thread", on_a_thread(theta)),
    ]
}

/// A box on a pin in its middle's upper face: one that swings as a pendulum of 0.44 m does.
fn short_pendulum(theta: f64, steps_per_second: f64) -> Pendulum {
    let half_extents = DVec3::new(0.3, 0.2, 0.1);
    let mut pendulum = on_a_pin(Shape::Box { half_extents }, 0.3, theta);
    pendulum.scene.dt = 1.0 / steps_per_second;
    pendulum
}

/// Arithmetic-geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// T = 2π √(l/g) / agm(1, cos ½θ₀).
fn exact_period(length: f64, theta: f64) -> f64 {
    TAU * (length / G).sqrt() / agm(1.0, (0.5 * theta).cos())
}

/// What ten swings show.
struct Swings {
    /// Mean of ten, over the exact one.
    period: f64,
    /// Largest angle of the last half swing, rad.
    amplitude: f64,
    /// Largest gap at the pin, or stretch, m.
    stretch: f64,
}

fn swings(pendulum: &Pendulum, theta: f64) -> Swings {
    let Pendulum { scene, length } = pendulum;
    let exact = exact_period(*length, theta);
    let (mut crossings, mut amplitude, mut top) = (Vec::new(), 0.0_f64, 0.0);
    let (mut last, mut stretch) = (theta, 0.0_f64);
    let steps = (10.6 * exact / scene.dt) as u32;
    watch(scene, steps, |step, state| {
        let arm = state.position[1];
        let angle = arm.x.atan2(-arm.y);
        if last.signum() != angle.signum() {
            crossings.push((f64::from(step) - 1.0 + last / (last - angle)) * scene.dt);
            (top, amplitude) = (amplitude, 0.0);
        }
        last = angle;
        amplitude = amplitude.max(angle.abs());
        stretch = stretch.max(separation(scene, state));
    });
    Swings {
        period: (crossings[20] - crossings[0]) / 10.0 / exact,
        amplitude: top,
        stretch,
    }
}

#[test]
fn the_period_of_the_reference_is_that_of_the_formula() {
    for (theta, period) in [
        (0.1, 2.007_321_191),
        (1.0, 2.139_137_601),
        (2.0, 2.665_870_943),
        (3.0, 5.158_066_754),
    ] {
        near(exact_period(1.0, theta), period, 1e-9);
    }
}

#[test]
fn a_pendulum_takes_the_time_that_the_elliptic_integral_says() {
    for theta in [0.1, 1.0, 2.0] {
        for (name, pendulum) in pendulums(theta) {
            let period = swings(&pendulum, theta).period;
            // The reference's bar.
            assert!(
                (period - 1.0).abs() <= 1e-3,
                "{name}, {theta} rad: {period}"
            );
        }
    }
}

#[test]
fn a_pendulum_swings_on_as_wide_as_it_was_drawn_aside() {
    for theta in [0.1, 1.0, 2.0] {
        for (name, pendulum) in pendulums(theta) {
            // What is lost in ten swings at 2 rad; smaller swings lose less.
            let amplitude = swings(&pendulum, theta).amplitude / theta;
            assert!(
                (amplitude - 1.0).abs() <= 3e-3,
                "{name}, {theta} rad: {amplitude}"
            );
        }
    }
}

#[test]
fn a_pendulum_does_not_stretch() {
    for (name, pendulum) in pendulums(2.0) {
        // A gap of 1e-6 m counts as closed, and is measured to the rounding of 1 m.
        let stretch = swings(&pendulum, 2.0).stretch;
        assert!(stretch <= 1.5e-6, "{name}: {stretch}");
    }
}

#[test]
fn a_short_wide_pendulum_keeps_its_period_too() {
    // At 2 rad it turns by 0.14 rad a step. Put back along directions that have turned meanwhile, it
    // would be off by 0.25 %.
    for theta in [0.1, 1.0, 2.0] {
        let off = swings(&short_pendulum(theta, 60.0), theta).period - 1.0;
        assert!(off.abs() <= 1e-3, "{theta} rad: {off}");
    }
}
