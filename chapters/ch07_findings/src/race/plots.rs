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

/// An axis up the side, marked at powers of ten.
struct Scale {
    name: &'static str,
    /// What is below or above is drawn at the edge.
    range: [f64; 2],
    label: fn(f64) -> String,
}

/// Of times, ms.
const TIMES: Scale = Scale {
    name: "time of a step",
    range: [1e-4, 1e6],
    label: time_of,
};

/// Of errors of energy, as parts of the start's.
const ENERGIES: Scale = Scale {
    name: "energy error, gained or lost",
    range: [1e-7, 1e3],
    label: part_of,
};

/// Of overlaps and of gaps, m.
const LENGTHS: Scale = Scale {
    name: "deepest overlap",
    range: [1e-6, 1e3],
    label: length_of,
};

/// All of them, side by side.
pub fn show(ui: &mut Ui, race: &mut Race) {
    ui.columns(3, |columns| {
        headline(&mut columns[0], &TIMES);
        plot(&mut columns[0], race, &TIMES, |sample| sample.ms);
        headline(&mut columns[1], &ENERGIES);
        plot(&mut columns[1], race, &ENERGIES, |sample| {
            sample.energy_error.map(f64::abs)
        });
        lengths(&mut columns[2], race);
    });
}

fn headline(ui: &mut Ui, scale: &Scale) {
    ui.label(RichText::new(scale.name).strong());
}

/// The widest gap of a joint or the deepest overlap, as its user wants.
fn lengths(ui: &mut Ui, race: &mut Race) {
    let has_joints = !race.scene().joints.is_empty();
    if has_joints {
        ui.horizontal(|ui| {
            ui.selectable_value(&mut race.shows_joints, true, "widest joint");
            ui.selectable_value(&mut race.shows_joints, false, LENGTHS.name);
        });
    } else {
        headline(ui, &LENGTHS);
    }
    let joints = race.shows_joints && has_joints;
    plot(ui, race, &LENGTHS, |sample| {
        if joints { sample.joint } else { sample.deepest }
    });
}

/// A measure of all contenders against time.
fn plot(ui: &mut Ui, race: &Race, scale: &Scale, value: impl Fn(&Sample) -> Option<f64>) {
    let [least, most] = scale.range;
    let power = |sample: &Sample| Some(value(sample)?.clamp(least, most).log10());
    let curves = curves(race, power);
    let powers = || {
        curves
            .iter()
            .flat_map(|(_, points)| points)
            .map(|point| point[1])
    };
    let low = powers().fold(f64::INFINITY, f64::min).floor();
    let high = powers().fold(f64::NEG_INFINITY, f64::max).ceil();
    let mut plot = empty(scale);
    if low <= high {
        plot = plot.include_y(low).include_y(high.max(low + 1.0));
    }
    plot.show(ui, |plot| {
        for (i, (color, points)) in curves.into_iter().enumerate() {
            let line = Line::new(format!("{i}"), PlotPoints::from(points));
            plot.line(line.color(color).width(1.8));
        }
    });
}

/// A plot without curves.
fn empty(scale: &Scale) -> Plot<'static> {
    let label = scale.label;
    let seconds = AxisHints::new_x()
        .label_spacing(LABELS_ACROSS)
        .formatter(|mark, _| format!("{} s", mark.value));
    let powers = AxisHints::new_y()
        .label_spacing(LABELS_UP)
        .min_thickness(46.0)
        .formatter(move |mark, _| label(10.0_f64.powf(mark.value)));
    Plot::new(scale.name)
        .height(HEIGHT)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .include_x(0.0)
        .x_grid_spacer(uniform_grid_spacer(|grid| [round_step(grid.bounds); 3]))
        .y_grid_spacer(uniform_grid_spacer(|grid| [whole_step(grid.bounds); 3]))
        .custom_x_axes(vec![seconds])
        .custom_y_axes(vec![powers])
}

type CurveOf = (Color32, Vec<[f64; 2]>);

fn curves(race: &Race, value: impl Fn(&Sample) -> Option<f64>) -> Vec<CurveOf> {
    let of = |runner: &super::runner::Runner| {
        let [r, g, b] = runner.color;
        (Color32::from_rgb(r, g, b), runner.curve.points(&value))
    };
    race.runners.iter().map(of).collect()
}

/// A step of 1, 2 or 5 times a power of ten, so that about five of them go between these bounds.
fn round_step((low, high): (f64, f64)) -> f64 {
    let exact = ((high - low) / 5.0).max(1e-12);
    let power = 10.0_f64.powf(exact.log10().floor());
    let mut round = [1.0, 2.0, 5.0].into_iter();
    round.find(|step| step * power >= exact).unwrap_or(10.0) * power
}

/// A whole step, so that at most seven of them go between these bounds.
fn whole_step((low, high): (f64, f64)) -> f64 {
    ((high - low) / 7.0).ceil().max(1.0)
}

/// A part of 1 as an axis says it.
fn part_of(part: f64) -> String {
    if (0.9e-2..9e2).contains(&part) {
        format!("{}", (1e4 * part).round() / 1e4)
    } else {
        format!("{part:.0e}")
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
        let steps = [(0.0, 5.0), (0.5, 8.0), (0.0, 11.0), (0.0, 0.03)].map(round_step);
        let expected = [1.0, 2.0, 5.0, 0.01];
        let is_near = |(one, two): (f64, f64)| (one - two).abs() < 1e-9;
        assert!(steps.into_iter().zip(expected).all(is_near), "{steps:?}");
        let steps = [(-3.0, -2.9), (-6.0, 1.0), (-6.0, 3.0)].map(whole_step);
        assert_eq!(steps, [1.0, 1.0, 2.0]);
    }

    #[test]
    fn powers_of_ten_have_short_names() {
        let names = [1e-6, 1e-5, 1e-3, 0.01, 0.1, 1.0, 100.0, 1e6].map(length_of);
        let expected = [
            "1 µm", "10 µm", "1 mm", "10 mm", "100 mm", "1 m", "100 m", "1e6 m",
        ];
        assert_eq!(names, expected);
        let names = [1e-4, 1e-3, 0.1, 1.0, 1000.0].map(time_of);
        assert_eq!(names, ["0.1 µs", "1 µs", "100 µs", "1 ms", "1 s"]);
        let names = [1e-7, 1e-3, 0.01, 1.0, 100.0, 1e3].map(part_of);
        assert_eq!(names, ["1e-7", "1e-3", "0.01", "1", "100", "1e3"]);
    }
}
