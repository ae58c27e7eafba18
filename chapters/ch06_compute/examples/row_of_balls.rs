//! A row of balls that touch, hit at both ends: contacts that all mend their impulses at once, with their
//! shares of the masses, against contacts that do so one after the other. Nothing is gained or lost on the
//! way. The answer to an exercise of the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example row_of_balls`

use std::f64::consts::PI;

use ch06_compute::own_row::body::Gathered;
use ch06_compute::own_row::contact::{Before, Contact, Impulses, Surface, solve_pair, touching};
use ch06_compute::own_row::side::Side;
use ch06_compute::rows::{Manifold, Press, ROUND, Step};
use ch06_compute::simd::Quat;
use glam::Vec3;

/// Of all balls, m.
const RADIUS: f32 = 0.5;
/// How many.
const BALLS: usize = 10;
/// How fast the two at the ends come, m/s; each has 1 kg.
const HITS: [f32; 2] = [2.0, -1.0];
/// After so many passes the row is looked at.
const SHOWN: [usize; 7] = [0, 1, 2, 10, 50, 100, 200];

fn main() {
    println!("{BALLS} balls of 1 kg in a row; in the end all have 0.1 m/s");
    println!("        all at once                          one after the other");
    println!("passes  momentum    energy     furthest off  furthest off   (kg m/s, J, m/s)");
    let (mut rows, mut sweeps) = (Row::new(), Row::new());
    let (mut left, mut left_by_sweeps) = (0.0, 0.0);
    for pass in 0..=SHOWN[SHOWN.len() - 1] {
        if SHOWN.contains(&pass) {
            println!(
                "{pass:>6}{:>10.6}{:>12.8}{:>14.1e}{:>14.1e}",
                rows.momentum(),
                rows.energy(),
                rows.off(),
                sweeps.off()
            );
        }
        let before = (rows.off(), sweeps.off());
        rows.pass();
        sweeps.sweep();
        // Late enough for the slowest error to be alone, early enough for rounding not to matter.
        if pass == 30 {
            left_by_sweeps = sweeps.off() / before.1;
        }
        if pass == 100 {
            left = rows.off() / before.0;
        }
    }
    let angle = PI / BALLS as f64;
    println!(
        "a pass leaves {left:.3}, by theory {:.3}",
        (0.5 * angle).cos().powi(2)
    );
    println!(
        "a sweep leaves {left_by_sweeps:.3}, by theory {:.3}",
        angle.cos().powi(2)
    );
}

/// The balls' velocities, and what is pressed between each and the next.
struct Row {
    velocities: Vec<f32>,
    impulses: Vec<Impulses<f32, 1>>,
}

impl Row {
    fn new() -> Self {
        let mut velocities = vec![0.0; BALLS];
        [velocities[0], velocities[BALLS - 1]] = HITS;
        Self {
            velocities,
            impulses: vec![Impulses::default(); BALLS - 1],
        }
    }

    // ANCHOR: pass
    /// All contacts at once: each reads two balls and writes its impulse; then each ball gathers.
    fn pass(&mut self) {
        let old = self.impulses.clone();
        for k in 0..self.impulses.len() {
            let sides = [k, k + 1].map(|ball| self.side(ball, shares(ball)));
            mend(&mut self.impulses[k], sides);
        }
        for ball in 0..BALLS {
            let mut sum = Gathered::default();
            for (k, is_b) in [(ball.wrapping_sub(1), true), (ball, false)] {
                if let (Some(new), Some(old)) = (self.impulses.get(k), old.get(k)) {
                    sum.add(
                        &Press {
                            linear: (new.normal[0] - old.normal[0]) * Vec3::X,
                            ..Default::default()
                        },
                        is_b,
                    );
                }
            }
            self.velocities[ball] += sum.held.linear.x;
        }
    }

    /// One after the other: each contact with the whole masses, from what those before it left.
    fn sweep(&mut self) {
        for k in 0..self.impulses.len() {
            let old = self.impulses[k].normal[0];
            let sides = [k, k + 1].map(|ball| self.side(ball, 1.0));
            mend(&mut self.impulses[k], sides);
            let change = self.impulses[k].normal[0] - old;
            self.velocities[k] -= change;
            self.velocities[k + 1] += change;
        }
    }
    // ANCHOR_END: pass

    fn side(&self, ball: usize, shares: f32) -> Side<f32> {
        Side {
            position: (2.0 * RADIUS * ball as f32 * Vec3::X).into(),
            attitude: Quat::identity(),
            velocity: (self.velocities[ball] * Vec3::X).into(),
            inverse_mass: 1.0,
            shared_mass: shares,
            ..Side::default()
        }
    }

    fn momentum(&self) -> f64 {
        self.velocities.iter().map(|&v| f64::from(v)).sum()
    }

    fn energy(&self) -> f64 {
        let energies = self.velocities.iter().map(|&v| 0.5 * f64::from(v).powi(2));
        energies.sum()
    }

    /// How far the speed of a ball is from what it will be in the end, at most.
    fn off(&self) -> f64 {
        let end = f64::from(HITS[0] + HITS[1]) / BALLS as f64;
        let off = self.velocities.iter().map(|&v| (f64::from(v) - end).abs());
        off.fold(0.0, f64::max)
    }
}

/// Among how many contacts a ball's mass is shared.
fn shares(ball: usize) -> f32 {
    if ball == 0 || ball == BALLS - 1 {
        1.0
    } else {
        2.0
    }
}

fn mend(impulse: &mut Impulses<f32, 1>, sides: [Side<f32>; 2]) {
    let manifold = Manifold {
        turns: ROUND,
        round_a: RADIUS,
        round_b: RADIUS,
        points: 1,
        ..Manifold::default()
    };
    let contact = Contact::<f32, 1>::of(|_| &manifold);
    let step = Step {
        h: 1.0,
        impact_speed: f32::INFINITY,
        ..Step::default()
    };
    // What the bodies gather is the change, which the callers take from the impulse itself.
    let _ = solve_pair(
        &touching(&contact, &sides[0], &sides[1]),
        &Surface::default(),
        impulse,
        &mut [0.0],
        sides,
        || [Before::default(); 2],
        &step,
    );
}
