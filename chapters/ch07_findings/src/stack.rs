//! How many cubes stand on each other (scenario 20): towers of 1 to 30 cubes of 1 m for ten
//! seconds, as printed and with 2 to 32 sweeps. What a tower does that stands is in millimetres:
//! how far its top has moved sideways and sunk.
//!
//! One sweep from a cold start leaves cos²(π/2n) of the error, so 1 % takes
//! ln 0.01 / ln cos²(π/2n) sweeps. Impulses that are kept from step to step get there in several
//! steps, which is why a tower can stand above that line.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;

use ch00_scenes::{Body, Scene, State, builtin};
use ch03_collision::DEFAULT_SWEEPS;
use glam::DVec3;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, by, worst};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres};

/// Numbers of cubes that are tried.
pub const CUBES: [u64; 13] = [1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30];
/// Numbers of sweeps that are tried.
pub const SWEEPS: [u32; 5] = [2, 4, 8, 16, 32];
/// A cube that is this far from where it was has fallen, or flown, m: half of its edge.
const AWAY: f64 = 0.5;

/// A tower after ten seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tower {
    /// The method.
    pub method: &'static str,
    /// Sweeps in each step.
    pub sweeps: u32,
    /// Number of cubes.
    pub cubes: u64,
    /// How far the top is to the side of where it was, m; not finite where a cube has fallen.
    pub drift: f64,
    /// How much lower than where it was, m; not finite where a cube has fallen.
    pub sink: f64,
    /// Speed of all cubes, root of the mean square over the last second, m/s.
    pub speed: f64,
}

impl Tower {
    /// Whether every cube is still in its place.
    #[must_use]
    pub fn stands(&self) -> bool {
        self.drift.is_finite()
    }
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let highest = if quick { 12 } else { 30 };
    let mut towers = Vec::new();
    let printed = [("printed", 1)];
    for (method, sweeps) in printed.into_iter().chain(SWEEPS.map(|n| ("corrected", n))) {
        for cubes in CUBES.into_iter().filter(|&cubes| cubes <= highest) {
            towers.push(built(method, sweeps, cubes, 10.0)?);
        }
        say(&format!("{method}, {sweeps} sweeps"));
    }
    Ok(Product {
        charts: vec![map(&towers).into(), moved(&towers).into()],
        csv: csv(&towers),
        page: Some(page(&towers)),
    })
}

/// Builds a tower and waits for some seconds.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn built(
    method: &'static str,
    sweeps: u32,
    cubes: u64,
    seconds: f64,
) -> Result<Tower, FindingsError> {
    let scene = lab::at_rate(builtin::build("stack", Some(cubes), None)?, 60.0, seconds);
    let top = scene.bodies.len() - 1;
    let mut tower = Tower {
        method,
        sweeps,
        cubes,
        drift: 0.0,
        sink: 0.0,
        speed: 0.0,
    };
    let (mut squares, mut count) = (0.0, 0.0);
    lab::run(&scene, &by(method).with_sweeps(sweeps), |now| {
        if now.step + 60 > scene.steps {
            let speeds = now.state.linear_velocity[1..].iter();
            squares += speeds.map(|v| v.length_squared()).sum::<f64>();
            count += cubes as f64;
        }
        if now.step == scene.steps {
            let moved = now.state.position[top] - scene.bodies[top].position;
            tower.drift = moved.with_y(0.0).length();
            tower.sink = -moved.y;
            if has_fallen(&scene, now.state) {
                (tower.drift, tower.sink) = (f64::INFINITY, f64::INFINITY);
            }
        }
    })?;
    tower.speed = (squares / count).sqrt();
    Ok(tower)
}

/// Whether some body has left its place, or is nowhere.
pub(crate) fn has_fallen(scene: &Scene, state: &State) -> bool {
    let moved = |(body, p): (&Body, &DVec3)| body.position.distance(*p);
    let furthest = worst(scene.bodies.iter().zip(&state.position).map(moved));
    furthest.is_nan() || furthest > AWAY
}

/// The most cubes of which so many sweeps from a cold start leave 1 % of the error.
#[must_use]
pub fn predicted(sweeps: f64) -> f64 {
    let left = 0.01f64.powf(0.5 / sweeps);
    FRAC_PI_2 / left.acos()
}

/// The highest tower that stands with all that are lower; 0 if none.
#[must_use]
pub fn highest(towers: &[Tower], method: &str, sweeps: u32) -> u64 {
    let of = |tower: &&Tower| tower.method == method && tower.sweeps == sweeps;
    let standing = towers.iter().filter(of).take_while(|tower| tower.stands());
    standing.map(|tower| tower.cubes).last().unwrap_or(0)
}

fn map(towers: &[Tower]) -> Chart {
    let some = |name: &str, style, is: fn(&Tower) -> bool| {
        let points = towers.iter().filter(|tower| is(tower));
        let place = |tower: &Tower| (f64::from(tower.sweeps), tower.cubes as f64);
        Series::new(name, style, points.map(place))
    };
    let places: Vec<f64> = (0..=50).map(|k| 2f64.powf(0.1 * f64::from(k))).collect();
    Chart {
        name: "stack",
        title: "Which towers of cubes stand for 10 s (one sweep: as printed)".to_owned(),
        x: Axis::log("sweeps"),
        y: Axis::linear("cubes"),
        series: vec![
            some("stands", Style::Marks(0), Tower::stands),
            some("falls", Style::Marks(3), |tower| !tower.stands()),
            Series::of(
                "cold start: 1 % of the error left",
                Style::Theory,
                &places,
                predicted,
            ),
        ],
    }
}

fn moved(towers: &[Tower]) -> Chart {
    let curve = |name: &str, style, method: &str, sweeps: u32, of: fn(&Tower) -> f64| {
        let same = |tower: &&Tower| tower.method == method && tower.sweeps == sweeps;
        let some = towers.iter().filter(same);
        Series::new(name, style, some.map(|t| (t.cubes as f64, 1e3 * of(t))))
    };
    let n = DEFAULT_SWEEPS;
    Chart {
        name: "stack_drift",
        title: format!("The top of a tower after 10 s, printed and with {n} sweeps"),
        x: Axis::linear("cubes"),
        y: Axis::log("moved (mm)").lost("fell"),
        series: vec![
            curve("printed, sunk", Style::Printed, "printed", 1, |t| t.sink),
            curve("printed, sideways", Style::Other(2), "printed", 1, |t| {
                t.drift
            }),
            curve("corrected, sunk", Style::Corrected, "corrected", n, |t| {
                t.sink
            }),
            curve(
                "corrected, sideways",
                Style::Other(3),
                "corrected",
                n,
                |t| t.drift,
            ),
        ],
    }
}

fn csv(towers: &[Tower]) -> String {
    let mut text = "method,sweeps,cubes,stands,top_drift_m,top_sink_m,speed_rms_m_s\n".to_owned();
    for t in towers {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{:?},{:?},{:?}",
            t.method,
            t.sweeps,
            t.cubes,
            t.stands(),
            t.drift,
            t.sink,
            t.speed
        );
    }
    text
}

/// A row a method, and what became of towers of 5, 10, 15 … cubes.
fn page(towers: &[Tower]) -> String {
    let shown = [5, 10, 15, 20, 30];
    let mut headings = vec![
        "method".to_owned(),
        "sweeps".to_owned(),
        "stands".to_owned(),
    ];
    headings.extend(shown.map(|cubes| format!("{cubes} cubes: sunk / sideways (mm)")));
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new(&headings);
    let kinds = [("printed", 1)].into_iter();
    for (method, sweeps) in kinds.chain(SWEEPS.map(|n| ("corrected", n))) {
        let find = |cubes: u64| {
            let same = |t: &&Tower| (t.method, t.sweeps, t.cubes) == (method, sweeps, cubes);
            towers.iter().find(same)
        };
        let is_default = method == "corrected" && sweeps == DEFAULT_SWEEPS;
        let mut cells = vec![
            format!("`{method}`"),
            format!("{sweeps}{}", if is_default { " (default)" } else { "" }),
            highest(towers, method, sweeps).to_string(),
        ];
        cells.extend(shown.map(|cubes| match find(cubes) {
            None => "–".to_owned(),
            Some(tower) if !tower.stands() => "fell".to_owned(),
            Some(tower) => format!("{} / {}", millimetres(tower.sink), millimetres(tower.drift)),
        }));
        table.push(cells);
    }
    format!(
        "Cubes of 1 m and 1 kg, touching, μ = 0.5, ten seconds at 60 Hz. Stands: the most cubes that are \
         all in their places then, with every lower tower that was tried ({tried}). Sunk, sideways: the top \
         cube.\n\n{table}",
        tried = CUBES.map(|n| n.to_string()).join(", "),
        table = table.markdown(1),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fifteen_cubes_need_419_sweeps_from_a_cold_start() {
        assert!(
            (predicted(419.2) - 15.0).abs() < 1e-3,
            "{}",
            predicted(419.2)
        );
    }

    #[test]
    fn a_tower_that_stands_above_one_that_falls_does_not_count() {
        let tower = |cubes, drift| Tower {
            method: "corrected",
            sweeps: 8,
            cubes,
            drift,
            sink: 0.0,
            speed: 0.0,
        };
        let towers = [
            tower(1, 0.0),
            tower(2, 0.1),
            tower(3, f64::INFINITY),
            tower(4, 0.0),
        ];
        assert_eq!(highest(&towers, "corrected", 8), 2);
        assert_eq!(highest(&towers, "printed", 1), 0);
    }
}
