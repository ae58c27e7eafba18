//! A heavy cube on a light one (scenario 21): 1 kg under 1 to 10,000 kg for ten seconds, with 2 to
//! 512 sweeps and as printed.
//!
//! A sweep from a cold start leaves k/(k + 1) of the error, so 1 % takes ln 0.01 / ln(k/(k + 1))
//! sweeps. Impulses that are kept from step to step get there in several steps, during which the
//! heavy cube sinks.

use std::fmt::Write as _;

use ch00_scenes::builtin;
use ch03_collision::DEFAULT_SWEEPS;
use glam::DVec3;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, by, median_ms, worst};
use crate::product::{Product, Say};
use crate::stack::has_fallen;
use crate::table::{Table, millimetres, three_digits};

/// Masses of the upper cube over that of the lower.
pub const RATIOS: [u64; 9] = [1, 3, 10, 30, 100, 300, 1000, 3000, 10_000];
/// Numbers of sweeps that are tried.
pub const SWEEPS: [u32; 6] = [2, 8, 16, 32, 128, 512];
/// A heavy cube that sinks further than this isn't held, m: 1 % of its edge.
pub const HELD: f64 = 0.01;

/// A pair after ten seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The method.
    pub method: &'static str,
    /// Sweeps in each step.
    pub sweeps: u32,
    /// Mass of the upper cube over that of the lower.
    pub ratio: u64,
    /// The most that the upper cube was lower than it should, m; not finite where it has fallen.
    pub sink: f64,
    /// The most that it was tilted, rad; not finite where it has fallen.
    pub tilt: f64,
    /// Median time of a step, ms.
    pub median_ms: f64,
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let mut pairs = Vec::new();
    for (method, sweeps) in kinds().filter(|&(_, sweeps)| !quick || sweeps <= 32) {
        for ratio in RATIOS {
            pairs.push(stacked(method, sweeps, ratio)?);
        }
        say(&format!("{method}, {sweeps} sweeps"));
    }
    Ok(Product {
        charts: vec![sinks(&pairs).into(), map(&pairs).into()],
        csv: csv(&pairs),
        page: Some(page(&pairs)),
    })
}

/// The methods with their sweeps.
fn kinds() -> impl Iterator<Item = (&'static str, u32)> {
    let corrected = SWEEPS.map(|sweeps| ("corrected", sweeps));
    [("printed", 1)].into_iter().chain(corrected)
}

/// Puts one on the other and waits for ten seconds.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn stacked(method: &'static str, sweeps: u32, ratio: u64) -> Result<Pair, FindingsError> {
    let scene = builtin::build("heavy_on_light", Some(ratio), None)?;
    let start = scene.bodies[2].position.y;
    let (mut sink, mut tilt) = (0.0, 0.0);
    let mut fell = false;
    let times = lab::run(&scene, &by(method).with_sweeps(sweeps), |now| {
        sink = worst([sink, start - now.state.position[2].y]);
        let up = now.state.orientation[2] * DVec3::Y;
        tilt = worst([tilt, up.angle_between(DVec3::Y)]);
        fell |= has_fallen(&scene, now.state);
    })?;
    let unless_fallen = |value| if fell { f64::INFINITY } else { value };
    Ok(Pair {
        method,
        sweeps,
        ratio,
        sink: unless_fallen(sink),
        tilt: unless_fallen(tilt),
        median_ms: median_ms(&times),
    })
}

/// Sweeps from a cold start that leave 1 % of the error.
#[must_use]
pub fn predicted(ratio: f64) -> f64 {
    0.01f64.ln() / (ratio / (ratio + 1.0)).ln()
}

fn sinks(pairs: &[Pair]) -> Chart {
    let curve = |name: &str, style, (method, sweeps): (&str, u32)| {
        let same = |pair: &&Pair| (pair.method, pair.sweeps) == (method, sweeps);
        let points = pairs.iter().filter(same);
        Series::new(name, style, points.map(|p| (p.ratio as f64, 1e3 * p.sink)))
    };
    let ratios = RATIOS.map(|ratio| ratio as f64);
    let mut series = vec![curve("printed", Style::Printed, ("printed", 1))];
    let others = [0, 1, 3, 4, 2].into_iter().map(Style::Other);
    let mut others = others.cycle();
    for sweeps in SWEEPS {
        let style = if sweeps == DEFAULT_SWEEPS {
            Style::Corrected
        } else {
            others.next().unwrap_or(Style::Other(0))
        };
        series.push(curve(
            &format!("{sweeps} sweeps"),
            style,
            ("corrected", sweeps),
        ));
    }
    series.retain(|one| !one.points.is_empty());
    series.push(Series::of(
        "1 % of the edge",
        Style::Theory,
        &ratios,
        |_| 1e3 * HELD,
    ));
    Chart {
        name: "mass_ratio",
        title: "A heavy cube on a light one: how far it sinks in 10 s".to_owned(),
        x: Axis::log("mass above / mass below"),
        y: Axis::log("largest sink (mm)").lost("fell"),
        series,
    }
}

fn map(pairs: &[Pair]) -> Chart {
    let some = |name: &str, style, is: fn(&Pair) -> bool| {
        let points = pairs.iter().filter(|pair| is(pair));
        let place = |pair: &Pair| (pair.ratio as f64, f64::from(pair.sweeps));
        Series::new(name, style, points.map(place))
    };
    let ratios = RATIOS.map(|ratio| ratio as f64);
    Chart {
        name: "mass_ratio_map",
        title: "Which heavy cubes are held on 1 kg for 10 s (one sweep: as printed)".to_owned(),
        x: Axis::log("mass above / mass below"),
        y: Axis::log("sweeps"),
        series: vec![
            some("sinks at most 1 %", Style::Marks(0), |p| p.sink <= HELD),
            some("sinks further", Style::Marks(2), |p| {
                p.sink > HELD && p.sink.is_finite()
            }),
            some("falls", Style::Marks(3), |p| !p.sink.is_finite()),
            Series::of(
                "cold start: 1 % of the error left",
                Style::Theory,
                &ratios,
                predicted,
            ),
        ],
    }
}

fn csv(pairs: &[Pair]) -> String {
    let mut text = "method,sweeps,ratio,largest_sink_m,largest_tilt_rad,median_ms\n".to_owned();
    for p in pairs {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{:?},{:?},{:?}",
            p.method, p.sweeps, p.ratio, p.sink, p.tilt, p.median_ms
        );
    }
    text
}

fn page(pairs: &[Pair]) -> String {
    let shown = [1, 10, 100, 1000, 10_000];
    let mut headings = vec![
        "method".to_owned(),
        "sweeps".to_owned(),
        "ms/step".to_owned(),
    ];
    headings.extend(shown.map(|ratio| format!("{ratio} : 1, sunk (mm)")));
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new(&headings);
    for (method, sweeps) in kinds() {
        let same = |p: &&Pair| (p.method, p.sweeps) == (method, sweeps);
        let of: Vec<&Pair> = pairs.iter().filter(same).collect();
        if of.is_empty() {
            continue;
        }
        let is_default = method == "corrected" && sweeps == DEFAULT_SWEEPS;
        let mut cells = vec![
            format!("`{method}`"),
            format!("{sweeps}{}", if is_default { " (default)" } else { "" }),
            three_digits(worst(of.iter().map(|p| p.median_ms))),
        ];
        cells.extend(shown.map(|ratio| {
            let found = of.iter().find(|p| p.ratio == ratio);
            found.map_or("–".to_owned(), |p| {
                if p.sink.is_finite() {
                    millimetres(p.sink)
                } else {
                    "fell".to_owned()
                }
            })
        }));
        table.push(cells);
    }
    let theory = shown[1..]
        .iter()
        .map(|&ratio| format!("{:.0} at {ratio} : 1", predicted(ratio as f64)))
        .collect::<Vec<_>>()
        .join(", ");
    format!(
        "Cubes of 1 m, the lower of 1 kg, touching, μ = 0.5, ten seconds at 60 Hz: the most that the upper \
         one was below its place. From a cold start 1 % of the error is left after {theory} \
         sweeps.\n\n{table}",
        table = table.markdown(1),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prediction_is_that_of_the_reference() {
        assert!((predicted(100.0) - 462.815_785_1).abs() < 1e-6);
        assert!((predicted(1000.0) - 4_607.472_388).abs() < 1e-5);
    }
}
