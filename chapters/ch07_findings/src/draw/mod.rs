//! A chart as SVG, for print and for dark pages alike, and as CSV with all digits.
//!
//! Nothing is dropped and nothing is clipped: what a logarithmic axis can't hold (0 and less) and
//! what no axis can hold (NaN and infinities) stands on a labelled band at the edge. The same
//! chart gives the same bytes.

mod bars;
mod canvas;
mod csv;
mod curves;
mod dots;
mod frame;
mod legend;
mod maps;
mod marks;
mod notes;
mod numbers;
mod scale;
mod text;

pub use csv::{csv, quoted};
pub(crate) use marks::RINGED;
pub(crate) use numbers::{grouped, superscript};

use crate::chart::{Chart, Picture};
use crate::error::FindingsError;
use canvas::{Canvas, Drawn};
use frame::Frame;
use legend::Legend;

/// Width of every chart, pixels; the height follows from what there is to say.
const WIDTH: f64 = 720.0;
/// Height of the part of a chart that the curves share, pixels.
const PLOT_HEIGHT: f64 = 330.0;
/// Free space at the edges, pixels.
const MARGIN: f64 = 10.0;

/// A picture of any kind as an SVG file.
///
/// # Errors
/// [`FindingsError::Draw`] where the drawing library gives up.
pub fn picture(picture: &Picture) -> Result<String, FindingsError> {
    match picture {
        Picture::Curves(chart) => svg(chart),
        Picture::Bars(chart) => bars::svg(chart),
        Picture::Maps(chart) => maps::svg(chart),
        Picture::Dots(chart) => dots::svg(chart),
    }
}

/// The chart as an SVG file: transparent ground, no fonts or scripts from elsewhere.
///
/// # Errors
/// [`FindingsError::Draw`] where the drawing library gives up.
pub fn svg(chart: &Chart) -> Result<String, FindingsError> {
    let title = text::wrapped(&chart.title, text::BOLD * text::TITLE, WIDTH - 2.0 * MARGIN);
    let legend = Legend::new(&chart.series, WIDTH - 2.0 * MARGIN);
    let title_height = text::TITLE * 1.35 * title.len() as f64;
    let top = MARGIN + title_height + legend.height();
    let frame = Frame::new(chart, top);

    file((chart.name, &chart.title), frame.bottom(), |canvas| {
        draw_head(canvas, &title, Some(&legend))?;
        frame.draw(canvas)?;
        curves::draw(canvas, &chart.series, &frame)
    })
}

/// What is drawn, as an SVG file of this name, title and height, pixels.
fn file(
    (name, title): (&str, &str),
    height: f64,
    draw: impl FnOnce(&mut Canvas) -> Drawn,
) -> Result<String, FindingsError> {
    let mut file = String::new();
    let mut canvas = Canvas::new(&mut file, WIDTH, height);
    let drawn = draw(&mut canvas).and_then(|()| canvas.finish());
    drop(canvas);
    drawn.map_err(|error| FindingsError::Draw {
        chart: name.to_owned(),
        why: error.to_string(),
    })?;
    Ok(canvas::in_pixels(&file, WIDTH, height, title))
}

/// Writes the lines of a title, and under them the legend.
fn draw_head(canvas: &mut Canvas, title: &[String], legend: Option<&Legend>) -> Drawn {
    let mut y = MARGIN + 0.5 * text::TITLE;
    for line in title {
        canvas.text(line, MARGIN, y, &text::title())?;
        y += 1.35 * text::TITLE;
    }
    legend.map_or(Ok(()), |legend| legend.draw(canvas, MARGIN, y))
}
