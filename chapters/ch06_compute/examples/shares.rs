//! How many shares of its mass should a body have? A ball is held by others all around it, in a ring, and
//! each presses on it. It gets a nudge; then all contacts mend their impulses at once, again and again. With
//! too few shares each pass makes it worse. The answer to an exercise of the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example shares -- [BALLS IN THE RING]`

use ch00_maths::f32::real::{cos, sin};
use ch06_compute::own_row::contact::{Before, Contact, Impulses, Surface, solve_pair, touching};
use ch06_compute::own_row::side::Side;
use ch06_compute::rows::{Manifold, ROUND, Step};
use ch06_compute::simd::Quat;
use glam::Vec3;

/// Of all balls, m.
const RADIUS: f32 = 0.5;
/// Of the ball in the middle, kg.
const MASS: f32 = 1.0;
/// What each contact presses with at first, N s.
const PRESSED: f32 = 1.0;
/// The nudge, m/s.
const NUDGE: f32 = 1e-3;
const PASSES: usize = 5;

fn main() {
    let ring: usize = std::env::args()
        .nth(1)
        .map_or(8, |count| count.parse().expect("a number of balls"));
    println!("a ball in a ring of {ring}, nudged by 1 mm/s; its speed after each pass, mm/s");
    println!("shares  a pass leaves{}", heads());
    for shares in [ring, 3 * ring / 4, ring / 2, ring / 4, 1] {
        let theory = 1.0 - ring as f32 / (2.0 * shares as f32);
        let speeds = passes(ring, shares as f32);
        let speeds: String = speeds.into_iter().map(millimetres).collect();
        println!("{shares:>6}{theory:>15.3}{speeds}");
    }
}

/// A speed to a thousandth of a millimetre a second, and nothing as 0, not as −0.
fn millimetres(speed: f32) -> String {
    let rounded = (1e6 * speed).round() / 1e3;
    format!("{:>9.3}", if rounded == 0.0 { 0.0 } else { rounded })
}

fn heads() -> String {
    let heads: Vec<_> = (1..=PASSES).map(|pass| format!("{pass:>9}")).collect();
    heads.concat()
}

// ANCHOR: passes
/// The ball's speed along the nudge after each pass, m/s.
fn passes(ring: usize, shares: f32) -> Vec<f32> {
    let step = Step {
        h: 1.0,
        impact_speed: f32::INFINITY,
        ..Step::default()
    };
    let manifold = Manifold {
        turns: ROUND,
        round_a: RADIUS,
        round_b: RADIUS,
        points: 1,
        ..Manifold::default()
    };
    let contact = Contact::<f32, 1>::of(|_| &manifold);
    let mut impulses = vec![pressed(PRESSED); ring];
    let mut velocity = NUDGE * Vec3::X;
    let pass = |_| {
        let before = velocity;
        for (k, impulse) in impulses.iter_mut().enumerate() {
            let old = *impulse;
            let sides = [middle(before, shares), around(k, ring)];
            // The impulse is mended in place; what bodies would gather isn't needed here.
            let _ = solve_pair(
                &touching(&contact, &sides[0], &sides[1]),
                &Surface::default(),
                impulse,
                &mut [0.0],
                sides,
                || [Before::default(); 2],
                &step,
            );
            let change = impulse.normal[0] - old.normal[0];
            velocity -= direction(k, ring) * (change / MASS);
        }
        velocity.x
    };
    (0..PASSES).map(pass).collect()
}
// ANCHOR_END: passes

fn pressed(normal: f32) -> Impulses<f32, 1> {
    Impulses {
        normal: [normal],
        ..Impulses::default()
    }
}

/// Where ball k of the ring is, as a unit vector.
fn direction(k: usize, ring: usize) -> Vec3 {
    let angle = std::f32::consts::TAU * (k as f32 + 0.5) / ring as f32;
    Vec3::new(cos(angle), sin(angle), 0.0)
}

/// The ball in the middle.
fn middle(velocity: Vec3, shares: f32) -> Side<f32> {
    Side {
        velocity: velocity.into(),
        inverse_mass: 1.0 / MASS,
        shared_mass: shares / MASS,
        ..at(Vec3::ZERO)
    }
}

/// A ball of the ring, which nothing moves.
fn around(k: usize, ring: usize) -> Side<f32> {
    at(2.0 * RADIUS * direction(k, ring))
}

fn at(position: Vec3) -> Side<f32> {
    Side {
        position: position.into(),
        attitude: Quat::identity(),
        ..Side::default()
    }
}
