//! The legend: a sample and a name for each curve, in rows above the plot, where they hide
//! nothing.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn};
use super::marks;
use super::text::{self, LABEL};
use crate::chart::{Series, Style};

/// Length of a sample, pixels.
const SAMPLE: f64 = 28.0;
/// Between a sample and its name, pixels.
const GAP: f64 = 6.0;
/// Between two entries of a row, pixels.
const BETWEEN: f64 = 16.0;
/// From row to row, pixels.
const ROW: f64 = 20.0;

/// The rows of a legend.
pub struct Legend {
    entries: Vec<Entry>,
    rows: usize,
}

struct Entry {
    style: Style,
    name: String,
    row: usize,
    /// From the left end of the row, pixels.
    x: f64,
}

impl Legend {
    /// Arranges the names in rows of at most `width` pixels.
    pub fn new(series: &[Series], width: f64) -> Self {
        let (mut row, mut x) = (0, 0.0);
        let mut entries = Vec::new();
        for one in series.iter().filter(|one| !one.name.is_empty()) {
            let wide = SAMPLE + GAP + text::width(&one.name, LABEL);
            if x > 0.0 && x + wide > width {
                (row, x) = (row + 1, 0.0);
            }
            entries.push(Entry {
                style: one.style,
                name: one.name.clone(),
                row,
                x,
            });
            x += wide + BETWEEN;
        }
        let rows = entries.last().map_or(0, |last| last.row + 1);
        Self { entries, rows }
    }

    /// Pixels that the rows need.
    pub fn height(&self) -> f64 {
        ROW * self.rows as f64 + 8.0
    }

    /// Draws it; `x` and `y` are the left end and the middle of the first row.
    pub fn draw(&self, canvas: &mut Canvas, x: f64, y: f64) -> Drawn {
        for entry in &self.entries {
            let (left, y) = (x + entry.x, y + ROW * entry.row as f64);
            marks::line(canvas, entry.style, &[(left, y), (left + SAMPLE, y)])?;
            marks::mark(canvas, entry.style, (left + 0.5 * SAMPLE, y))?;
            let name_at = left + SAMPLE + GAP;
            canvas.text(&entry.name, name_at, y, &text::label(HPos::Left))?;
        }
        Ok(())
    }
}
