//! The charts: a panel an operation, time against N, both axes logarithmic; a line through the medians,
//! and thin ones from the fastest to the slowest run. Mid-tones on nothing, to be read on light and on
//! dark pages; a shape beside each colour, for those who see few colours.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::measure::Row;
use crate::operation::Operation;
use crate::tables::architectures;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Of a panel, and of the legend above them.
const PANEL: (u32, u32) = (360, 250);
const LEGEND: u32 = 34;
const GREY: RGBColor = RGBColor(128, 128, 128);
const COLORS: [RGBColor; 5] = [
    RGBColor(214, 106, 40),
    RGBColor(64, 140, 220),
    RGBColor(60, 160, 90),
    RGBColor(196, 84, 160),
    RGBColor(150, 140, 60),
];

/// Panels side by side, two in a row.
pub fn draw(rows: &[Row], operations: &[Operation], file: &Path) -> Outcome {
    let high = operations.len().div_ceil(2) as u32;
    let size = (2 * PANEL.0, LEGEND + high * PANEL.1);
    let area = SVGBackend::new(file, size).into_drawing_area();
    let (top, below) = area.split_vertically(LEGEND);
    legend(&top, &architectures(rows))?;
    for (operation, area) in operations
        .iter()
        .zip(below.split_evenly((high as usize, 2)))
    {
        panel(&area, rows, *operation)?;
    }
    area.present()?;
    Ok(())
}

fn legend(area: &Area, names: &[&str]) -> Outcome {
    for ((place, name), x) in names.iter().enumerate().zip((60..).step_by(134)) {
        let color = COLORS[place];
        area.draw(&PathElement::new(
            [(x - 14, 18), (x + 14, 18)],
            color.stroke_width(2),
        ))?;
        area.draw(&mark(place, (x, 18)))?;
        area.draw(&Text::new(
            (*name).to_owned(),
            (x + 20, 10),
            ("sans-serif", 15).into_font().color(&GREY),
        ))?;
    }
    Ok(())
}

fn panel(area: &Area, rows: &[Row], operation: Operation) -> Outcome {
    let text = |size: i32| ("sans-serif", size).into_font().color(&GREY);
    let rows: Vec<&Row> = rows
        .iter()
        .filter(|row| row.operation == operation)
        .collect();
    let medians = || rows.iter().map(|row| row.time.median.max(0.01));
    let largest = rows.iter().map(|row| row.count).max().unwrap_or(10) as f64;
    let least = medians().fold(f64::MAX, f64::min) / 2.0;
    let most = medians().fold(0.0, f64::max) * 2.0;
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .margin_right(16)
        .caption(operation.label(), text(15))
        .x_label_area_size(36)
        .y_label_area_size(58)
        .build_cartesian_2d(
            (8.0..largest * 1.2).log_scale(),
            (least..most.max(least * 100.0)).log_scale(),
        )?;
    chart
        .configure_mesh()
        .axis_style(GREY)
        .bold_line_style(GREY.mix(0.25))
        .light_line_style(TRANSPARENT)
        .label_style(text(13))
        .axis_desc_style(text(13))
        .x_desc("objects")
        .y_desc("time")
        .x_label_formatter(&|count| power(*count))
        .y_label_formatter(&|time| duration(*time))
        .draw()?;
    let mut names: Vec<&str> = Vec::new();
    for row in &rows {
        if !names.contains(&row.architecture) {
            names.push(row.architecture);
        }
    }
    for (place, name) in names.iter().enumerate() {
        let of_name = rows.iter().filter(|row| row.architecture == *name);
        let line: Vec<(f64, f64)> = of_name
            .map(|row| (row.count as f64, row.time.median.max(0.01)))
            .collect();
        let color = COLORS[place];
        chart.draw_series(spreads(&rows, name, color))?;
        chart.draw_series(LineSeries::new(line.clone(), color.stroke_width(2)))?;
        chart.draw_series(
            line.iter()
                .map(|point| EmptyElement::at(*point) + mark(place, (0, 0))),
        )?;
    }
    Ok(())
}

/// From the fastest to the slowest run, a thin line at each N.
fn spreads(rows: &[&Row], name: &str, color: RGBColor) -> Vec<PathElement<(f64, f64)>> {
    let rows = rows.iter().filter(|row| row.architecture == name);
    let spreads = rows.map(|row| {
        let at = |time: f64| (row.count as f64, time.max(0.01));
        let ends = [at(row.time.fastest), at(row.time.slowest)];
        PathElement::new(ends, color.mix(0.55).stroke_width(1))
    });
    spreads.collect()
}

/// 1000 as 10³.
fn power(number: f64) -> String {
    let exponent = number.log10().round() as usize;
    let raised = ["⁰", "", "²", "³", "⁴", "⁵", "⁶"];
    format!("10{}", raised.get(exponent).unwrap_or(&"ⁿ"))
}

/// 1000 ns as 1 µs.
fn duration(nanoseconds: f64) -> String {
    match nanoseconds {
        ..1e3 => format!("{nanoseconds} ns"),
        ..1e6 => format!("{} µs", nanoseconds / 1e3),
        _ => format!("{} ms", nanoseconds / 1e6),
    }
}

/// An architecture's mark about a point: dot, square, triangle, diamond, inverted triangle.
fn mark(place: usize, (x, y): (i32, i32)) -> Polygon<(i32, i32)> {
    let around = |corners: &[(i32, i32)]| corners.iter().map(|(a, b)| (x + a, y + b)).collect();
    let corners: Vec<(i32, i32)> = match place {
        0 => around(&[
            (5, 0),
            (4, 3),
            (0, 5),
            (-4, 3),
            (-5, 0),
            (-4, -3),
            (0, -5),
            (4, -3),
        ]),
        1 => around(&[(4, 4), (-4, 4), (-4, -4), (4, -4)]),
        2 => around(&[(0, -6), (5, 4), (-5, 4)]),
        3 => around(&[(0, -7), (6, 0), (0, 7), (-6, 0)]),
        _ => around(&[(0, 6), (5, -4), (-5, -4)]),
    };
    Polygon::new(corners, COLORS[place].filled())
}
