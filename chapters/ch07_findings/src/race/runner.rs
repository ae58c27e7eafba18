//! One contender on its way: its session, the times of its steps, and what was measured of it.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use ch00_scenes::measures::{Penetration, joint_separation};
use ch00_scenes::{LoadError, Scene};
use ch00_shell::{Gpu, Session};

use super::Contender;
use super::curves::{Curve, Sample};

/// Times are averaged over so long.
const MEAN_OVER: Duration = Duration::from_secs(1);

/// A contender in the race.
pub struct Runner {
    /// Who it is.
    pub contender: Contender,
    /// Red, green, blue.
    pub color: [u8; 3],
    /// What it runs, or why it doesn't.
    pub session: Result<Session, LoadError>,
    /// Why it stopped.
    pub stopped: Option<String>,
    /// What was measured.
    pub curve: Curve,
    /// The times of all its steps but the first.
    pub times: Vec<Duration>,
    /// The times of the last second's steps, each with when it ended.
    recent: VecDeque<(Instant, Duration)>,
    /// Deepest overlap so far, m; none if it isn't known.
    pub deepest: Option<f64>,
    /// Widest joint so far, m.
    pub widest: Option<f64>,
}

impl Runner {
    /// At the start of the scene.
    pub fn new(contender: Contender, color: [u8; 3], scene: &Scene) -> Self {
        let settings = contender.settings.clone();
        let session = Session::new(scene.clone(), contender.entry, settings);
        let mut runner = Self {
            contender,
            color,
            session,
            stopped: None,
            curve: Curve::default(),
            times: Vec::new(),
            recent: VecDeque::new(),
            deepest: Some(0.0),
            widest: None,
        };
        runner.measure();
        runner
    }

    /// The engine, the method, and how often either repeats itself in a step.
    pub fn name(&self) -> String {
        let Ok(session) = &self.session else {
            return self.contender.to_string();
        };
        let info = session.engine().info();
        let times = |count: u32, what: &str| {
            let s = if count == 1 { "" } else { "s" };
            format!(" · {count} {what}{s}")
        };
        let whole_steps = info.substeps == 1 && info.sweeps.is_some();
        let substeps = if whole_steps {
            String::new()
        } else {
            times(info.substeps, "substep")
        };
        let sweeps = info
            .sweeps
            .map_or_else(String::new, |sweeps| times(sweeps, "sweep"));
        format!("{} · {}{substeps}{sweeps}", info.engine, info.method)
    }

    /// Why nothing is to be seen, or nothing moves any more.
    pub fn trouble(&self) -> Option<String> {
        match &self.session {
            Err(error) => Some(error.to_string()),
            Ok(_) => self.stopped.clone(),
        }
    }

    /// Makes a step, unless it has stopped.
    pub fn step(&mut self) {
        let Some(session) = self
            .session
            .as_mut()
            .ok()
            .filter(|_| self.stopped.is_none())
        else {
            return;
        };
        session.step();
        // The first step makes room for what the others find there.
        if session.steps() > 1 {
            let now = Instant::now();
            self.times.push(session.step_time());
            self.recent.push_back((now, session.step_time()));
            while self
                .recent
                .front()
                .is_some_and(|(end, _)| now - *end > MEAN_OVER)
            {
                self.recent.pop_front();
            }
        }
        if let Some(why) = session.failure() {
            self.stopped = Some(why.to_owned());
        } else if session.state_now().not_finite() > 0 {
            self.stopped = Some(format!("NaN at t = {:.2} s", session.time()));
        }
    }

    /// Mean time of the last second's steps, ms; none before the second step.
    pub fn recent_ms(&self) -> Option<f64> {
        let sum: Duration = self.recent.iter().map(|(_, time)| *time).sum();
        let count = self.recent.len();
        (count > 0).then(|| 1e3 * sum.as_secs_f64() / count as f64)
    }

    /// Half of the steps took no longer, ms; none before the second step.
    pub fn median_ms(&self) -> Option<f64> {
        let mut times = self.times.clone();
        times.sort_unstable();
        let half = times.len().checked_sub(1)? / 2;
        Some(1e3 * times[half].as_secs_f64())
    }

    /// Measures where the bodies are now, unless it has stopped.
    pub fn measure(&mut self) {
        let Some(session) = self
            .session
            .as_ref()
            .ok()
            .filter(|_| self.stopped.is_none())
        else {
            return;
        };
        let (scene, state) = (session.scene(), session.state_now());
        let overlap = Penetration::of(scene, state);
        let is_known = overlap.pairs_not_measured == 0;
        let last = session.history().samples().back();
        let sample = Sample {
            time: session.time(),
            ms: self.recent_ms(),
            energy_error: last.and_then(|sample| sample.energy_error),
            deepest: is_known.then_some(overlap.deepest),
            p99: is_known.then_some(overlap.p99),
            joint: joint_separation(scene, state),
        };
        self.deepest = match (self.deepest, sample.deepest) {
            (Some(before), Some(now)) => Some(before.max(now)),
            _ => None,
        };
        self.widest = match (self.widest, sample.joint) {
            (Some(before), Some(now)) => Some(before.max(now)),
            (before, now) => before.or(now),
        };
        self.curve.push(sample);
    }

    /// Goes on where the window draws, if the bodies are on another device.
    pub fn move_to(&mut self, gpu: &Gpu) {
        let Ok(session) = &mut self.session else {
            return;
        };
        let is_elsewhere = session
            .resident()
            .is_some_and(|resident| resident.gpu.device != gpu.device);
        if is_elsewhere && session.engine().failure().is_none() {
            let (entry, settings) = (session.entry(), session.settings().clone());
            if let Err(error) = session.change_engine(entry, settings) {
                self.stopped = Some(error.to_string());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{Body, Shape};
    use glam::DVec3;

    use super::*;

    fn runner(scene: &Scene) -> Runner {
        let contender = Contender::parse("lanes").expect("it is one");
        Runner::new(contender, [0, 0, 0], scene)
    }

    #[test]
    fn who_becomes_no_number_stops_and_says_when() {
        let mut scene = Scene::new("far");
        scene.dt = 0.5;
        let ball = Shape::Sphere { radius: 1.0 };
        scene.bodies = vec![Body {
            linear_velocity: DVec3::X * 3e38, // times 1 s is just a number in f32, times 1.5 s is not
            ..Body::new(ball, 1.0, DVec3::ZERO)
        }];
        let mut runner = runner(&scene);
        assert_eq!(runner.trouble(), None);
        for _ in 0..10 {
            runner.step();
            runner.measure();
        }
        let trouble = runner.trouble().expect("it has left all numbers");
        assert!(trouble.starts_with("NaN at t = "), "{trouble}");
        let session = runner.session.as_ref().expect("it was loaded");
        assert!(session.steps() < 10);
    }

    #[test]
    fn times_are_those_of_all_steps_but_the_first() {
        let scene = Scene::open("bounce", None, None).expect("a built-in");
        let mut runner = runner(&scene);
        runner.step();
        assert_eq!((runner.median_ms(), runner.recent_ms()), (None, None));
        runner.step();
        assert!(runner.median_ms().is_some() && runner.recent_ms() == runner.median_ms());
    }
}
