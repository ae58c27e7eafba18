//! What is plotted under the views: the time of a step, the error of energy, the largest overlap or joint
//! gap; a colour a contender.

use egui::{Color32, Rangef, RichText, Ui};
use egui_plot::{AxisHints, Line, Plot, PlotPoints, uniform_grid_spacer};

use super::Race;
use super::curves::Sample;

/// Height of a plot, points.
const HEIGHT: f32 = 150.0;

/// Labels of an axis come and go at these distances, points.
const LABELS_ACROSS: Rangef = Rangef {
    min: 38.0,
    max: 60.0,
};
const LABELS_UP: Rangef = Rangef {
    min: 13.0,
    max: 20.0,
};

/// Errors below this are drawn as this, m.
const SHORTEST: f64 = 1e-6;

/// Times below this are drawn as this, ms.
const FASTEST: f64 = 1e-4;

/// All of them, side by side.
pub fn show(ui: &mut Ui, race: &mut Race) {
    ui.columns(3, |columns| {
        columns[0].label(RichText::new("time of a step").strong());
        powers(&mut columns[0], "ms", race, FASTEST, time_of, |sample| {
            sample.ms
        });
        columns[1].label(RichText::new("energy error: gained, as a part of the start's").strong());
        energy(&mut columns[1], race);
        errors(&mut columns[2], race);
    });
}

/// The largest gap of a joint or the deepest overlap, as its user wants.
fn errors(ui: &mut Ui, race: &mut Race) {
    let has_joints = !race.scene().joints.is_empty();
    ui.horizontal(|ui| {
        if has_joints {
            ui.selectable_value(&mut race.shows_joints, true, "widest joint");
            ui.selectable_value(&mut race.shows_joints, false, "deepest overlap");
        } else {
            ui.label(RichText::new("deepest overlap").strong());
        }
    });
    let joints = race.shows_joints && has_joints;
    let value = move |sample: &Sample| if joints { sample.joint } else { sample.deepest };
    powers(ui, "errors", race, SHORTEST, length_of, value);
}

/// A plot whose marks up the side are powers of ten.
fn powers(
    ui: &mut Ui,
    name: &str,
    race: &Race,
    least: f64,
    label: fn(f64) -> String,
    value: impl Fn(&Sample) -> Option<f64>,
) {
    let powers = |sample: &Sample| Some(value(sample)?.max(least).log10());
    let curves = curves(race, powers);
    let all = || {
        curves
            .iter()
            .flat_map(|(_, points)| points)
            .map(|point| point[1])
    };
    let low = all().fold(f64::INFINITY, f64::min).floor();
    let high = all().fold(f64::NEG_INFINITY, f64::max).ceil();
    let mut plot = plain(name)
        .y_grid_spacer(uniform_grid_spacer(|_| [1.0, 1.0, 1.0]))
        .custom_y_axes(vec![axis_up(move |value| label(10.0_f64.powf(value)))]);
    if low <= high {
        plot = plot.include_y(low).include_y(high.max(low + 1.0));
    }
    draw(ui, plot, curves);
}

fn energy(ui: &mut Ui, race: &Race) {
    let curves = curves(race, |sample| sample.energy_error);
    let plot = plain("energy")
        .include_y(0.0)
        .y_grid_spacer(uniform_grid_spacer(|grid| {
            [round_step(grid.bounds, 4.0); 3]
        }))
        .custom_y_axes(vec![axis_up(share_of)]);
    draw(ui, plot, curves);
}

type CurveOf = (Color32, Vec<[f64; 2]>);

fn curves(race: &Race, value: impl Fn(&Sample) -> Option<f64>) -> Vec<CurveOf> {
    let of = |runner: &super::runner::Runner| {
        let [r, g, b] = runner.color;
        (Color32::from_rgb(r, g, b), runner.curve.points(&value))
    };
    race.runners.iter().map(of).collect()
}

fn plain(name: &str) -> Plot<'static> {
    Plot::new(name.to_owned())
        .height(HEIGHT)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .include_x(0.0)
        .x_grid_spacer(uniform_grid_spacer(|grid| {
            [round_step(grid.bounds, 5.0); 3]
        }))
        .custom_x_axes(vec![
            AxisHints::new_x()
                .label_spacing(LABELS_ACROSS)
                .formatter(|mark, _| format!("{} s", mark.value)),
        ])
}

fn axis_up(label: impl Fn(f64) -> String + Send + Sync + 'static) -> AxisHints<'static> {
    AxisHints::new_y()
        .label_spacing(LABELS_UP)
        .min_thickness(46.0)
        .formatter(move |mark, _| label(mark.value))
}

fn draw(ui: &mut Ui, plot: Plot, curves: Vec<CurveOf>) {
    plot.show(ui, |plot| {
        for (i, (color, points)) in curves.into_iter().enumerate() {
            let line = Line::new(format!("{i}"), PlotPoints::from(points));
            plot.line(line.color(color).width(1.8));
        }
    });
}

/// A step of 1, 2 or 5 times a power of ten, so that about so many of them go between these bounds.
fn round_step((low, high): (f64, f64), about: f64) -> f64 {
    let exact = ((high - low) / about).max(1e-12);
    let power = 10.0_f64.powf(exact.log10().floor());
    let round = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|step| step * power >= exact);
    round.unwrap_or(10.0) * power
}

/// A part of 1 as an axis says it.
fn share_of(part: f64) -> String {
    match part.abs() {
        0.0 => "0".to_owned(),
        size if (0.01..1000.0).contains(&size) => format!("{:+}", (1e4 * part).round() / 1e4),
        _ => format!("{part:+.0e}"),
    }
}

/// A time in ms as an axis says it.
fn time_of(ms: f64) -> String {
    match ms {
        _ if ms < 0.9e-3 => format!("{:.1} µs", 1e3 * ms),
        _ if ms < 0.9 => format!("{:.0} µs", 1e3 * ms),
        _ if ms < 900.0 => format!("{ms:.0} ms"),
        _ => format!("{:.0} s", 1e-3 * ms),
    }
}

/// A length in m as an axis says it.
fn length_of(metres: f64) -> String {
    match metres {
        _ if metres < 0.9e-3 => format!("{:.0} µm", 1e6 * metres),
        _ if metres < 0.9 => format!("{:.0} mm", 1e3 * metres),
        _ if metres < 900.0 => format!("{metres:.0} m"),
        _ => format!("{metres:.0e} m"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_a_grid_are_round() {
        let steps = [(0.0, 4.0), (-0.95, 0.0), (0.0, 11.0), (0.0, 0.03)];
        let steps = steps.map(|bounds| round_step(bounds, 4.0));
        let expected = [1.0, 0.5, 5.0, 0.01];
        let is_near = |(one, two): (f64, f64)| (one - two).abs() < 1e-9;
        assert!(steps.into_iter().zip(expected).all(is_near), "{steps:?}");
    }

    #[test]
    fn powers_of_ten_have_short_names() {
        let names = [1e-6, 1e-5, 1e-3, 0.01, 0.1, 1.0, 100.0, 1e6].map(length_of);
        let expected = [
            "1 µm", "10 µm", "1 mm", "10 mm", "100 mm", "1 m", "100 m", "1e6 m",
        ];
        assert_eq!(names, expected);
        let names = [1e-4, 1e-3, 0.1, 1.0, 1000.0].map(time_of);
        assert_eq!(
            [0.5, -0.02, 0.0, 2e-5, 3e6].map(share_of),
            ["+0.5", "-0.02", "0", "+2e-5", "+3e6"]
        );
        assert_eq!(names, ["0.1 µs", "1 µs", "100 µs", "1 ms", "1 s"]);
    }
}
