//! Rows of marks along one axis, one under the other: names above them.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn, Lettering};
use super::frame::{grid, thinned};
use super::legend::Legend;
use super::scale::{Place, Scale, Tick};
use super::text::{self, BOLD, TITLE};
use super::{MARGIN, WIDTH, draw_head, file, marks};
use crate::chart::Dots;
use crate::error::FindingsError;

/// What a row's name takes, pixels.
const HEADING: f64 = 19.0;
/// Marks that would touch stand in lanes of so many pixels.
const LANE: f64 = 12.0;
/// Above and below the lanes of a row, pixels.
const FREE: f64 = 4.0;
/// Height of a line of text at the axis, pixels.
const LINE: f64 = 18.0;

/// The dots as an SVG file.
pub fn svg(dots: &Dots) -> Result<String, FindingsError> {
    let plot = Plot::new(dots);
    file((dots.name, &dots.title), plot.height(), |canvas| {
        plot.draw(canvas)
    })
}

/// A mark: its kind, how far to the right it is, and its lane.
type Mark = (usize, f64, usize);

/// Rows, placed on the page.
struct Plot<'a> {
    dots: &'a Dots,
    title: Vec<String>,
    legend: Legend,
    ticks: Vec<Tick>,
    /// By row: its marks, and how many lanes they have.
    rows: Vec<(Vec<Mark>, usize)>,
    left: f64,
    right: f64,
    top: f64,
}

impl<'a> Plot<'a> {
    fn new(dots: &'a Dots) -> Self {
        let room = WIDTH - 2.0 * MARGIN;
        let title = text::wrapped(&dots.title, BOLD * TITLE, room);
        let legend = Legend::of_kinds(&dots.kinds, room);
        let all = dots.rows.iter().flat_map(|row| &row.marks);
        let scale = Scale::of(&dots.x, all.map(|mark| mark.1));
        let (left, right) = (MARGIN + 6.0, WIDTH - MARGIN - 6.0);
        let rows = dots.rows.iter();
        let rows = rows.map(|row| {
            let x = |place| match place {
                Place::On(at) => left + at * (right - left),
                Place::Below => left,
                Place::Beyond => right,
            };
            let marks = row.marks.iter();
            in_lanes(
                marks
                    .map(|&(kind, number)| (kind, x(scale.place(number))))
                    .collect(),
            )
        });
        Self {
            dots,
            rows: rows.collect(),
            ticks: thinned(scale.ticks(9), right - left),
            left,
            right,
            top: MARGIN + 1.35 * TITLE * title.len() as f64 + legend.height(),
            title,
            legend,
        }
    }

    fn bottom(&self) -> f64 {
        self.top + self.rows.iter().map(|row| height(row.1)).sum::<f64>()
    }

    fn height(&self) -> f64 {
        self.bottom() + 2.0 * LINE + MARGIN
    }

    fn draw(&self, canvas: &mut Canvas) -> Drawn {
        draw_head(canvas, &self.title, Some(&self.legend))?;
        let mut y = self.top;
        for (row, (marks, lanes)) in self.dots.rows.iter().zip(&self.rows) {
            let heading = Lettering {
                bold: true,
                ..text::number(HPos::Left)
            };
            let middle = y + 0.55 * HEADING;
            canvas.text(&row.name, MARGIN, middle, &heading)?;
            let at_end = text::number(HPos::Right);
            canvas.text(&row.note, WIDTH - MARGIN, middle, &at_end)?;
            self.draw_row(canvas, [y + HEADING, y + height(*lanes)], marks)?;
            y += height(*lanes);
        }
        self.draw_axis(canvas)
    }

    fn draw_row(&self, canvas: &mut Canvas, ends: [f64; 2], marks: &[Mark]) -> Drawn {
        for tick in &self.ticks {
            let x = self.left + tick.at * (self.right - self.left);
            canvas.line(&[(x, ends[0]), (x, ends[1])], grid(tick), 1.0)?;
        }
        for &(kind, x, lane) in marks {
            let y = ends[0] + FREE + LANE * (lane as f64 + 0.5);
            marks::mark(canvas, self.dots.kinds[kind].1, (x, y))?;
        }
        Ok(())
    }

    fn draw_axis(&self, canvas: &mut Canvas) -> Drawn {
        let y = self.bottom() + 0.5 * LINE + 1.0;
        for tick in &self.ticks {
            let x = self.left + tick.at * (self.right - self.left);
            canvas.text(&tick.label, x, y, &text::number(HPos::Center))?;
        }
        let middle = 0.5 * (self.left + self.right);
        let centred = text::label(HPos::Center);
        canvas.text(&self.dots.x.label, middle, y + LINE + 1.0, &centred)
    }
}

/// Height of a row with so many lanes, pixels.
fn height(lanes: usize) -> f64 {
    HEADING + 2.0 * FREE + LANE * lanes.max(1) as f64
}

/// Marks in as many lanes as they need not to touch.
fn in_lanes(mut marks: Vec<(usize, f64)>) -> (Vec<Mark>, usize) {
    marks.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut ends: Vec<f64> = Vec::new();
    let placed = marks.into_iter().map(|(kind, x)| {
        let free = ends.iter().position(|end| x >= end + LANE);
        let lane = free.unwrap_or(ends.len());
        match ends.get_mut(lane) {
            Some(end) => *end = x,
            None => ends.push(x),
        }
        (kind, x, lane)
    });
    let placed = placed.collect();
    (placed, ends.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::{Axis, DotRow, Style};

    #[test]
    fn marks_that_would_touch_stand_in_lanes() {
        let (marks, lanes) = in_lanes(vec![(0, 10.0), (1, 12.0), (2, 40.0)]);
        assert_eq!(lanes, 2);
        assert_eq!(marks, [(0, 10.0, 0), (1, 12.0, 1), (2, 40.0, 0)]);
    }

    #[test]
    fn every_row_has_its_name_its_note_and_its_marks() {
        let dots = Dots {
            name: "any",
            title: "Dots & more".to_owned(),
            x: Axis::log("time (µs)"),
            kinds: vec![
                ("printed".to_owned(), Style::Printed),
                ("own".to_owned(), Style::Printed),
            ],
            rows: vec![DotRow {
                name: "a ball".to_owned(),
                note: "never: 3".to_owned(),
                marks: vec![(0, 1.0), (1, 100.0)],
            }],
        };
        let drawn = svg(&dots).expect("it can be drawn");
        for text in [
            "Dots &amp; more",
            "a ball",
            "never: 3",
            "time (µs)",
            "printed",
        ] {
            assert!(drawn.contains(text), "{text:?} isn't in:\n{drawn}");
        }
        // Two marks and two samples.
        assert_eq!(drawn.matches("<circle ").count(), 4);
    }
}
