//! The chart: cost of `integrate` a ball against N, both axes logarithmic. Steps 4 to 7 store the same
//! columns, so one line stands for them. Mid-tones on nothing, to be read on light and on dark pages.

use std::path::Path;

use plotters::prelude::*;

use crate::measure::Row;

const SIZE: (u32, u32) = (720, 420);
const GREY: RGBColor = RGBColor(128, 128, 128);
/// Steps that are drawn, and their colours.
const DRAWN: [(usize, RGBColor); 4] = [
    (1, RGBColor(214, 106, 40)),
    (2, RGBColor(64, 140, 220)),
    (3, RGBColor(60, 160, 90)),
    (4, RGBColor(176, 106, 179)),
];

pub fn draw(rows: &[Row], file: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let area = SVGBackend::new(file, SIZE).into_drawing_area();
    let text = |size: i32| ("sans-serif", size).into_font().color(&GREY);
    let largest = rows.iter().map(|row| row.count).max().unwrap_or(10) as f64;
    let times = || rows.iter().map(|row| row.integrate.median);
    let (least, most) = (times().fold(1.0, f64::min), times().fold(1.0, f64::max));
    let mut chart = ChartBuilder::on(&area)
        .margin(12)
        .margin_right(36)
        .x_label_area_size(44)
        .y_label_area_size(56)
        .build_cartesian_2d(
            (8.0..largest * 1.2).log_scale(),
            // Room below the fastest and, for the legend, above the slowest.
            (least * 0.4..most * 8.0).log_scale(),
        )?;
    chart
        .configure_mesh()
        .axis_style(GREY)
        .bold_line_style(GREY.mix(0.25))
        .light_line_style(GREY.mix(0.1))
        .label_style(text(14))
        .axis_desc_style(text(15))
        .x_desc("balls")
        .y_desc("integrate, ns a ball")
        .x_label_formatter(&|count| ch01_hierarchy::styles::report::thousands(*count as usize))
        .y_label_formatter(&|time| format!("{time:.0}"))
        .draw()?;
    for (number, color) in DRAWN {
        let of_step = || rows.iter().filter(move |row| row.number == number);
        let line = of_step().map(|row| (row.count as f64, row.integrate.median));
        let name = of_step().next().map_or("", |row| row.name);
        chart
            .draw_series(LineSeries::new(line, color.stroke_width(3)))?
            .label(format!("{number} {name}"))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], color.stroke_width(3)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(text(14))
        .draw()?;
    area.present()?;
    Ok(())
}
