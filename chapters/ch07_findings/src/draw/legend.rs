//! The legend: a sample and a name for each curve or part of a bar, in rows above the plot, where they hide
//! nothing.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn};
use super::marks;
use super::text::{self, LABEL};
use crate::chart::{Class, Series, Style};

/// Length of a curve's sample, pixels.
const LINE: f64 = 28.0;
/// Length and height of a part's sample, pixels.
const FILL: f64 = 13.0;
/// Between a sample and its name, pixels.
const GAP: f64 = 6.0;
/// Between two entries of a row, pixels.
const BETWEEN: f64 = 16.0;
/// From row to row, pixels.
const ROW: f64 = 20.0;

/// What all stars are.
const PUBLISHED: &str = "other engines, by their names";

/// The rows of a legend.
pub struct Legend {
    entries: Vec<Entry>,
    rows: usize,
}

struct Entry {
    sample: Sample,
    name: String,
    row: usize,
    /// From the left end of the row, pixels.
    x: f64,
}

/// What stands before a name.
#[derive(Clone, Copy)]
enum Sample {
    /// A piece of a curve with its mark.
    Curve(Style),
    /// A mark alone.
    Mark(Style),
    /// A piece of the bars' part of this number.
    Part(usize),
    /// A piece of a map's cell.
    Cell(Class),
    /// A piece of theory over a map.
    Law,
}

impl Sample {
    fn length(self) -> f64 {
        match self {
            Sample::Curve(_) | Sample::Law => LINE,
            Sample::Mark(_) | Sample::Part(_) | Sample::Cell(_) => FILL,
        }
    }
}

impl Legend {
    /// Arranges the names of curves in rows of at most `width` pixels.
    pub fn new(series: &[Series], width: f64) -> Self {
        let named = series
            .iter()
            .filter(|one| !one.name.is_empty() && one.style != Style::Published);
        let entries = named.map(|one| (Sample::Curve(one.style), one.name.as_str()));
        let stars = series.iter().any(|one| one.style == Style::Published);
        let stars = stars.then_some((Sample::Curve(Style::Published), PUBLISHED));
        Self::arranged(entries.chain(stars), width)
    }

    /// The same for kinds of marks.
    pub fn of_kinds(kinds: &[(String, Style)], width: f64) -> Self {
        let entries = kinds.iter();
        Self::arranged(
            entries.map(|(name, style)| (Sample::Mark(*style), name.as_str())),
            width,
        )
    }

    /// The same for the parts of bars.
    pub fn of_parts(names: &[&str], width: f64) -> Self {
        let numbered = names.iter().enumerate();
        let entries = numbered.map(|(number, &name)| (Sample::Part(number), name));
        Self::arranged(entries, width)
    }

    /// The same for what cells of a map are, and the curve over them.
    pub fn of_maps(classes: &[String], theory: &str, width: f64) -> Self {
        let kinds = [Class::Held, Class::Worse, Class::Failed].map(Sample::Cell);
        let cells = kinds.into_iter().zip(classes.iter().map(String::as_str));
        let law = (!theory.is_empty()).then_some((Sample::Law, theory));
        Self::arranged(cells.chain(law), width)
    }

    fn arranged<'a>(named: impl Iterator<Item = (Sample, &'a str)>, width: f64) -> Self {
        let (mut row, mut x) = (0, 0.0);
        let mut entries = Vec::new();
        for (sample, name) in named {
            let wide = sample.length() + GAP + text::width(name, LABEL);
            if x > 0.0 && x + wide > width {
                (row, x) = (row + 1, 0.0);
            }
            entries.push(Entry {
                sample,
                name: name.to_owned(),
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
            let right = left + entry.sample.length();
            match entry.sample {
                Sample::Curve(style) => {
                    marks::line(canvas, style, &[(left, y), (right, y)])?;
                    marks::mark(canvas, style, (0.5 * (left + right), y))?;
                }
                Sample::Mark(style) => {
                    marks::mark(canvas, style, (0.5 * (left + right), y))?;
                }
                Sample::Part(number) => {
                    let ink = marks::ink_of_part(number);
                    marks::part(canvas, ink, [left, right], y, FILL)?;
                }
                Sample::Cell(class) => {
                    let half = 0.5 * FILL;
                    marks::cell(canvas, class, [left, y - half], [right, y + half])?;
                }
                Sample::Law => marks::law(canvas, &[(left, y), (right, y)])?,
            }
            let name_at = right + GAP;
            canvas.text(&entry.name, name_at, y, &text::label(HPos::Left))?;
        }
        Ok(())
    }
}
