//! Microseconds a body and a step, against the number of bodies: the settled pile on every engine. Only what
//! passes the gate has a mark: 99 of 100 overlaps are no deeper than a tenth of the smaller ball's radius.

mod crossings;
mod pile;
mod tell;

use std::path::Path;
use std::time::Instant;

use ch00_scenes::Scene;

use crate::FindingsError;
use crate::engines::{KINDS, Kind};
use crate::kept::Source;
use crate::lab::Spread;
use crate::laboratory::store::{Kept, Store};
use crate::product::{Product, Say};
use crate::stepped::Stepped;
use pile::{lies, settled};

/// Numbers of balls.
pub const COUNTS: [u64; 7] = [60, 300, 1000, 3000, 10_000, 30_000, 100_000];
/// Numbers of balls in a hurry.
const QUICK: [u64; 2] = [60, 300];
/// Of 100 overlaps 99 must be no deeper than this, in radii of the smaller ball.
pub const GATE: f64 = 0.1;
/// Steps of each engine, from the common pile, before the first that is timed; fewer above [`MANY`] balls.
const WARM: [u32; 2] = [120, 60];
const MANY: u64 = 1000;
/// Turns that are timed, and the steps of one; fewer above [`MANY`] balls.
const TURNS: [u32; 2] = [15, 5];
const STEPS: [u32; 2] = [20, 4];
/// An engine of which a step would take longer than this is left out, ms.
const LONGEST: f64 = 500.0;

/// The kept table with a graphics card's times.
const CARD: Source = Source {
    file: "ch06_pile_nvidia_h200.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example pile -- \
              --engine NAME --counts N,N,… --csv FILE",
};

/// An engine's time of one pile.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// As [`KINDS`] call it, or with the card's name.
    pub name: String,
    /// What it ran on.
    pub device: String,
    /// Whether it is kept, not measured here.
    pub kept: bool,
    /// Number of balls.
    pub balls: u64,
    /// Of a step and a ball, µs.
    pub micros: Spread,
    /// 99 of 100 overlaps are no deeper, in radii of the smaller ball.
    pub p99: f64,
    /// Balls outside the box or nowhere.
    pub gone: usize,
}

impl Kept for Sample {
    const HEADINGS: &'static str =
        "engine,device,kept,balls,median_us,least_us,largest_us,p99_of_r,gone";

    fn line(&self) -> String {
        let Spread { median, low, high } = self.micros;
        // Devices have commas in their names.
        let device = self.device.replace(',', ";");
        let (name, kept, balls) = (&self.name, self.kept, self.balls);
        let (p99, gone) = (self.p99, self.gone);
        format!("{name},{device},{kept},{balls},{median:?},{low:?},{high:?},{p99:?},{gone} gone")
    }

    fn read(line: &str) -> Option<Self> {
        let fields: Vec<&str> = line.split(',').collect();
        let [name, device, kept, balls, median, low, high, p99, gone] = fields[..] else {
            return None;
        };
        Some(Self {
            name: name.to_owned(),
            device: device.to_owned(),
            kept: kept.parse().ok()?,
            balls: balls.parse().ok()?,
            micros: Spread {
                median: median.parse().ok()?,
                low: low.parse().ok()?,
                high: high.parse().ok()?,
            },
            p99: p99.parse().ok()?,
            gone: gone.strip_suffix(" gone")?.parse().ok()?,
        })
    }
}

impl Sample {
    /// Whether its time counts.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.p99 < GATE && self.gone == 0
    }
}

/// Measures the piles that the folder's table lacks, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built, or a table can't be read or written.
pub fn product(quick: bool, folder: &Path, say: Say) -> Result<Product, FindingsError> {
    let counts = if quick { &QUICK[..] } else { &COUNTS[..] };
    let end = if quick { "_quick" } else { "" };
    let name = format!("microseconds_per_body_runs{end}.csv");
    let mut store = Store::<Sample>::open(&folder.join(name))?;
    for &balls in counts {
        if store.cells.iter().any(|sample| sample.balls == balls) {
            continue;
        }
        let scene = settled(balls, if quick { 60 } else { 300 })?;
        say(&format!("{balls} balls lie"));
        let kinds: Vec<&Kind> = KINDS
            .iter()
            .filter(|kind| expected(&store.cells, kind, balls) < LONGEST)
            .collect();
        for sample in timed(&kinds, &scene, balls, quick) {
            let micros = sample.micros.median;
            say(&format!("{balls} balls, {}: {micros:.3} µs", sample.name));
            store.add(sample)?;
        }
    }
    let mut samples = store.cells;
    samples.sort_by_key(|sample| sample.balls);
    samples.extend(card()?);
    Ok(Product {
        charts: tell::charts(&samples).map(Into::into).into(),
        csv: tell::csv(&samples),
        page: Some(tell::page(&samples)),
    })
}

/// What a step will take, ms, if a ball takes as long as in the next smaller pile that is known.
fn expected(samples: &[Sample], kind: &Kind, balls: u64) -> f64 {
    let smaller = samples
        .iter()
        .filter(|one| one.name == kind.name && one.balls < balls);
    let last = smaller.max_by_key(|one| one.balls);
    last.map_or(0.0, |one| 1e-3 * one.micros.median * balls as f64)
}

/// Lets every engine go on with the same pile, and times turns of each.
fn timed(kinds: &[&Kind], scene: &Scene, balls: u64, quick: bool) -> Vec<Sample> {
    let dt = scene.dt as f32;
    let many = usize::from(balls > MANY);
    let warm = if quick { 20 } else { WARM[many] };
    let mut engines = Vec::new();
    for kind in kinds {
        if let Ok(mut engine) = Stepped::load(kind.engine, &kind.settings(), scene) {
            engine.steps(dt, warm);
            engines.push((*kind, engine));
        }
    }
    let mut micros = vec![Vec::new(); engines.len()];
    for turn in 0..TURNS[many] as usize {
        for k in 0..engines.len() {
            let k = (k + turn) % engines.len();
            let start = Instant::now();
            engines[k].1.steps(dt, STEPS[many]);
            let spent = 1e6 * start.elapsed().as_secs_f64();
            micros[k].push(spent / f64::from(STEPS[many]) / balls as f64);
        }
    }
    let all = engines.iter().zip(&micros);
    all.map(|((kind, engine), micros)| {
        let (p99, gone) = lies(scene, &engine.state());
        Sample {
            name: kind.name.to_owned(),
            device: engine.device(),
            kept: false,
            balls,
            micros: Spread::of_all(micros),
            p99,
            gone,
        }
    })
    .collect()
}

/// What a card took, from the kept table.
fn card() -> Result<Vec<Sample>, FindingsError> {
    let kept = CARD.read()?;
    let mut samples = Vec::new();
    for line in kept.lines() {
        if line.text("engine")? != ch06_compute::COMPUTE.name {
            continue;
        }
        let balls: u64 = line.number("count")?;
        let device = line.text("device")?.to_owned();
        let micros = |column| Ok::<_, FindingsError>(1e3 * line.positive(column)? / balls as f64);
        samples.push(Sample {
            name: format!("own-row on {device}"),
            device,
            kept: true,
            balls,
            micros: Spread {
                median: micros("ms_median")?,
                low: micros("ms_fastest")?,
                high: micros("ms_slowest")?,
            },
            p99: line.number("p99_of_r")?,
            gone: line.number::<usize>("escaped")? + line.number::<usize>("not_finite")?,
        });
    }
    Ok(samples)
}
