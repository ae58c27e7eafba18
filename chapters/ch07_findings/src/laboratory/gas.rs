//! Scenario 18 as a gas: how often its balls collide, and whether their speeds become Maxwell's. No path of it can
//! be compared, since two runs part within a second; what can be is counts and distributions.

pub mod events;

use std::fmt::Write as _;

use ch00_scenes::{Scene, State};
use glam::DVec3;

use super::contenders::{CONTENDERS, Contender, WITH_CCD};
use super::scenario::timed;
use super::scenarios::SCENARIOS;
use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::product::{Product, Say};
use crate::table::{Table, percent, three_digits};
use events::{Gas, Sides};

/// Steps a second.
const RATES: [u32; 4] = [60, 240, 960, 3840];
/// Speeds are looked at once a second, after so many seconds at first: twenty collisions of each ball and more.
const LOOKS: u32 = 6;
/// By chance speeds of Maxwell's are farther from his curve than this over √M in one of twenty cases
/// (Kolmogorov and Smirnov).
const CHANCE: f64 = 1.36;
/// How long the gas without steps is counted, s.
const COUNTED: f64 = 100.0;

/// What a run of the gas shows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shown {
    /// Change of the energy until the end, as a share.
    energy: f64,
    /// Collisions of a ball, 1/s.
    collisions: f64,
    /// The largest distance of the share of balls that are slower from Maxwell's.
    distance: f64,
    /// Mean of v⁴, m⁴/s⁴; Maxwell's is 15.
    fourth: f64,
}

/// Positions, velocities, diameter and half an edge of the room of scenario 18.
#[must_use]
pub fn start() -> (Vec<DVec3>, Vec<DVec3>, f64, f64) {
    let scene = scene(RATES[0]).unwrap_or_else(|_| Scene::new("none"));
    let balls = || scene.bodies.iter().filter(|body| !body.is_static());
    let radius = balls()
        .map(|ball| ball.shape.bounding_radius())
        .fold(0.0, f64::max);
    // The walls are boxes of a metre's thickness about the room.
    let walls = scene.bodies.iter().filter(|body| body.is_static());
    let half = walls
        .map(|wall| wall.position.length() - 0.5)
        .fold(f64::INFINITY, f64::min);
    (
        balls().map(|ball| ball.position).collect(),
        balls().map(|ball| ball.linear_velocity).collect(),
        2.0 * radius,
        half,
    )
}

fn scene(rate: u32) -> Result<Scene, FindingsError> {
    let known = SCENARIOS.iter().find(|known| known.name == "elastic_gas");
    let scenes = known.map_or(Ok(Vec::new()), |known| (known.scenes)(rate, true))?;
    let scene = scenes.into_iter().next();
    Ok(scene.unwrap_or_else(|| Scene::new("elastic_gas")))
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be built.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let rates = if quick { &RATES[..2] } else { &RATES[..] };
    let exact = without_steps(if quick { 10.0 } else { COUNTED });
    say("without steps");
    let mut rows = Vec::new();
    // From 240 Hz on nothing moves far in a step: its curve would be that of rapier without.
    for contender in CONTENDERS.iter().filter(|one| one.name != WITH_CCD) {
        for &rate in rates {
            if let Some(shown) = run(contender, rate)? {
                rows.push((*contender, rate, shown));
            }
        }
        say(contender.name);
    }
    Ok(Product {
        charts: vec![
            chart_of_collisions(&rows, &exact).into(),
            chart_of_speeds(&rows).into(),
        ],
        csv: csv(&rows, &exact),
        page: Some(page(&rows, &exact)),
    })
}

/// The same gas from event to event.
fn without_steps(seconds: f64) -> Shown {
    let (position, velocity, diameter, half) = start();
    let (first, count) = (energy(&velocity), velocity.len() as f64);
    let mut gas = Gas::new(position, velocity, diameter, half, Sides::Walls);
    let mut speeds = Vec::new();
    for _ in 0..LOOKS {
        gas.run(1.0);
        speeds.extend(gas.velocity.iter().map(|v| v.length()));
    }
    let before = gas.collisions;
    gas.run(seconds);
    let collisions = 2.0 * (gas.collisions - before) as f64 / (count * seconds);
    Shown {
        energy: energy(&gas.velocity) / first - 1.0,
        collisions,
        ..of_speeds(speeds)
    }
}

fn energy(velocities: &[DVec3]) -> f64 {
    velocities.iter().map(|v| v.length_squared()).sum()
}

/// None where the contender can't.
fn run(contender: &Contender, rate: u32) -> Result<Option<Shown>, FindingsError> {
    let scene = timed(scene(rate)?, rate, f64::from(LOOKS));
    let Ok(mut engine) = (contender.engine.load)(&scene, &contender.settings()) else {
        return Ok(None);
    };
    let balls = scene.bodies.iter().position(|body| !body.is_static());
    let balls = balls.unwrap_or(0);
    let mut state = State::start_of(&scene);
    let mut last = state.linear_velocity[balls..].to_vec();
    let first = energy(&last);
    let (mut kicked, mut speeds) = (0_u64, Vec::new());
    for step in 1..=scene.steps {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        let now = &state.linear_velocity[balls..];
        kicked += now
            .iter()
            .zip(&last)
            .filter(|(now, last)| was_hit(**last, **now))
            .count() as u64;
        last.copy_from_slice(now);
        if step % rate == 0 {
            speeds.extend(last.iter().map(|v| v.length()));
        }
    }
    let looks = f64::from(scene.steps) * last.len() as f64;
    Ok(Some(Shown {
        energy: energy(&last) / first - 1.0,
        collisions: per_second(kicked as f64 / looks, f64::from(rate)),
        ..of_speeds(speeds)
    }))
}

/// Whether another ball has changed a velocity. A wall turns back one part of it, or several, and changes none.
fn was_hit(before: DVec3, now: DVec3) -> bool {
    (now.abs() - before.abs()).abs().max_element() > 0.01
}

/// Collisions a second where a share of the steps has at least one: chance spreads them, so that a step has
/// none with e^(−Γ Δt).
fn per_second(share: f64, rate: f64) -> f64 {
    -rate * (1.0 - share).ln()
}

/// What speeds show, with kT/m = 1 m²/s².
fn of_speeds(mut speeds: Vec<f64>) -> Shown {
    speeds.sort_unstable_by(f64::total_cmp);
    let count = speeds.len() as f64;
    let distance = speeds.iter().enumerate().map(|(k, &v)| {
        let k = k as f64;
        let share = slower(v);
        (share - k / count)
            .abs()
            .max((share - (k + 1.0) / count).abs())
    });
    Shown {
        energy: 0.0,
        collisions: 0.0,
        distance: crate::lab::worst(distance.collect::<Vec<_>>()),
        fourth: speeds.iter().map(|v| v.powi(4)).sum::<f64>() / count,
    }
}

// ANCHOR: slower
/// Maxwell's share of balls that are slower than v, m/s, where kT/m = 1 m²/s².
fn slower(v: f64) -> f64 {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    libm::erf(v * half) - (2.0 / std::f64::consts::PI).sqrt() * v * (-0.5 * v * v).exp()
}
// ANCHOR_END: slower

type Row = (Contender, u32, Shown);

fn curves(rows: &[Row], of: impl Fn(&Shown) -> f64) -> Vec<Series> {
    let mut series: Vec<Series> = Vec::new();
    for (contender, rate, shown) in rows {
        let point = (f64::from(*rate), of(shown));
        match series.last_mut().filter(|last| last.name == contender.name) {
            Some(last) => last.points.push(point),
            None => series.push(Series::new(contender.name, contender.style, vec![point])),
        }
    }
    series
}

fn ends() -> [f64; 2] {
    [RATES[0], RATES[RATES.len() - 1]].map(f64::from)
}

fn chart_of_collisions(rows: &[Row], exact: &Shown) -> Chart {
    let of = exact.collisions;
    let mut series = curves(rows, |shown| shown.collisions / of);
    series.push(Series::of("without steps", Style::Theory, &ends(), |_| 1.0));
    Chart {
        name: "gas",
        title: format!(
            "18. A gas of 125 balls: collisions, of {of:.1} of a ball a second without steps"
        ),
        x: Axis::log("steps a second (1/s)"),
        y: Axis::log("collisions (share of exact)").lost("NaN"),
        series,
    }
}

fn chart_of_speeds(rows: &[Row]) -> Chart {
    let mut series = curves(rows, |shown| shown.distance);
    series.push(Series::of(
        "one of twenty by chance",
        Style::Theory,
        &ends(),
        |_| by_chance(),
    ));
    Chart {
        name: "gas_speeds",
        title: "18. A gas of 125 balls: how far its speeds are from Maxwell's".to_owned(),
        x: Axis::log("steps a second (1/s)"),
        y: Axis::log("largest difference (share of balls)").lost("NaN"),
        series,
    }
}

fn by_chance() -> f64 {
    CHANCE / f64::from(LOOKS * 125).sqrt()
}

fn csv(rows: &[Row], exact: &Shown) -> String {
    let mut text = "method,rate (1/s),energy change,collisions (1/s),distance from Maxwell's,mean of v⁴ (m⁴/s⁴)\n".to_owned();
    let mut push = |name: &str, rate: &str, s: &Shown| {
        let _ = writeln!(
            text,
            "{name},{rate},{:e},{},{},{}",
            s.energy, s.collisions, s.distance, s.fourth
        );
    };
    push("without steps", "", exact);
    for (contender, rate, shown) in rows {
        push(contender.name, &rate.to_string(), shown);
    }
    text
}

fn page(rows: &[Row], exact: &Shown) -> String {
    let mut table = Table::new(&[
        "method",
        "Hz",
        "energy",
        "collisions (1/s)",
        "of exact",
        "from Maxwell's",
        "",
        "mean of v⁴ (m⁴/s⁴)",
    ]);
    let mut push = |name: &str, rate: String, s: &Shown| {
        let within = if s.distance <= by_chance() {
            "within chance"
        } else {
            ""
        };
        table.push(vec![
            name.to_owned(),
            rate,
            percent(s.energy),
            three_digits(s.collisions),
            percent(s.collisions / exact.collisions),
            three_digits(s.distance),
            within.to_owned(),
            three_digits(s.fourth),
        ]);
    };
    push("without steps", String::new(), exact);
    for (contender, rate, shown) in rows.iter().filter(|row| row.1 != 60) {
        push(contender.name, rate.to_string(), shown);
    }
    format!(
        "{}\nOf {} speeds, Maxwell's own are off by more than {} in one of twenty cases.\n",
        table.markdown(1),
        LOOKS * 125,
        three_digits(by_chance())
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maxwells_shares_are_those_of_the_reference() {
        // 53.305 02 % are slower than the mean speed; and the median is 1.5382 √(kT/m).
        assert!((slower(1.595_769_122) - 0.533_050_206).abs() < 1e-8);
        assert!((slower(1.538_172) - 0.5).abs() < 1e-5);
    }

    #[test]
    fn equal_speeds_are_not_maxwells_but_become_so_without_steps() {
        let equal = of_speeds(vec![3f64.sqrt(); 125]);
        assert!(equal.distance > 0.5 && (equal.fourth - 9.0).abs() < 1e-9);
        let later = without_steps(1.0);
        assert!(later.distance < by_chance(), "{later:?}");
        // ⟨v⁴⟩ of 750 speeds: its own spread is √(945 − 225), a ball.
        let spread = (945.0_f64 - 225.0).sqrt() / 750_f64.sqrt();
        assert!((later.fourth - 15.0).abs() < 3.0 * spread, "{later:?}");
    }

    #[test]
    fn a_wall_is_no_ball_and_many_hits_in_a_step_are_reckoned_with() {
        let before = DVec3::new(1.0, 2.0, 3.0);
        assert!(!was_hit(before, DVec3::new(-1.0, 2.0, -3.0)));
        assert!(was_hit(before, DVec3::new(1.0, 2.5, 2.0)));
        let (gamma, rate) = (30.0_f64, 60.0);
        let share = 1.0 - (-gamma / rate).exp();
        assert!((per_second(share, rate) - gamma).abs() < 1e-9);
    }
}
