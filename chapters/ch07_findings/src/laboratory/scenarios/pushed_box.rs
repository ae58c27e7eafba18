//! 14, set-up B: a wide box is pushed over the ground from under 25 balls, which roll on it.

use ch00_scenes::{Body, Force, Scene, Shape};
use glam::DVec3;

use super::{G, ball, floor};
use crate::lab::Moment;
use crate::laboratory::scenario::{FEW_RATES, Scenario, Verdict, Watch, timed};

/// Balls along an edge, two metres from each other: the last row rolls back by 4.2 m and stays on the box.
const EDGE: u32 = 5;
const RADIUS: f64 = 0.5;
/// Of the box, kg; a ball has one.
const MASS: f64 = 10.0;
const BALLS: f64 = (EDGE * EDGE) as f64;
/// Of the pairs ground and box, box and ball. A pair has the geometric mean of its two.
const FRICTION: [f64; 2] = [0.4, 0.8];
/// N.
const PUSH: f64 = 150.0;
/// s.
const TIME: f64 = 4.0;
/// The box and the first ball, of the scene's bodies.
const WATCHED: [usize; 2] = [1, 2];

pub const SCENARIO: Scenario = Scenario {
    number: 14,
    name: "pushed_box",
    title: "A box that is pushed from under balls",
    watch: "Friction between two limits: the ground brakes the box with all it has, the balls roll back on it without slipping. A pyramid of friction brakes more along its diagonals, and the box stays where it is.",
    error: "mean over time of the squared errors of velocity of the box and of a ball, the worse of two directions",
    unit: "m²/s²",
    one_percent: 3.145e-4,
    scale: "of both velocities: a ten-thousandth of what no motion would be",
    pass: 1e-5,
    fails: "stuck: it is more than half of what no motion would be, 3.145 m²/s²",
    rates: FEW_RATES,
    scenes: |rate, _| Ok(vec![scene(rate, 60.0), scene(rate, 0.0)]),
    watcher: |scene| {
        let along = scene.forces.iter().find_map(|force| match force {
            Force::Constant { force, .. } => Some(force.normalize()),
            _ => None,
        });
        Box::new(Squares {
            along: along.unwrap_or_default(),
            sum: 0.0,
            steps: 0,
        })
    },
    steps: None,
    page: "ch03_friction",
};

/// Pushed so many degrees from z towards x.
fn scene(rate: u32, degrees: f64) -> Scene {
    let mut scene = Scene::new("pushed_box");
    let [ground, rolling] = FRICTION;
    let mut floor = floor(60.0);
    floor.friction = ground * ground / rolling;
    scene.bodies.push(floor);
    let half_extents = DVec3::new(10.0, 0.5, 10.0);
    let wide = Body::new(Shape::Box { half_extents }, MASS, DVec3::Y * 0.5);
    scene.bodies.push(Body {
        friction: rolling,
        ..wide
    });
    for k in 0..EDGE * EDGE {
        let place = |k: u32| 2.0 * (f64::from(k) - f64::from(EDGE - 1) / 2.0);
        let at = DVec3::new(place(k % EDGE), 1.0 + RADIUS, place(k / EDGE));
        scene.bodies.push(Body {
            friction: rolling,
            ..ball(RADIUS, 1.0, at)
        });
    }
    let (x, z) = f64::to_radians(degrees).sin_cos();
    let force = PUSH * DVec3::new(x, 0.0, z);
    scene.forces.push(Force::Constant { body: 1, force });
    timed(scene, rate, TIME)
}

/// Accelerations of the box and of a ball, m/s²: the ground takes μ(M + nm)g, and a ball that rolls back on the
/// box resists like 2/7 of its mass.
fn exact() -> [f64; 2] {
    let ground = FRICTION[0] * (MASS + BALLS) * G;
    let of_a_ball = ((PUSH - ground) / MASS) / (3.5 + BALLS / MASS);
    [(PUSH - ground - BALLS * of_a_ball) / MASS, of_a_ball]
}

/// Sums squared errors of velocity.
struct Squares {
    along: DVec3,
    sum: f64,
    steps: u32,
}

impl Watch for Squares {
    fn see(&mut self, now: &Moment) {
        for (body, acceleration) in WATCHED.into_iter().zip(exact()) {
            let velocity = now.state.linear_velocity[body];
            self.sum += velocity.distance_squared(self.along * acceleration * now.time);
        }
        self.steps += 1;
    }

    fn verdict(&self) -> Verdict {
        let error = self.sum / f64::from(self.steps);
        // Without motion it is a third of the squared velocities at the end, 3.145.
        let still: f64 = exact().map(|a| (a * TIME).powi(2) / 3.0).iter().sum();
        match Verdict::of(error) {
            Verdict { failed: None, .. } if error > 0.5 * still => Verdict::failed("stuck"),
            verdict => verdict,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_accelerations_are_those_of_the_reference() {
        let [wide, ball] = exact();
        assert!((wide - 0.7385).abs() < 1e-12, "{wide}");
        assert!((ball - 0.211).abs() < 1e-12, "{ball}");
        let ends = [wide * TIME, ball * TIME];
        assert!((ends[0] - 2.954).abs() < 1e-9 && (ends[1] - 0.844).abs() < 1e-9);
    }
}
