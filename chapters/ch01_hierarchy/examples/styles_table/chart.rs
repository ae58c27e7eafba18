//! The chart: cost an object against N, update in full lines and gather in points, both
//! axes logarithmic. Mid-tones on nothing, to be read on light and on dark pages.

use std::path::Path;

use plotters::prelude::*;

use crate::measure::Row;

const SIZE: (u32, u32) = (720, 420);
const GREY: RGBColor = RGBColor(128, 128, 128);
const COLORS: [RGBColor; 3] = [
    RGBColor(214, 106, 40),
    RGBColor(64, 140, 220),
    RGBColor(60, 160, 90),
];

pub fn draw(rows: &[Row], file: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let area = SVGBackend::new(file, SIZE).into_drawing_area();
    let text = |size: i32| ("sans-serif", size).into_font().color(&GREY);
    let largest = rows.iter().map(|row| row.count).max().unwrap_or(10) as f64;
    let most = rows
        .iter()
        .map(|row| row.update.median)
        .fold(10.0, f64::max);
    let mut chart = ChartBuilder::on(&area)
        .margin(12)
        .margin_right(36)
        .x_label_area_size(44)
        .y_label_area_size(56)
        .build_cartesian_2d(
            (8.0..largest * 1.2).log_scale(),
            // Room below the fastest and, for the legend, above the slowest.
            (0.5..most * 12.0).log_scale(),
        )?;
    chart
        .configure_mesh()
        .axis_style(GREY)
        .bold_line_style(GREY.mix(0.25))
        .light_line_style(GREY.mix(0.1))
        .label_style(text(14))
        .axis_desc_style(text(15))
        .x_desc("objects")
        .y_desc("ns an object")
        .x_label_formatter(&|count| ch01_hierarchy::styles::report::thousands(*count as usize))
        .y_label_formatter(&|time| format!("{time:.0}"))
        .draw()?;
    for (style, color) in styles(rows).into_iter().zip(COLORS) {
        let of_style = || rows.iter().filter(|row| row.style == style);
        let update = of_style().map(|row| (row.count as f64, row.update.median));
        let gather = of_style().map(|row| (row.count as f64, row.gather.median));
        chart
            .draw_series(LineSeries::new(update, color.stroke_width(3)))?
            .label(format!("{style}: update"))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], color.stroke_width(3)));
        chart
            .draw_series(gather.map(|point| Circle::new(point, 5, color.filled())))?
            .label(format!("{style}: gather"))
            .legend(move |(x, y)| Circle::new((x + 11, y), 5, color.filled()));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(text(14))
        .draw()?;
    area.present()?;
    Ok(())
}

/// Names in the order of their first rows.
fn styles(rows: &[Row]) -> Vec<&'static str> {
    rows.iter()
        .take(COLORS.len())
        .map(|row| row.style)
        .collect()
}
