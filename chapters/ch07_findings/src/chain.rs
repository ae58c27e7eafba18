//! A chain with a heavy ball at its end (scenario 22), 40 links of 0.25 m and 1 kg and a ball of
//! 672 kg, hanging and released from the horizontal, ten seconds at 60 Hz: how much longer than it
//! should be the way from the hook to the last pin is, against the sweeps, the ball's mass and the
//! number of links. There is no floor, so that nothing ends a fall.
//!
//! A sweep from a cold start leaves 0.999 963 5 of the error: 1 % takes 126,253.

use std::fmt::Write as _;

use ch00_scenes::measures::joint_separation;
use ch00_scenes::{Scene, State, builtin};
use ch03_collision::DEFAULT_SWEEPS;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, by, median_ms, worst};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres, percent, three_digits};

/// Numbers of sweeps that are tried.
pub const SWEEPS: [u32; 7] = [2, 4, 8, 16, 32, 64, 128];
/// Masses of the ball that are tried, kg.
pub const MASSES: [f64; 7] = [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 672.0];
/// Numbers of links that are tried.
pub const LINKS: [u64; 6] = [5, 10, 20, 40, 80, 160];
/// As in the scenario.
const USUAL: (u64, f64) = (40, 672.0);
/// A chain that stretches by a larger share of its length has failed.
pub const HELD: f64 = 0.01;

/// What is asked of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// Name of the built-in scene.
    pub scene: &'static str,
    /// The method.
    pub method: &'static str,
    /// Sweeps in each step.
    pub sweeps: u32,
    /// Number of links.
    pub links: u64,
    /// Mass of the ball, kg.
    pub mass: f64,
}

/// What became of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain {
    /// What was asked.
    pub setup: Setup,
    /// Largest excess of the way from the hook to the last pin, m.
    pub stretch: f64,
    /// The same at the end, m.
    pub stretch_at_end: f64,
    /// Widest joint, m.
    pub widest: f64,
    /// Median time of a step, ms.
    pub median_ms: f64,
}

/// The two ways to start.
const STARTS: [(&str, Style); 2] = [
    ("chain_hanging", Style::Corrected),
    ("chain", Style::Other(0)),
];

impl Setup {
    fn new(scene: &'static str) -> Self {
        Self {
            scene,
            method: "corrected",
            sweeps: DEFAULT_SWEEPS,
            links: USUAL.0,
            mass: USUAL.1,
        }
    }

    /// Length that the chain should have, m.
    #[must_use]
    pub fn length(&self) -> f64 {
        0.25 * self.links as f64
    }

    fn scene(&self) -> Result<Scene, FindingsError> {
        let mut scene = builtin::build(self.scene, Some(self.links), None)?;
        scene.bodies[self.links as usize + 1].mass = self.mass;
        // The floor would stop a ball that sinks.
        scene.bodies.pop();
        Ok(scene)
    }
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut chains = Vec::new();
    for (scene, _) in STARTS {
        let usual = Setup::new(scene);
        let printed = Setup {
            method: "printed",
            sweeps: 1,
            ..usual
        };
        let sweeps = SWEEPS.map(|sweeps| Setup { sweeps, ..usual });
        let masses = MASSES.map(|mass| Setup { mass, ..usual });
        let links = LINKS.map(|links| Setup { links, ..usual });
        let setups = [printed]
            .into_iter()
            .chain(sweeps)
            .chain(masses)
            .chain(links);
        for setup in setups.filter(|s| !quick || s.sweeps <= 32 && s.links <= 40) {
            if !chains.iter().any(|chain: &Chain| chain.setup == setup) {
                chains.push(hung(setup)?);
            }
        }
        say(scene);
    }
    Ok(Product {
        charts: [by_sweeps(&chains), by_mass(&chains), by_links(&chains)]
            .map(Into::into)
            .to_vec(),
        csv: csv(&chains),
        page: Some(page(&chains)),
    })
}

/// Hangs a chain up, or lets it go, for ten seconds.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn hung(setup: Setup) -> Result<Chain, FindingsError> {
    let scene = setup.scene()?;
    let length = reach(&scene, &State::start_of(&scene));
    let (mut stretch, mut widest, mut at_end) = (0.0, 0.0, 0.0);
    let settings = by(setup.method).with_sweeps(setup.sweeps);
    let times = lab::run(&scene, &settings, |now| {
        at_end = reach(&scene, now.state) - length;
        stretch = worst([stretch, at_end]);
        let apart = joint_separation(&scene, now.state).unwrap_or(0.0);
        let is_number = now.state.not_finite() == 0;
        widest = worst([widest, if is_number { apart } else { f64::NAN }]);
    })?;
    Ok(Chain {
        setup,
        stretch,
        stretch_at_end: at_end,
        widest,
        median_ms: median_ms(&times),
    })
}

/// From the first joint to the last, m.
fn reach(scene: &Scene, state: &State) -> f64 {
    let place = |joint: &ch00_scenes::Joint| {
        let (_, b) = joint.bodies();
        state.position[b] + state.orientation[b] * joint.anchors().1
    };
    let hook = state.position[0];
    scene
        .joints
        .last()
        .map_or(0.0, |last| place(last).distance(hook))
}

/// The chains like `usual` but for one thing, that `is` looks at.
fn like<'a>(
    chains: &'a [Chain],
    scene: &'static str,
    is: impl Fn(&Setup, &Setup) -> bool + 'a,
) -> impl Iterator<Item = &'a Chain> {
    let usual = Setup::new(scene);
    chains.iter().filter(move |chain| is(&chain.setup, &usual))
}

/// Two curves: hanging, and released.
fn curves(
    chains: &[Chain],
    is: impl Fn(&Setup, &Setup) -> bool + Copy,
    point: impl Fn(&Chain) -> (f64, f64) + Copy,
) -> Vec<Series> {
    let names = ["hanging", "released from the horizontal"];
    let starts = STARTS.into_iter().zip(names);
    starts
        .map(|((scene, style), name)| {
            let mut points: Vec<_> = like(chains, scene, is).map(point).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            Series::new(name, style, points)
        })
        .collect()
}

fn by_sweeps(chains: &[Chain]) -> Chart {
    let is = |setup: &Setup, usual: &Setup| {
        *setup
            == Setup {
                sweeps: setup.sweeps,
                ..*usual
            }
    };
    let mut series = curves(chains, is, |c| (f64::from(c.setup.sweeps), c.stretch));
    let printed = chains.iter().filter(|c| c.setup.method == "printed");
    let points = printed.map(|c| (f64::from(c.setup.sweeps), c.stretch));
    series.insert(0, Series::new("printed (both)", Style::Marks(2), points));
    let sweeps = SWEEPS.map(f64::from);
    let limit = HELD * Setup::new("chain").length();
    series.push(Series::of(
        "1 % of its length",
        Style::Theory,
        &sweeps,
        |_| limit,
    ));
    Chart {
        name: "chain",
        title: "40 links and a ball of 672 kg: largest stretch in 10 s".to_owned(),
        x: Axis::log("sweeps"),
        y: Axis::log("hook to last pin, excess (m)"),
        series,
    }
}

fn by_mass(chains: &[Chain]) -> Chart {
    let is = |setup: &Setup, usual: &Setup| {
        *setup
            == Setup {
                mass: setup.mass,
                ..*usual
            }
    };
    let mut series = curves(chains, is, |c| (c.setup.mass, c.stretch));
    let limit = HELD * Setup::new("chain").length();
    series.push(Series::of(
        "1 % of its length",
        Style::Theory,
        &MASSES,
        |_| limit,
    ));
    Chart {
        name: "chain_mass",
        title: format!(
            "40 links of 1 kg and a ball, {DEFAULT_SWEEPS} sweeps: largest stretch in 10 s"
        ),
        x: Axis::log("mass of the ball (kg)"),
        y: Axis::log("hook to last pin, excess (m)"),
        series,
    }
}

fn by_links(chains: &[Chain]) -> Chart {
    let is = |setup: &Setup, usual: &Setup| {
        *setup
            == Setup {
                links: setup.links,
                ..*usual
            }
    };
    let share = |c: &Chain| (c.setup.links as f64, c.stretch / c.setup.length());
    let mut series = curves(chains, is, share);
    let links = LINKS.map(|links| links as f64);
    series.push(Series::of("1 %", Style::Theory, &links, |_| HELD));
    Chart {
        name: "chain_links",
        title: format!(
            "A chain and a ball of 672 kg, {DEFAULT_SWEEPS} sweeps: largest stretch in 10 s"
        ),
        x: Axis::log("links"),
        y: Axis::log("excess / length"),
        series,
    }
}

fn csv(chains: &[Chain]) -> String {
    let mut text = "scene,method,sweeps,links,ball_kg,largest_stretch_m,stretch_at_end_m,\
        widest_joint_m,median_ms\n"
        .to_owned();
    for c in chains {
        let s = c.setup;
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{:?},{:?},{:?},{:?},{:?}",
            s.scene,
            s.method,
            s.sweeps,
            s.links,
            s.mass,
            c.stretch,
            c.stretch_at_end,
            c.widest,
            c.median_ms
        );
    }
    text
}

fn page(chains: &[Chain]) -> String {
    let mut table = Table::new(&[
        "method",
        "sweeps",
        "links",
        "ball (kg)",
        "hanging: stretch, most / at the end (mm)",
        "of its length",
        "released: stretch, most (mm)",
        "of its length",
        "widest joint (mm)",
        "ms/step",
    ]);
    for hanging in chains.iter().filter(|c| c.setup.scene == STARTS[0].0) {
        let s = hanging.setup;
        let released = Setup {
            scene: STARTS[1].0,
            ..s
        };
        let Some(released) = chains.iter().find(|c| c.setup == released) else {
            continue;
        };
        table.push(vec![
            format!("`{}`", s.method),
            s.sweeps.to_string(),
            s.links.to_string(),
            three_digits(s.mass),
            format!(
                "{} / {}",
                millimetres(hanging.stretch),
                millimetres(hanging.stretch_at_end)
            ),
            percent(hanging.stretch / s.length()),
            millimetres(released.stretch),
            percent(released.stretch / s.length()),
            millimetres(released.widest),
            three_digits(released.median_ms),
        ]);
    }
    format!(
        "Links of 0.25 m and 1 kg and a ball, ten seconds at 60 Hz. Stretch: how much longer than it should \
         be the way from the hook to the last pin is; widest joint: of the released chain. From a cold start \
         the usual chain needs 126,253 sweeps for 1 % of the error.\n\n{table}",
        table = table.markdown(1),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_chains_are_as_long_as_they_should_be_at_the_start() {
        for (name, _) in STARTS {
            let setup = Setup::new(name);
            let scene = setup.scene().expect("it is built in");
            let start = reach(&scene, &State::start_of(&scene));
            assert!((start - setup.length()).abs() < 1e-12, "{name}: {start}");
            assert_eq!(scene.bodies[41].mass, 672.0);
        }
    }
}
