//! Exercise 2 of chapter 4: pendulums on a pin and on a thread at 60 Hz against the exact period, and
//! what becomes of one that is put back in the wrong direction.
//!
//! `cargo run --release -p ch04_ragdolls --no-default-features --example pendulum_period`

use std::error::Error;
use std::f64::consts::TAU;

use ch00_scenes::{Body, Joint, Scene, Settings, Shape, State};
use glam::{DQuat, DVec2, DVec3};

const G: f64 = 9.81;
const DT: f64 = 1.0 / 60.0;

/// T = 2π √(l/g) / agm(1, cos ½θ₀), s.
fn exact_period(length: f64, theta: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * theta).cos());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    TAU * (length / G).sqrt() / a
}

/// Mean period of ten swings, s, and the largest angle of the last half, rad, of the angles that
/// `next` gives, one a step, from `theta` on.
fn ten_swings(theta: f64, mut next: impl FnMut() -> f64) -> (f64, f64) {
    let (mut crossings, mut last, mut widest, mut amplitude) = (Vec::new(), theta, 0.0_f64, 0.0);
    for step in 1..100_000 {
        let angle = next();
        if last.signum() != angle.signum() {
            crossings.push((f64::from(step) - 1.0 + last / (last - angle)) * DT);
            (amplitude, widest) = (widest, 0.0);
        }
        if crossings.len() == 21 {
            break;
        }
        (last, widest) = (angle, widest.max(angle.abs()));
    }
    ((crossings[20] - crossings[0]) / 10.0, amplitude)
}

/// What a pendulum of the engine hangs on.
#[derive(Clone, Copy)]
enum Hung {
    Pin,
    Thread,
}

/// A body whose centre is `arm` under the origin, drawn aside by `theta`.
fn scene(shape: Shape, arm: f64, hung: Hung, theta: f64) -> Scene {
    let hook = Shape::Box {
        half_extents: DVec3::splat(0.05),
    };
    let orientation = DQuat::from_rotation_z(theta);
    let mut scene = Scene::new("pendulum");
    scene.bodies = vec![
        Body::new(hook, 0.0, DVec3::ZERO),
        Body {
            orientation,
            ..Body::new(shape, 1.0, orientation * DVec3::Y * -arm)
        },
    ];
    scene.joints = vec![match hung {
        Hung::Pin => Joint::pin(0, 1, DVec3::ZERO, DVec3::Y * arm),
        Hung::Thread => Joint::Distance {
            a: 0,
            b: 1,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            length: arm,
        },
    }];
    scene
}

fn by_engine(scene: &Scene, theta: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let mut engine = (ch04_ragdolls::ENGINE.load)(scene, &Settings::defaults())?;
    let mut state = State::default();
    Ok(ten_swings(theta, || {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        let arm = state.position[1];
        arm.x.atan2(-arm.y)
    }))
}

/// A point on a thread of 1 m by Verlet's rule, put back to its distance along a direction that is
/// made of where it was before the step and where the step has led it. f64.
fn by_point(theta: f64, direction: fn(DVec2, DVec2) -> DVec2) -> (f64, f64) {
    let weight = DVec2::new(0.0, -G) * DT * DT;
    let at = |angle: f64| DVec2::new(angle.sin(), -angle.cos());
    let mut p = at(theta);
    // At rest: half of the first step's acceleration, along the circle.
    let mut p_last = at(theta - 0.5 * G * theta.sin() * DT * DT);
    ten_swings(theta, || {
        let free = 2.0 * p - p_last + weight;
        let u = direction(p, free).normalize();
        // The root of |free − λ u| = 1 that is nearer.
        let along = free.dot(u);
        let lambda = along - (along * along - free.length_squared() + 1.0).sqrt();
        (p_last, p) = (p, free - lambda * u);
        p.x.atan2(-p.y)
    })
}

fn row(name: &str, exact: f64, (period, amplitude): (f64, f64)) {
    let error = 100.0 * (period / exact - 1.0);
    println!("  {name:<28} {exact:.4} s  {period:.4} s  {error:+7.3} %  {amplitude:.3} rad");
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("ten swings at 60 Hz            exact     measured  error      swings then to");
    let (ball, length) = (Shape::Sphere { radius: 0.05 }, 1.5);
    let rod = Shape::Box {
        half_extents: DVec3::new(0.02, length / 2.0, 0.02),
    };
    for theta in [0.1, 1.0, 2.0] {
        println!("from {theta:.1} rad");
        let arm = length / 2.0;
        let equal = (rod.inertia(1.0).z + arm * arm) / arm;
        let of_rod = by_engine(&scene(rod, arm, Hung::Pin, theta), theta)?;
        row("rod on a pin", exact_period(equal, theta), of_rod);
        let exact = exact_period(1.0, theta);
        let of_ball = by_engine(&scene(ball, 1.0, Hung::Thread, theta), theta)?;
        row("ball on a thread", exact, of_ball);
        let then = by_point(theta, |before, _| before);
        row("point, put back as it hung", exact, then);
        let now = by_point(theta, |_, after| after);
        row("point, put back as it hangs", exact, now);
    }
    Ok(())
}
