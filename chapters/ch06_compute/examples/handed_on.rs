//! A ball with e = 0 meets a wall at 10 m/s, and has other contacts besides, which do nothing: so it has
//! several shares. How fast does it leave the wall, if a substep begins with all that the last one pressed,
//! and if impacts are over with their substep? From the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example handed_on`

use ch06_compute::own_row::contact::{Before, Contact, Impulses, Surface, solve_pair, touching};
use ch06_compute::own_row::side::Side;
use ch06_compute::rows::{Manifold, ROUND, Step};
use ch06_compute::rules::IMPACT_SPEED;
use ch06_compute::simd::Quat;
use glam::Vec3;

/// Of both balls, m; the wall is one that nothing moves.
const RADIUS: f32 = 0.5;
/// How fast it comes, m/s; it has 1 kg.
const SPEED: f32 = 10.0;
/// Enough for all to be over.
const SUBSTEPS: u32 = 200;

fn main() {
    println!("shares  all handed on  impacts over with their substep   (m/s away from the wall)");
    for shares in [1, 2, 4, 8] {
        // To a thousandth, and nothing as 0, not as −0.
        let thousandths = |x: f32| (1e3 * x).round() / 1e3 + 0.0;
        let speeds = [f32::INFINITY, IMPACT_SPEED].map(|speed| leaves(shares, speed));
        let [all, over] = speeds.map(thousandths);
        println!("{shares:>6}{all:>15.3}{over:>33.3}");
    }
}

// ANCHOR: leaves
/// How fast the ball leaves, m/s.
fn leaves(shares: u32, impact_speed: f32) -> f32 {
    let step = Step {
        h: 1.0,
        impact_speed,
        ..Step::default()
    };
    let mut velocity = SPEED;
    let mut impulse = Impulses::default();
    let mut held = 0.0;
    for _ in 0..SUBSTEPS {
        let before = Before {
            velocity: (velocity * Vec3::X).into(),
            ..Before::default()
        };
        velocity -= held;
        let sides = [ball(velocity, shares), wall()];
        let given = solve_pair(
            &touching(&contact(), &sides[0], &sides[1]),
            &Surface::default(),
            &mut impulse,
            &mut [0.0],
            sides,
            || [before, Before::default()],
            &step,
        );
        velocity -= given.linear.x - held;
        held = given.stays * given.linear.x;
    }
    -velocity
}
// ANCHOR_END: leaves

fn contact() -> Contact<f32, 1> {
    let manifold = Manifold {
        turns: ROUND,
        round_a: RADIUS,
        round_b: RADIUS,
        points: 1,
        ..Manifold::default()
    };
    Contact::of(|_| &manifold)
}

fn ball(velocity: f32, shares: u32) -> Side<f32> {
    Side {
        velocity: (velocity * Vec3::X).into(),
        inverse_mass: 1.0,
        shared_mass: shares as f32,
        ..wall_at(Vec3::ZERO)
    }
}

fn wall() -> Side<f32> {
    wall_at(2.0 * RADIUS * Vec3::X)
}

fn wall_at(position: Vec3) -> Side<f32> {
    Side {
        position: position.into(),
        attitude: Quat::identity(),
        ..Side::default()
    }
}
