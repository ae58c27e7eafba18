//! 8: a disc on an axle whose foot stays in place: it precesses and nods (nutation), with the period of an elliptic
//! integral.

use ch00_scenes::{Body, Force, Scene, Shape};
use glam::{DQuat, DVec3};

use super::share;
use crate::lab::Moment;
use crate::laboratory::scenario::{Scenario, Verdict, Watch, timed};

/// s.
const PERIOD: f64 = 0.298_502_047_2;
const SECONDS: f64 = 5.0;

pub const SCENARIO: Scenario = Scenario {
    number: 8,
    name: "heavy_top",
    title: "A heavy top",
    watch: "Without the gyroscopic torque it precesses at a third of its rate; with an explicit one it blows up within a second.",
    error: "mean period of nutation over 5 s",
    unit: "",
    one_percent: 0.01,
    scale: "of the period",
    pass: 0.01,
    fails: "no nutation: it nods less often in 5 s than it should",
    rates: &[60, 120, 240, 480, 960, 1920, 3840],
    scenes: |rate, _| Ok(vec![timed(scene(), rate, SECONDS)]),
    watcher: |_| Box::new(Nods::default()),
    steps: None,
    page: "ch02_rigid_bodies",
};

/// The disc, thin enough to have the moments of the reference, 0.5 rad from the vertical at 60 rad/s.
fn scene() -> Scene {
    let mut scene = Scene::new("heavy_top");
    let orientation = DQuat::from_rotation_z(-0.5);
    let arm = DVec3::Y * 0.2;
    let shape = Shape::Cylinder {
        radius: 0.2,
        half_height: 1e-4,
    };
    scene.bodies.push(Body {
        orientation,
        angular_velocity: orientation * DVec3::Y * 60.0,
        ..Body::new(shape, 1.0, orientation * arm)
    });
    scene.forces.push(Force::FixedPoint { body: 0, arm });
    scene
}

/// When the axis is most upright.
#[derive(Default)]
struct Nods {
    /// The last two cosines of the angle, and their times.
    last: Vec<(f64, f64)>,
    /// Times of the maxima of the cosine, s.
    tops: Vec<f64>,
}

impl Watch for Nods {
    fn see(&mut self, now: &Moment) {
        let upright = (now.state.orientation[0] * DVec3::Y).y;
        self.last.push((now.time, upright));
        if let [.., (t0, a), (t1, b), (t2, c)] = self.last[..] {
            // The parabola through three of them, if the middle one is the highest.
            if b >= a && b > c {
                let bend = a - 2.0 * b + c;
                self.tops.push(t1 + 0.25 * (t2 - t0) * (a - c) / bend);
            }
        }
    }

    fn verdict(&self) -> Verdict {
        let wanted = (SECONDS / PERIOD) as usize;
        match self.tops[..] {
            // The top starts at one, which no parabola sees.
            [first, .., last] if self.tops.len() + 1 >= wanted => {
                Verdict::of(share((last - first) / (self.tops.len() - 1) as f64, PERIOD))
            }
            _ => Verdict::failed("no nutation"),
        }
    }
}
