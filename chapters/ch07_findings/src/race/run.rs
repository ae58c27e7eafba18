//! The race itself: all contenders make the same steps of the same size from the same start, one after
//! the other; the slowest sets the pace.

use std::time::{Duration, Instant};

use ch00_scenes::{EngineEntry, LoadError, Scene, Settings};

use super::gallery::Setup;
use super::runner::Runner;
use super::{Contender, RaceError};

/// A colour a contender, to be told apart by everybody (Okabe and Ito): orange, blue, green, pink.
const COLORS: [[u8; 3]; 4] = [
    [0xE6, 0x9F, 0x00],
    [0x56, 0xB4, 0xE9],
    [0x00, 0x9E, 0x73],
    [0xCC, 0x79, 0xA7],
];

/// In a window it is measured so often at most.
const MEASURE_EVERY: Duration = Duration::from_millis(200);

/// Measuring takes at most one part in so many of the time.
const MEASURE_SHARE: u32 = 8;

/// A scene and its contenders.
pub struct Race {
    scene: Scene,
    pub(super) runners: Vec<Runner>,
    /// What of the gallery it is.
    pub(super) setup: Option<&'static Setup>,
    steps: u64,
    /// What the last step of all took, s.
    cost: f64,
    /// At which step it was measured, when that was done, and how long it took.
    measured: (u64, Instant, Duration),
    /// Whether the plots show joints rather than overlaps.
    pub(super) shows_joints: bool,
}

impl Race {
    /// At the start. A contender that can't run the scene says why in its view.
    ///
    /// # Errors
    /// [`RaceError::NobodyRuns`] if none of them can.
    pub fn new(scene: Scene, contenders: Vec<Contender>) -> Result<Self, RaceError> {
        let runners: Vec<Runner> = contenders
            .into_iter()
            .zip(COLORS)
            .map(|(contender, color)| Runner::new(contender, color, &scene))
            .collect();
        if runners.iter().all(|runner| runner.session.is_err()) {
            let why: Vec<String> = runners.iter().filter_map(Runner::trouble).collect();
            return Err(RaceError::NobodyRuns {
                scene: scene.name,
                why: why.join("; "),
            });
        }
        Ok(Self {
            shows_joints: !scene.joints.is_empty(),
            scene,
            runners,
            setup: None,
            steps: 0,
            cost: 0.0,
            measured: (0, Instant::now(), Duration::ZERO),
        })
    }

    /// The same with what its user shall watch.
    #[must_use]
    pub fn to_watch(mut self, setup: &'static Setup) -> Self {
        self.setup = Some(setup);
        self
    }

    /// Whether every contender's method has the settings that were asked for.
    ///
    /// # Errors
    /// [`RaceError::Method`] for the first that hasn't.
    pub fn check_settings(&self) -> Result<(), RaceError> {
        for runner in &self.runners {
            if let Err(source @ LoadError::Setting { .. }) = &runner.session {
                return Err(RaceError::Method {
                    text: runner.contender.to_string(),
                    source: Box::new(source.clone()),
                });
            }
        }
        Ok(())
    }

    /// What is simulated.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Steps since the start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Who takes part.
    #[must_use]
    pub fn contenders(&self) -> Vec<Contender> {
        let contenders = self.runners.iter().map(|runner| &runner.contender);
        contenders.cloned().collect()
    }

    /// The first contender that runs.
    #[must_use]
    pub fn first_running(&self) -> Option<(EngineEntry, Settings)> {
        let running = self.runners.iter().find(|runner| runner.session.is_ok())?;
        let Contender { entry, settings } = &running.contender;
        Some((*entry, settings.clone()))
    }

    /// Everyone makes a step.
    pub fn step_all(&mut self) {
        let start = Instant::now();
        for runner in &mut self.runners {
            runner.step();
        }
        self.steps += 1;
        self.cost = start.elapsed().as_secs_f64();
    }

    /// Measures everyone at this step.
    pub fn measure(&mut self) {
        let start = Instant::now();
        for runner in &mut self.runners {
            runner.measure();
        }
        self.measured = (self.steps, Instant::now(), start.elapsed());
    }

    /// Measures everyone if there is something new, and it is time to.
    pub(super) fn measure_now_and_then(&mut self) {
        let (step, end, took) = self.measured;
        if step != self.steps && end.elapsed() >= MEASURE_EVERY.max(MEASURE_SHARE * took) {
            self.measure();
        }
    }

    /// What the last step of all took, s.
    pub(super) fn cost_of_step(&self) -> f64 {
        self.cost
    }

    /// Everyone back to the start.
    pub fn start_again(&mut self) {
        let scene = &self.scene;
        for runner in &mut self.runners {
            *runner = Runner::new(runner.contender.clone(), runner.color, scene);
        }
        self.steps = 0;
        self.measured = (0, Instant::now(), Duration::ZERO);
    }
}
