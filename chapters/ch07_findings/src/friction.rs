//! Friction against its exact solutions (scenarios 13 to 16) for steps of 1/30 to 1/480 s: a ball
//! that slips comes to roll, balls roll and slip down slopes, boxes stick and slip on slopes about the
//! angle of friction, boxes slide to rest in all directions, and balls meet obliquely.
//!
//! The printed method has no friction, so this is the corrected one alone.

use std::fmt::Write as _;

use ch00_scenes::{Scene, State, builtin};
use glam::DVec3;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::lab::{self, by, worst};
use crate::product::{Product, Say};
use crate::table::{Table, percent};

/// Steps a second.
pub const RATES: [f64; 5] = [30.0, 60.0, 120.0, 240.0, 480.0];
/// m/s².
const G: f64 = 9.81;
/// Between two directions of `slide`, degrees.
const BETWEEN: f64 = 7.5;

/// A number that is known exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// What it is.
    pub what: &'static str,
    /// Steps a second.
    pub rate: f64,
    /// Its error over its exact value.
    pub error: f64,
}

/// Where a box of `slide` stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Steps a second.
    pub rate: f64,
    /// Direction of its start, degrees from x.
    pub angle: f64,
    /// How far it came, over v²/(2μg).
    pub distance: f64,
    /// How far to the side, over the same.
    pub sideways: f64,
    /// How much it turned about the vertical, rad.
    pub yaw: f64,
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be loaded.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    let (mut checks, mut stops) = (Vec::new(), Vec::new());
    for rate in RATES {
        let now = slides(rate)?;
        checks.extend(slip_to_roll(rate)?);
        checks.extend(slopes(rate)?);
        checks.extend(incline(rate)?);
        checks.push(slide_error(rate, &now));
        checks.extend(oblique(rate)?);
        stops.extend(now);
        say(&format!("{rate} Hz"));
    }
    Ok(Product {
        charts: vec![errors(&checks).into(), directions(&stops).into()],
        csv: csv(&checks, &stops),
        page: Some(page(&checks, &stops)),
    })
}

/// Runs a built-in scene and gives its state at the end.
fn after(scene: &Scene) -> Result<State, FindingsError> {
    let mut last = State::default();
    lab::run(scene, &by("corrected"), |now| {
        if now.step == scene.steps {
            last.clone_from(now.state);
        }
    })?;
    Ok(last)
}

fn built(name: &str, rate: f64, seconds: f64) -> Result<Scene, FindingsError> {
    Ok(lab::at_rate(
        builtin::build(name, None, None)?,
        rate,
        seconds,
    ))
}

/// |value − exact| over |exact|.
fn check(what: &'static str, rate: f64, value: f64, exact: f64) -> Check {
    Check {
        what,
        rate,
        error: (value - exact).abs() / exact.abs(),
    }
}

/// Scenario 13 after a second: 20/7 m/s, 40/7 rad/s, 3.079 046 093 m.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn slip_to_roll(rate: f64) -> Result<[Check; 3], FindingsError> {
    let last = after(&built("slip_to_roll", rate, 1.0)?)?;
    let (v0, mu) = (4.0, 0.3);
    let slip = 2.0 * v0 / (7.0 * mu * G);
    let v = 5.0 / 7.0 * v0;
    let x = v0 * slip - 0.5 * mu * G * slip * slip + v * (1.0 - slip);
    Ok([
        check("slip to roll: speed", rate, last.linear_velocity[1].x, v),
        check(
            "slip to roll: spin",
            rate,
            last.angular_velocity[1].z,
            -v / 0.5,
        ),
        check("slip to roll: distance", rate, last.position[1].x, x),
    ])
}

/// Scenario 14 A after a second: ½ · 5/7 g sin 20° down the slope, and ½ g (sin 60° − μ cos 60°).
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn slopes(rate: f64) -> Result<[Check; 4], FindingsError> {
    let scene = built("slopes", rate, 1.0)?;
    let last = after(&scene)?;
    let way = |ball: usize| last.position[ball].distance(scene.bodies[ball].position);
    let spin = |ball: usize| last.angular_velocity[ball].length();
    let (gentle, steep) = (20f64.to_radians(), 60f64.to_radians());
    let rolls = 5.0 / 7.0 * G * gentle.sin();
    let slips = G * (steep.sin() - 0.3 * steep.cos());
    Ok([
        check("rolls down 20°: distance", rate, way(1), 0.5 * rolls),
        check("rolls down 20°: spin", rate, spin(1), rolls / 0.5),
        check("slips down 60°: distance", rate, way(3), 0.5 * slips),
        check(
            "slips down 60°: spin",
            rate,
            spin(3),
            2.5 * 0.3 * G * steep.cos() / 0.5,
        ),
    ])
}

/// Boxes 0.5° below and above the angle of friction, after two seconds: the lower one stays, the
/// upper one slips. What the lower one creeps is given over what the upper one slips.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn incline(rate: f64) -> Result<[Check; 3], FindingsError> {
    let scene = built("incline", rate, 2.0)?;
    let last = after(&scene)?;
    let way = |block: usize| last.position[block].distance(scene.bodies[block].position);
    let slips = |above: f64| {
        let angle = 0.5f64.atan() + above.to_radians();
        0.5 * 4.0 * G * (angle.sin() - 0.5 * angle.cos())
    };
    Ok([
        Check {
            what: "box 0.5° below the angle of friction: creep",
            rate,
            error: way(3) / slips(0.5),
        },
        check("box 0.5° above: distance", rate, way(5), slips(0.5)),
        check("box 2° above: distance", rate, way(7), slips(2.0)),
    ])
}

/// Scenario 15: where the boxes of `slide` stop, over 1.630 988 787 m.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn slides(rate: f64) -> Result<Vec<Stop>, FindingsError> {
    let scene = built("slide", rate, 1.5)?;
    let last = after(&scene)?;
    let exact = 16.0 / (2.0 * 0.5 * G);
    let stop = |k: usize| {
        let start = &scene.bodies[k];
        let ahead = start.linear_velocity.normalize();
        let way = last.position[k] - start.position;
        let turned = start.orientation.conjugate() * last.orientation[k];
        Stop {
            rate,
            angle: BETWEEN * (k - 1) as f64,
            distance: way.dot(ahead) / exact,
            sideways: way.dot(ahead.cross(DVec3::Y)) / exact,
            yaw: 2.0 * turned.y.atan2(turned.w),
        }
    };
    Ok((1..scene.bodies.len()).map(stop).collect())
}

/// The worst direction.
fn slide_error(rate: f64, stops: &[Stop]) -> Check {
    Check {
        what: "box slides to rest: distance, worst direction",
        rate,
        error: worst(stops.iter().map(|stop| (stop.distance - 1.0).abs())),
    }
}

/// Scenario 16: velocities after the impacts, each over the speed that the pair had.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn oblique(rate: f64) -> Result<[Check; 3], FindingsError> {
    let mut scene = built("oblique", rate, 0.2)?;
    // Built for 60 Hz: the balls meet at the end of the first step.
    for body in &mut scene.bodies {
        body.position += body.linear_velocity * (1.0 / 60.0 - scene.dt);
    }
    let last = after(&scene)?;
    let (v, w) = (&last.linear_velocity, &last.angular_velocity);
    let vector = DVec3::new;
    // Off by so much: velocities in m/s, spins as speeds of the surfaces.
    let error = |i: usize, expected: [DVec3; 4]| {
        let [v1, v2, w1, w2] = expected;
        let off = [
            v[i].distance(v1),
            v[i + 1].distance(v2),
            0.1 * w[i].distance(w1),
            0.2 * w[i + 1].distance(w2),
        ];
        worst(off) / scene.bodies[i].linear_velocity.length()
    };
    let what = |what, error| Check { what, rate, error };
    Ok([
        what(
            "oblique impact that sticks: velocities",
            error(
                0,
                [
                    vector(-1.8, 5.0 / 7.0, 0.0),
                    vector(1.4, 1.0 / 7.0, 0.0),
                    DVec3::Z * (-15.0 / 7.0),
                    DVec3::Z * (-25.0 / 14.0),
                ],
            ),
        ),
        what(
            "oblique impact that slips: velocities",
            error(
                2,
                [
                    vector(-1.8, 3.52, 1.0),
                    vector(1.4, 0.24, 0.0),
                    vector(0.0, 10.0, -7.0),
                    DVec3::Z * -3.0,
                ],
            ),
        ),
        what(
            "head-on impact: velocities",
            error(
                4,
                [
                    vector(-1.8, 0.0, 0.0),
                    vector(1.4, 0.0, 0.0),
                    DVec3::ZERO,
                    DVec3::ZERO,
                ],
            ),
        ),
    ])
}

/// Stopping distance over exact of a friction that is limited along x and z by itself.
#[must_use]
pub fn pyramid(degrees: f64) -> f64 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    (cos.powi(4) + sin.powi(4)).sqrt()
}

fn errors(checks: &[Check]) -> Chart {
    let shown = [
        ("slip to roll: speed", Style::Corrected),
        ("slip to roll: distance", Style::Other(3)),
        ("rolls down 20°: distance", Style::Other(0)),
        ("slips down 60°: distance", Style::Other(1)),
        (
            "box slides to rest: distance, worst direction",
            Style::Other(2),
        ),
        ("oblique impact that sticks: velocities", Style::Other(4)),
    ];
    let mut series: Vec<Series> = shown
        .into_iter()
        .map(|(what, style)| {
            let same = checks.iter().filter(|check| check.what == what);
            Series::new(what, style, same.map(|c| (c.rate.recip(), c.error)))
        })
        .collect();
    let steps = RATES.map(f64::recip);
    series.push(Series::of("1 %", Style::Theory, &steps, |_| 0.01));
    Chart {
        name: "friction",
        title: "Friction against exact solutions".to_owned(),
        x: Axis::log("time step (s)"),
        y: Axis::log("relative error"),
        series,
    }
}

fn directions(stops: &[Stop]) -> Chart {
    let fine: Vec<f64> = (0..=90).map(f64::from).collect();
    let curve = |rate: f64, style| {
        let same = stops.iter().filter(|stop| stop.rate == rate);
        let name = format!("corrected, {rate} Hz");
        Series::new(&name, style, same.map(|stop| (stop.angle, stop.distance)))
    };
    Chart {
        name: "friction_directions",
        title: "How far a box slides, by direction".to_owned(),
        x: Axis::linear("direction (degrees from x)"),
        y: Axis::linear("distance / (v²/2μg)"),
        series: vec![
            curve(30.0, Style::Other(0)),
            curve(60.0, Style::Corrected),
            curve(480.0, Style::Other(3)),
            Series::of(
                "theory: a cone and, below, a pyramid",
                Style::Theory,
                &fine,
                |_| 1.0,
            ),
            Series::of("", Style::Theory, &fine, pyramid),
        ],
    }
}

fn csv(checks: &[Check], stops: &[Stop]) -> String {
    let mut text = "what,rate_hz,relative_error\n".to_owned();
    for c in checks {
        // Writing into a String can't fail.
        let what = draw::quoted(c.what);
        let _ = writeln!(text, "{what},{:?},{:?}", c.rate, c.error);
    }
    text += "\nrate_hz,direction_degrees,distance_over_exact,sideways_over_exact,yaw_rad\n";
    for s in stops {
        let _ = writeln!(
            text,
            "{:?},{:?},{:?},{:?},{:?}",
            s.rate, s.angle, s.distance, s.sideways, s.yaw
        );
    }
    text
}

fn page(checks: &[Check], stops: &[Stop]) -> String {
    let rates = RATES.map(|rate| format!("{rate} Hz"));
    let mut headings = vec!["relative error of"];
    headings.extend(rates.iter().map(String::as_str));
    let mut table = Table::new(&headings);
    let first = checks.iter().filter(|check| check.rate == RATES[0]);
    for what in first.map(|check| check.what) {
        let mut cells = vec![what.to_owned()];
        let same = checks.iter().filter(|check| check.what == what);
        cells.extend(same.map(|check| percent(check.error)));
        table.push(cells);
    }
    for (what, of) in [
        (
            "box slides to rest: sideways",
            (|stop| stop.sideways.abs()) as fn(&Stop) -> f64,
        ),
        ("box slides to rest: turned (of a radian)", |stop| {
            stop.yaw.abs()
        }),
    ] {
        let mut cells = vec![what.to_owned()];
        cells.extend(RATES.map(|rate| {
            let same = stops.iter().filter(|stop| stop.rate == rate);
            percent(worst(same.map(of)))
        }));
        table.push(cells);
    }
    format!(
        "Method `corrected`. Speeds and distances over their exact values; what creeps over what its neighbour \
         slips; velocities after an impact over the first ball's speed before it.\n\n{table}",
        table = table.markdown(1),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pyramid_is_that_of_the_reference() {
        let exact = 1.630_988_787;
        assert!((exact * pyramid(22.5) - 1.412_477_723).abs() < 1e-8);
        assert!((exact * pyramid(45.0) - 1.153_283_231).abs() < 1e-8);
    }
}
