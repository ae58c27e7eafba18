//! Which share of fast balls gets through a thin wall (scenario 23): r = 0.1 m, w = 0.1 m, a thousand
//! random phases, 1 to 300 m/s; and how the speed at which the first one gets through depends on the
//! step.
//!
//! With s = v Δt, a ball isn't seen in the wall at all by the share P₁ = max(0, 1 − (2r + w)/s) of the
//! phases, and is first seen beyond the middle, whence the shortest way out is the far side, by
//! P₂ = max(0, 1 − (r + w/2)/s). The corrected method looks at walls that are m away, too: it doesn't see
//! the share max(0, 1 − (2r + w + 2m)/s).

use std::fmt::Write as _;

use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Body, Scene, Shape};
use ch03_collision::Rules;
use glam::DVec3;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::lab::{self, METHODS, by};
use crate::product::{Product, Say};
use crate::table::{Table, percent, three_digits};

/// m.
const RADIUS: f64 = 0.1;
/// Thickness of the wall, m.
const WALL: f64 = 0.1;
/// Between neighbours, m.
const SPACING: f64 = 0.5;
/// Speeds, m/s.
pub const SPEEDS: [f64; 22] = [
    1.0, 2.0, 3.0, 4.5, 6.0, 7.5, 9.0, 10.5, 12.0, 15.0, 18.0, 21.0, 24.0, 30.0, 40.0, 50.0, 60.0,
    80.0, 100.0, 150.0, 200.0, 300.0,
];
/// Steps a second at which the fastest safe speed is looked for.
pub const RATES: [f64; 8] = [5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 180.0, 240.0];
/// Steps before the wall: in none of them is a ball near it.
const STEPS_BEFORE: f64 = 3.0;
/// Steps in which who is in the wall comes out of it, on either side.
const STEPS_AFTER: u32 = 30;

/// Balls of one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The method.
    pub method: &'static str,
    /// Steps a second.
    pub rate: f64,
    /// m/s.
    pub speed: f64,
    /// How many flew at the wall.
    pub balls: u32,
    /// How many got through.
    pub through: u32,
}

impl Sample {
    /// The share that got through.
    #[must_use]
    pub fn share(&self) -> f64 {
        f64::from(self.through) / f64::from(self.balls)
    }

    /// Where the true share lies, 95 times of 100 [Wilson 1927].
    #[must_use]
    pub fn bar(&self) -> (f64, f64) {
        const Z: f64 = 1.96;
        let (n, p) = (f64::from(self.balls), self.share());
        let middle = p + Z * Z / (2.0 * n);
        let half = Z * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
        let scale = 1.0 + Z * Z / n;
        let low = ((middle - half) / scale).max(0.0);
        let high = ((middle + half) / scale).min(1.0);
        (low, high)
    }
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let balls = if quick { 200 } else { 1000 };
    let mut samples = Vec::new();
    let mut edges = Vec::new();
    for (method, _) in METHODS {
        for speed in SPEEDS {
            samples.push(shot(method, 60.0, speed, balls)?);
        }
        say(&format!("{method}, shares"));
        for rate in RATES {
            edges.push((method, rate, fastest_held(method, rate, balls)?));
        }
        say(&format!("{method}, fastest that is held"));
    }
    Ok(Product {
        charts: vec![shares(&samples).into(), by_rate(&edges).into()],
        csv: csv(&samples, &edges),
        page: Some(page(&samples, &edges)),
    })
}

/// Balls that all reach the wall in the same step, each at its own part of it, far apart.
fn scene(rate: f64, speed: f64, balls: u32) -> Scene {
    let mut random = SplitMix64::new((speed * rate).to_bits());
    let mut scene = Scene::new("tunnelling");
    scene.gravity = DVec3::ZERO;
    scene.restitution_threshold = Some(0.0);
    scene.dt = rate.recip();
    scene.steps = STEPS_BEFORE as u32 + 1 + STEPS_AFTER;
    let row = f64::from(balls).sqrt().ceil();
    let width = SPACING * row;
    let half_extents = DVec3::new(WALL, width, width) / 2.0;
    let wall = Body::new(Shape::Box { half_extents }, 0.0, DVec3::ZERO);
    scene.bodies.push(wall);
    for k in 0..balls {
        let (y, z) = (f64::from(k) % row, (f64::from(k) / row).floor());
        let before = (STEPS_BEFORE + random.unit()) * speed * scene.dt;
        let place = DVec3::new(
            -(RADIUS + WALL / 2.0) - before,
            SPACING * (y + 0.5) - width / 2.0,
            SPACING * (z + 0.5) - width / 2.0,
        );
        let shape = Shape::Sphere { radius: RADIUS };
        scene.bodies.push(Body {
            linear_velocity: DVec3::X * speed,
            friction: 0.0,
            ..Body::new(shape, 1.0, place)
        });
    }
    scene
}

/// Shoots balls at the wall.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn shot(
    method: &'static str,
    rate: f64,
    speed: f64,
    balls: u32,
) -> Result<Sample, FindingsError> {
    let scene = scene(rate, speed, balls);
    let mut through = 0;
    lab::run(&scene, &by(method), |now| {
        if now.step == scene.steps {
            let held = |p: &&DVec3| p.x < -WALL / 2.0;
            through = balls - now.state.position[1..].iter().filter(held).count() as u32;
        }
    })?;
    Ok(Sample {
        method,
        rate,
        speed,
        balls,
        through,
    })
}

/// The share that isn't seen.
#[must_use]
pub fn unseen(speed: f64, rate: f64) -> f64 {
    (1.0 - (2.0 * RADIUS + WALL) * rate / speed).max(0.0)
}

/// How far from a wall the corrected method sees it, m.
pub(crate) fn margin() -> f64 {
    let rules = Rules {
        restitution_threshold: 0.0,
        ..Rules::default()
    };
    f64::from(rules.margins(1.0 / 60.0).obstacle)
}

/// The share that a method with a margin doesn't see.
#[must_use]
pub fn unseen_from_afar(speed: f64, rate: f64) -> f64 {
    (1.0 - (2.0 * (RADIUS + margin()) + WALL) * rate / speed).max(0.0)
}

/// The share that isn't seen before the middle.
#[must_use]
pub fn crosses(speed: f64, rate: f64) -> f64 {
    (1.0 - (RADIUS + WALL / 2.0) * rate / speed).max(0.0)
}

/// The fastest speed of which no ball gets through, m/s, to one part in 64 of (2r + w)/Δt; infinite
/// where that is more than 16 times that speed.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn fastest_held(method: &'static str, rate: f64, balls: u32) -> Result<f64, FindingsError> {
    let unit = (2.0 * RADIUS + WALL) * rate;
    let is_held =
        |speed: f64| Ok::<_, FindingsError>(shot(method, rate, speed, balls)?.through == 0);
    let (mut held, mut lost) = (0.0, unit / 8.0);
    while is_held(lost)? {
        (held, lost) = (lost, 2.0 * lost);
        if lost > 16.0 * unit {
            return Ok(f64::INFINITY);
        }
    }
    while lost - held > unit / 64.0 {
        let middle = 0.5 * (held + lost);
        if is_held(middle)? {
            held = middle;
        } else {
            lost = middle;
        }
    }
    Ok(held)
}

fn shares(samples: &[Sample]) -> Chart {
    let fine: Vec<f64> = (0..=150)
        .map(|k| 300f64.powf(f64::from(k) / 150.0))
        .collect();
    let mut series: Vec<Series> = METHODS
        .into_iter()
        .map(|(method, style)| {
            let of = || samples.iter().filter(move |sample| sample.method == method);
            let points = of().map(|sample| (sample.speed, sample.share()));
            Series::new(method, style, points).with_bars(of().map(Sample::bar).collect())
        })
        .collect();
    series.extend([
        Series::of(
            "theory, from the left: P₂, P₁, P₁ with the margin",
            Style::Theory,
            &fine,
            |v| crosses(v, 60.0),
        ),
        Series::of("", Style::Theory, &fine, |v| unseen(v, 60.0)),
        Series::of("", Style::Theory, &fine, |v| unseen_from_afar(v, 60.0)),
    ]);
    Chart {
        name: "tunnelling",
        title: "Balls of 0.1 m that get through a wall of 0.1 m, 60 Hz, 95 % bars".to_owned(),
        x: Axis::log("speed (m/s)"),
        y: Axis::linear("share that gets through"),
        series,
    }
}

fn by_rate(edges: &[(&'static str, f64, f64)]) -> Chart {
    let mut series: Vec<Series> = METHODS
        .into_iter()
        .map(|(method, style)| {
            let of = edges.iter().filter(|edge| edge.0 == method);
            Series::new(method, style, of.map(|&(_, rate, speed)| (rate, speed)))
        })
        .collect();
    series.extend([
        Series::of(
            "theory, from below: (r + w/2)/Δt, (2r + w)/Δt, (2r + w + 2m)/Δt",
            Style::Theory,
            &RATES,
            |rate| (RADIUS + WALL / 2.0) * rate,
        ),
        Series::of("", Style::Theory, &RATES, |rate| {
            (2.0 * RADIUS + WALL) * rate
        }),
        Series::of("", Style::Theory, &RATES, |rate| {
            (2.0 * (RADIUS + margin()) + WALL) * rate
        }),
    ]);
    Chart {
        name: "tunnelling_rate",
        title: "The fastest balls of which none gets through the wall".to_owned(),
        x: Axis::log("steps a second (Hz)"),
        y: Axis::log("speed (m/s)").lost("all held"),
        series,
    }
}

fn csv(samples: &[Sample], edges: &[(&'static str, f64, f64)]) -> String {
    let mut text = "method,rate_hz,speed_m_s,balls,through,share,low_95,high_95\n".to_owned();
    for s in samples {
        let (low, high) = s.bar();
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{:?},{:?},{},{},{:?},{low:?},{high:?}",
            s.method,
            s.rate,
            s.speed,
            s.balls,
            s.through,
            s.share()
        );
    }
    text += "\nmethod,rate_hz,fastest_held_m_s\n";
    for (method, rate, speed) in edges {
        let _ = writeln!(text, "{method},{rate:?},{speed:?}");
    }
    text
}

fn page(samples: &[Sample], edges: &[(&'static str, f64, f64)]) -> String {
    let mut table = Table::new(&[
        "speed (m/s)",
        "P₁",
        "P₁ with the margin",
        "P₂",
        "`printed`",
        "`corrected`",
    ]);
    for speed in [9.0, 12.0, 18.0, 30.0, 60.0, 100.0, 300.0] {
        let mut cells = vec![
            three_digits(speed),
            percent(unseen(speed, 60.0)),
            percent(unseen_from_afar(speed, 60.0)),
            percent(crosses(speed, 60.0)),
        ];
        for (method, _) in METHODS {
            let same = |s: &&Sample| s.method == method && s.speed == speed;
            let found = samples.iter().find(same);
            cells.push(found.map_or("–".to_owned(), |s| percent(s.share())));
        }
        table.push(cells);
    }
    let mut fastest = Table::new(&[
        "steps a second",
        "(2r + w)/Δt",
        "(r + w/2)/Δt",
        "`printed` holds up to (m/s)",
        "`corrected`",
    ]);
    for rate in RATES {
        let mut cells = vec![
            three_digits(rate),
            three_digits((2.0 * RADIUS + WALL) * rate),
            three_digits((RADIUS + WALL / 2.0) * rate),
        ];
        cells.extend(METHODS.map(|(method, _)| {
            let found = edges.iter().find(|e| (e.0, e.1) == (method, rate));
            found.map_or("–".to_owned(), |e| three_digits(e.2))
        }));
        fastest.push(cells);
    }
    let balls = samples.first().map_or(0, |sample| sample.balls);
    format!(
        "{balls} balls of 0.1 m at random parts of a step fly straight at a wall of 0.1 m, e = 0; who is not \
         on its own side thirty steps later got through. The margin m of \
         `corrected` is {margin} m. At 60 Hz:\n\n{shares}\n\
         The fastest speed of which none of them gets through, to one part in 64 of \
         (2r + w)/Δt:\n\n{fastest}",
        margin = three_digits(margin()),
        shares = table.markdown(0),
        fastest = fastest.markdown(0),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_theory_is_that_of_the_reference() {
        for (v, p1, p2) in [
            (9.0, 0.0, 0.0),
            (12.0, 0.0, 0.25),
            (18.0, 0.0, 0.5),
            (30.0, 0.4, 0.7),
            (300.0, 0.94, 0.97),
        ] {
            assert!((unseen(v, 60.0) - p1).abs() < 1e-12, "{v}");
            assert!((crosses(v, 60.0) - p2).abs() < 1e-12, "{v}");
        }
    }

    #[test]
    fn a_bar_of_none_of_a_thousand_begins_at_zero() {
        let sample = Sample {
            method: "printed",
            rate: 60.0,
            speed: 1.0,
            balls: 1000,
            through: 0,
        };
        let (low, high) = sample.bar();
        assert_eq!(low, 0.0);
        // Wilson's upper end is z²/(n + z²).
        assert!((high - 3.8416 / 1003.8416).abs() < 1e-12, "{high}");
    }
}
