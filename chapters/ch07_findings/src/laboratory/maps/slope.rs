//! 14: where a ball on a slope rolls, and where it slips: it rolls while tan θ ≤ 7μ/2.

use super::{Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::lab::Moment;
use crate::laboratory::scenario::{Verdict, Watch, timed};
use crate::laboratory::scenarios::{G, rolling};

/// 1/s.
const RATE: u32 = 240;

pub const MAP: Map = Map {
    number: "14a",
    name: "slope",
    title: "Which balls roll down a slope, and which slip",
    value: "share of the speed after 1 s that slips over the slope",
    axes: || [Axis::linear("friction μ"), Axis::linear("slope (°)")],
    grid: |quick| {
        let frictions = (1..=12).map(|k| 0.05 * f64::from(k));
        let slopes = (0..16).map(|k| 2.5 + 5.0 * f64::from(k));
        [frictions.collect(), slopes.collect()].map(|all| thinned(all, quick))
    },
    bounds: [0.01, 2.0],
    classes: ["rolls", "slips", "way or spin is off by more than 1 %"],
    better_upwards: false,
    theory: "tan θ = 7μ/2",
    who: || {
        let names = [
            "printed",
            "corrected",
            "own-row",
            "coloured",
            "sequential-impulses",
            "soft-step",
            "xpbd",
            "rapier",
            "rapier tuned",
        ];
        let law = |who: Who| who.law(Class::Held, steepest);
        Who::all(names).map(law).collect()
    },
    scene: |friction, slope, _| {
        Ok(timed(
            rolling::scene(slope.to_radians(), friction),
            RATE,
            1.0,
        ))
    },
    watcher: |_, friction, slope| {
        Box::new(Slip {
            friction,
            slope: slope.to_radians(),
            verdict: Verdict::failed("short"),
        })
    },
};

/// The steepest slope that a ball rolls down, degrees.
fn steepest(friction: f64) -> f64 {
    (3.5 * friction).atan().to_degrees()
}

/// Looks at the last step: how much of the speed slips. A way or a spin that is wrong is a failure.
struct Slip {
    friction: f64,
    /// rad.
    slope: f64,
    verdict: Verdict,
}

impl Slip {
    /// The way, m, and the spin, rad/s, after a time, s.
    fn exact(&self, time: f64) -> (f64, f64) {
        let (sin, cos) = self.slope.sin_cos();
        let rolls = sin <= 3.5 * self.friction * cos;
        let (a, alpha) = if rolls {
            (5.0 / 7.0 * G * sin, 5.0 / 7.0 * G * sin / rolling::RADIUS)
        } else {
            let turns = 2.5 * self.friction * G * cos / rolling::RADIUS;
            (G * (sin - self.friction * cos), turns)
        };
        (0.5 * a * time * time, alpha * time)
    }
}

impl Watch for Slip {
    fn see(&mut self, now: &Moment) {
        let (way, spin) = self.exact(now.time);
        let state = now.state;
        let (x, v) = (state.position[1].x, state.linear_velocity[1].x);
        let turns = -state.angular_velocity[1].z;
        let share = (v - rolling::RADIUS * turns).abs() / v.abs();
        let off = (x / way - 1.0).abs().max((turns / spin - 1.0).abs());
        self.verdict = if off <= 0.01 {
            Verdict::of(share)
        } else {
            Verdict {
                error: share,
                failed: Some("wrong"),
            }
        };
    }

    fn verdict(&self) -> Verdict {
        self.verdict
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_spins_and_the_steepest_slopes_are_those_of_the_reference() {
        let exact = |friction, degrees: f64| {
            let slope = degrees.to_radians();
            let verdict = Verdict::of(0.0);
            let slip = Slip {
                friction,
                slope,
                verdict,
            };
            slip.exact(1.0)
        };
        let near = |(a, b): (f64, f64), (x, y): (f64, f64)| {
            assert!((a - x).abs() < 1e-8 && (b - y).abs() < 1e-8, "{a} {b}");
        };
        near(exact(0.5, 20.0), (1.198_292_002, 4.793_168_009));
        near(exact(0.3, 60.0), (3.512_104_606, 7.357_5));
        near(
            (steepest(0.5), steepest(0.3)),
            (60.255_118_70, 46.397_181_03),
        );
    }
}
