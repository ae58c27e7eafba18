//! What should stay and doesn't: energy, angular momentum and its direction of a body that is alone, and the
//! energy of a gas, against time at 60 Hz.

use std::fmt::Write as _;

use ch00_scenes::measures::Conserved;
use ch00_scenes::{Scene, State};

use super::contenders::{CONTENDERS, Contender, WITH_CCD};
use super::scenario::timed;
use super::scenarios::SCENARIOS;
use crate::FindingsError;
use crate::chart::{Axis, Chart, Picture, Series};
use crate::product::{Product, Say};

/// What is looked at: the scenario, for how long, s, how many times a second, and the chart.
struct Look {
    scenario: &'static str,
    seconds: f64,
    rate: u32,
    name: &'static str,
    /// Of the chart of what the book's engines don't have.
    others: &'static str,
    title: &'static str,
    of: fn(&Conserved, &Conserved) -> f64,
}

const LOOKS: [Look; 3] = [
    Look {
        scenario: "free_top",
        seconds: 60.0,
        rate: 60,
        name: "drift",
        others: "drift_others",
        title: "4. A box that tumbles in free space: change of its energy, as a share",
        of: |first, now| (now.kinetic_energy / first.kinetic_energy - 1.0).abs(),
    },
    Look {
        scenario: "free_top",
        seconds: 60.0,
        rate: 60,
        name: "drift_angular_momentum",
        others: "drift_angular_momentum_others",
        title: "4. A box that tumbles in free space: change of its angular momentum, as a share",
        of: |first, now| {
            let length = first.angular_momentum.length();
            (now.angular_momentum - first.angular_momentum).length() / length
        },
    },
    Look {
        scenario: "elastic_gas",
        seconds: 5.0,
        rate: 240,
        name: "drift_gas",
        others: "drift_gas_others",
        title: "18. A gas of 125 balls at 240 Hz: change of its energy, as a share",
        of: |first, now| (now.kinetic_energy / first.kinetic_energy - 1.0).abs(),
    },
];

/// Points of a curve.
const POINTS: u32 = 60;

/// Measures, and lays out pictures and CSV.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut csv = "chart,method,time (s),change\n".to_owned();
    let mut charts = Vec::new();
    for look in &LOOKS {
        let seconds = if quick {
            0.2 * look.seconds
        } else {
            look.seconds
        };
        let mut series = [Vec::new(), Vec::new()];
        // Nothing moves far in these steps: its curve would be that of rapier without.
        for contender in CONTENDERS.iter().filter(|one| one.name != WITH_CCD) {
            let Some(points) = curve(look, contender, seconds)? else {
                continue;
            };
            for (time, change) in &points {
                let _ = writeln!(csv, "{},{},{time},{change:e}", look.name, contender.name);
            }
            let panel = &mut series[usize::from(!contender.ours)];
            panel.push(Series::new(contender.name, contender.style, points));
        }
        say(look.name);
        charts.extend(panels(look, series).map(Picture::from));
    }
    Ok(Product {
        charts,
        csv,
        page: None,
    })
}

/// None where the contender can't run the scene.
fn curve(
    look: &Look,
    contender: &Contender,
    seconds: f64,
) -> Result<Option<Vec<(f64, f64)>>, FindingsError> {
    let found = SCENARIOS.iter().find(|known| known.name == look.scenario);
    let scenes = found.map_or(Ok(Vec::new()), |known| (known.scenes)(look.rate, true))?;
    let Some(scene) = scenes.into_iter().next() else {
        return Ok(None);
    };
    let scene = timed(scene, look.rate, seconds);
    let Ok(mut engine) = (contender.engine.load)(&scene, &contender.settings()) else {
        return Ok(None);
    };
    let first = Conserved::of(&scene, &State::start_of(&scene));
    let every = scene.steps.div_ceil(POINTS).max(1);
    let mut state = State::default();
    let mut points = Vec::new();
    for step in 1..=scene.steps {
        engine.step(scene.dt as f32);
        if step % every == 0 {
            engine.read_state(&mut state);
            points.push((
                f64::from(step) * scene.dt,
                change(look, &scene, &first, &state),
            ));
        }
    }
    Ok(Some(points))
}

fn change(look: &Look, scene: &Scene, first: &Conserved, state: &State) -> f64 {
    if state.not_finite() > 0 {
        return f64::INFINITY;
    }
    (look.of)(first, &Conserved::of(scene, state))
}

/// The book's engines, and the others over the same axes.
fn panels(look: &Look, series: [Vec<Series>; 2]) -> [Chart; 2] {
    let all = series.iter().flatten().flat_map(|one| &one.points);
    let changes: Vec<f64> = all.map(|point| point.1).collect();
    let [ours, others] = series;
    let chart = |name, whose: &str, series| Chart {
        name,
        title: format!("{}; {whose}", look.title),
        x: Axis::linear("time (s)"),
        y: Axis::log("change (share of 1)")
            .lost("NaN")
            .reaching(changes.iter().copied().filter(|change| *change > 0.0)),
        series,
    };
    [
        chart(look.name, "the book's engines", ours),
        chart(look.others, "others", others),
    ]
}
