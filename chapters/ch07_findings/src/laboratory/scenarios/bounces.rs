//! 11 and 12: a ball that falls 4.9 m onto a floor and bounces, with all of its speed or half of it.

use ch00_scenes::{Scene, builtin};

use super::share;
use crate::FindingsError;
use crate::lab::{Moment, worst};
use crate::laboratory::scenario::{SOME_RATES, Scenario, Verdict, Watch, timed};

/// Of the ball, m.
const RADIUS: f64 = 0.1;

pub const ELASTIC: Scenario = Scenario {
    number: 11,
    name: "bounce",
    title: "A ball that bounces without loss",
    watch: "It is found inside the floor, faster than it was at the surface; who gives that speed back adds energy, who stops it first loses it.",
    error: "height of the first five apexes, the worst of drops from 4.95 to 5.05 m",
    unit: "",
    one_percent: 0.01,
    scale: "of the heights",
    pass: 0.01,
    fails: "too few bounces: fewer apexes than there should be",
    rates: SOME_RATES,
    scenes: |rate, quick| drops("bounce", rate, 11.0, quick),
    watcher: |scene| Box::new(Apexes::of(scene, 1.0, 5)),
    steps: None,
    page: "ch03_contacts",
};

pub const INELASTIC: Scenario = Scenario {
    number: 12,
    name: "bounce_half",
    title: "A ball that keeps half its speed",
    error: "height of the first three apexes, the worst of drops from 4.95 to 5.05 m",
    scenes: |rate, quick| drops("bounce_half", rate, 3.0, quick),
    watcher: |scene| Box::new(Apexes::of(scene, 0.5, 3)),
    ..ELASTIC
};

fn drops(name: &str, rate: u32, seconds: f64, quick: bool) -> Result<Vec<Scene>, FindingsError> {
    let many = if quick { 3 } else { 11 };
    let scene = builtin::build(name, None, None)?;
    let drop = |k: u32| {
        let mut scene = scene.clone();
        let ball = scene.bodies.iter_mut().find(|body| !body.is_static());
        if let Some(ball) = ball {
            ball.position.y = 4.95 + 0.1 * f64::from(k) / f64::from(many - 1);
        }
        timed(scene, rate, seconds)
    };
    Ok((0..many).map(drop).collect())
}

/// The apexes after hits, by parabolas through three heights.
struct Apexes {
    ball: usize,
    /// Exact heights above the radius, m.
    exact: Vec<f64>,
    last: Vec<f64>,
    /// Whether it has been falling since the start or an apex.
    falls: bool,
    found: Vec<f64>,
}

impl Apexes {
    fn of(scene: &Scene, e: f64, count: i32) -> Self {
        let ball = scene.bodies.iter().position(|body| !body.is_static());
        let ball = ball.unwrap_or(0);
        let drop = scene.bodies[ball].position.y - RADIUS;
        Self {
            ball,
            exact: (1..=count).map(|n| drop * e.powi(2 * n)).collect(),
            last: Vec::new(),
            falls: true,
            found: Vec::new(),
        }
    }
}

impl Watch for Apexes {
    fn see(&mut self, now: &Moment) {
        self.last.push(now.state.position[self.ball].y);
        if let [.., a, b, c] = self.last[..] {
            if c > b {
                self.falls = false;
            } else if !self.falls {
                let bend = a - 2.0 * b + c;
                let sag = (c - a) * (c - a) / (8.0 * bend);
                let is_parabola = bend < 0.0;
                self.found
                    .push(if is_parabola { b - sag } else { b.max(a) });
                self.falls = true;
            }
        }
    }

    fn verdict(&self) -> Verdict {
        if self.found.len() < self.exact.len() {
            return Verdict::failed("too few bounces");
        }
        let pairs = self.found.iter().zip(&self.exact);
        Verdict::of(worst(
            pairs.map(|(found, exact)| share(found - RADIUS, *exact)),
        ))
    }
}
