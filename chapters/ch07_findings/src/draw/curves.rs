//! The curves: a line through the points of each part of the plot, and marks. Theory lies over
//! the measured lines, which would hide it where it is right, and under their marks.

use super::canvas::{Canvas, Drawn, Point};
use super::frame::{Frame, Part};
use super::marks;
use super::notes::Notes;
use crate::chart::{Series, Style};

/// Points up to which each has its mark; of more, those have that are so many pixels from the mark before.
const MARKS: usize = 40;
const SPREAD: f64 = 14.0;

/// Draws all curves.
pub fn draw(canvas: &mut Canvas, series: &[Series], frame: &Frame) -> Drawn {
    let mut curves: Vec<Curve> = (series.iter().enumerate())
        .map(|(number, one)| Curve {
            style: one.style,
            places: (one.points.iter())
                .map(|&at| frame.locate(at, number))
                .collect(),
            notes: &one.notes,
            ringed: &one.ringed,
            bars: (one.points.iter().zip(&one.bars))
                .map(|(&(x, _), &(low, high))| [low, high].map(|y| frame.locate((x, y), number).0))
                .collect(),
        })
        .collect();
    set_apart(&mut curves);
    let (theory, measured): (Vec<_>, Vec<_>) =
        (curves.iter()).partition(|c| c.style == Style::Theory);
    for curve in measured.iter().chain(&theory) {
        curve.draw_lines(canvas)?;
    }
    for curve in measured {
        for ends in &curve.bars {
            marks::bar(canvas, curve.style, *ends)?;
        }
        curve.draw_marks(canvas)?;
    }
    for curve in &curves {
        for &k in curve.ringed {
            marks::ring(canvas, curve.places[k].0)?;
        }
    }
    draw_notes(canvas, &curves, frame.sides())
}

/// Between two stars, pixels.
const APART: f64 = 13.0;

/// Stars that would hide each other stand side by side.
fn set_apart(curves: &mut [Curve]) {
    let mut stars: Vec<Point> = Vec::new();
    let published = curves
        .iter_mut()
        .filter(|curve| curve.style == Style::Published);
    for place in published.flat_map(|curve| &mut curve.places) {
        let at = &mut place.0;
        while stars
            .iter()
            .any(|star| (star.0 - at.0).hypot(star.1 - at.1) < APART - 1.0)
        {
            at.0 += APART;
        }
        stars.push(*at);
    }
}

/// Writes what stands beside points.
fn draw_notes(canvas: &mut Canvas, curves: &[Curve], sides: [f64; 2]) -> Drawn {
    let noted = |curve: &&Curve| !curve.notes.is_empty();
    let mut notes = Notes::new(sides);
    for curve in curves {
        if !matches!(curve.style, Style::Published | Style::Marks(_)) {
            for run in curve.runs() {
                notes.avoid_line(&run);
            }
        }
        for place in curve.places.iter().filter(|_| curve.style != Style::Theory) {
            notes.avoid(place.0, noted(&curve));
        }
    }
    for curve in curves.iter().filter(noted) {
        for (place, note) in curve.places.iter().zip(curve.notes) {
            if !note.is_empty() {
                notes.draw(canvas, note, place.0, marks::ink(curve.style))?;
            }
        }
    }
    Ok(())
}

/// A curve, placed on the page.
struct Curve<'a> {
    style: Style,
    notes: &'a [String],
    ringed: &'a [usize],
    places: Vec<(Point, Part)>,
    bars: Vec<[Point; 2]>,
}

impl Curve<'_> {
    /// A line through each run of points in one part of the plot.
    fn draw_lines(&self, canvas: &mut Canvas) -> Drawn {
        for points in self.runs().filter(|points| points.len() > 1) {
            marks::line(canvas, self.style, &points)?;
        }
        Ok(())
    }

    /// Points one after the other in the same part of the plot.
    fn runs(&self) -> impl Iterator<Item = Vec<Point>> {
        let runs = self.places.chunk_by(|a, b| a.1 == b.1);
        runs.map(|run| run.iter().map(|place| place.0).collect())
    }

    /// Marks at all points, or at some of many; the ends of each run always have theirs.
    fn draw_marks(&self, canvas: &mut Canvas) -> Drawn {
        let spread = if self.places.len() > MARKS {
            SPREAD
        } else {
            0.0
        };
        let mut last = f64::NEG_INFINITY;
        for (k, &(point, part)) in self.places.iter().enumerate() {
            let is_end_of_run = [k.wrapping_sub(1), k + 1]
                .into_iter()
                .any(|next| self.places.get(next).is_none_or(|other| other.1 != part));
            if (point.0 - last).abs() >= spread || is_end_of_run {
                last = point.0;
                marks::mark(canvas, self.style, point)?;
            }
        }
        Ok(())
    }
}
