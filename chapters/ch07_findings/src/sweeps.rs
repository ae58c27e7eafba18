//! How many sweeps a pile needs: 1,000 balls after ten seconds, for 1 to 64 sweeps. The default
//! of chapter 3 is read off here.

use std::fmt::Write as _;

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, State, builtin};
use ch03_collision::DEFAULT_SWEEPS_OF_BALLS;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, by, median_ms};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// Numbers of sweeps that are tried.
pub const SWEEPS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Seeds; the worst of them counts.
pub const SEEDS: [u64; 3] = [1, 2, 3];

/// A run's end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Sweeps in each step.
    pub sweeps: u32,
    /// Seed of the scene.
    pub seed: u64,
    /// 99th percentile of the overlaps after 600 steps, m.
    pub p99: f64,
    /// Largest of them, m.
    pub deepest: f64,
    /// Kinetic energy a body after 600 steps, J.
    pub kinetic_energy: f64,
    /// Largest number of balls that were outside at once.
    pub escaped: usize,
    /// Median time of a step, ms.
    pub median_ms: f64,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let (count, seeds) = if quick {
        (200, &SEEDS[..1])
    } else {
        (1000, &SEEDS[..])
    };
    let mut samples = Vec::new();
    for sweeps in SWEEPS {
        for &seed in seeds {
            samples.push(settled(count, seed, sweeps)?);
        }
        say(&format!("{sweeps} sweeps"));
    }
    Ok(Product {
        charts: vec![chart(count, &samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples)),
    })
}

/// Runs `balls` for 600 steps.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn settled(count: u64, seed: u64, sweeps: u32) -> Result<Sample, FindingsError> {
    let scene: Scene = builtin::build("balls", Some(count), Some(seed))?;
    let mut last = State::default();
    let mut escaped = 0;
    let times = lab::run(&scene, &by("corrected").with_sweeps(sweeps), |now| {
        let out = ch00_scenes::measures::escaped(&scene, now.state);
        escaped = escaped.max(out.unwrap_or(0));
        if now.step == scene.steps {
            last.clone_from(now.state);
        }
    })?;
    let measures = Measures::of(&scene, &last);
    Ok(Sample {
        sweeps,
        seed,
        p99: measures.penetration.p99,
        deepest: measures.penetration.deepest,
        kinetic_energy: measures.conserved.kinetic_energy / count as f64,
        escaped,
        median_ms: median_ms(&times),
    })
}

/// The worst of a property over the seeds.
fn worst(samples: &[Sample], sweeps: u32, of: impl Fn(&Sample) -> f64) -> f64 {
    let same = samples.iter().filter(|sample| sample.sweeps == sweeps);
    same.map(of).fold(0.0, f64::max)
}

fn chart(count: u64, samples: &[Sample]) -> Chart {
    let places: Vec<f64> = SWEEPS.map(f64::from).to_vec();
    let curve = |name: &str, style, of: fn(&Sample) -> f64| {
        Series::of(name, style, &places, |sweeps| {
            1000.0 * worst(samples, sweeps as u32, of)
        })
    };
    Chart {
        name: "sweeps",
        title: format!("Overlap of {count} balls after 10 s, worst of the seeds"),
        x: Axis::log("sweeps"),
        y: Axis::log("overlap (mm)"),
        series: vec![
            curve("99th percentile", Style::Corrected, |s| s.p99),
            curve("deepest", Style::Other(0), |s| s.deepest),
            Series::of("1 cm", Style::Theory, &places, |_| 10.0),
        ],
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text =
        "sweeps,seed,p99 (m),deepest (m),kinetic energy a body (J),escaped,median step (ms)\n"
            .to_owned();
    for s in samples {
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{}",
            s.sweeps, s.seed, s.p99, s.deepest, s.kinetic_energy, s.escaped, s.median_ms
        );
    }
    text
}

fn page(samples: &[Sample]) -> String {
    let mut table = Table::new(&[
        "sweeps",
        "p99 (mm)",
        "deepest (mm)",
        "energy a ball (J)",
        "escaped",
        "ms/step",
        "",
    ]);
    for sweeps in SWEEPS {
        let of = |property: fn(&Sample) -> f64| worst(samples, sweeps, property);
        table.push(vec![
            sweeps.to_string(),
            three_digits(1000.0 * of(|s| s.p99)),
            three_digits(1000.0 * of(|s| s.deepest)),
            three_digits(of(|s| s.kinetic_energy)),
            three_digits(of(|s| s.escaped as f64)),
            three_digits(of(|s| s.median_ms)),
            if sweeps == DEFAULT_SWEEPS_OF_BALLS {
                "default".to_owned()
            } else {
                String::new()
            },
        ]);
    }
    table.markdown(0)
}
