//! The curves: a line through the points of each part of the plot, and marks. Theory lies over
//! the measured lines, which would hide it where it is right, and under their marks.

use super::canvas::{Canvas, Drawn, Point};
use super::frame::{Frame, Part};
use super::marks;
use crate::chart::{Series, Style};

/// Points up to which each has its mark; of more, every k-th has, so that about so many do.
const MARKS: usize = 40;

/// Draws all curves.
pub fn draw(canvas: &mut Canvas, series: &[Series], frame: &Frame) -> Drawn {
    let curves: Vec<Curve> = (series.iter().enumerate())
        .map(|(number, one)| Curve {
            style: one.style,
            places: (one.points.iter())
                .map(|&at| frame.locate(at, number))
                .collect(),
            bars: (one.points.iter().zip(&one.bars))
                .map(|(&(x, _), &(low, high))| [low, high].map(|y| frame.locate((x, y), number).0))
                .collect(),
        })
        .collect();
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
    Ok(())
}

/// A curve, placed on the page.
struct Curve {
    style: Style,
    places: Vec<(Point, Part)>,
    bars: Vec<[Point; 2]>,
}

impl Curve {
    /// A line through each run of points in one part of the plot.
    fn draw_lines(&self, canvas: &mut Canvas) -> Drawn {
        for run in self.places.chunk_by(|a, b| a.1 == b.1) {
            let points: Vec<Point> = run.iter().map(|place| place.0).collect();
            if points.len() > 1 {
                marks::line(canvas, self.style, &points)?;
            }
        }
        Ok(())
    }

    /// Marks at all points, or at some of many; the ends of each run always have theirs.
    fn draw_marks(&self, canvas: &mut Canvas) -> Drawn {
        let every = self.places.len().div_ceil(MARKS).max(1);
        for (k, &(point, part)) in self.places.iter().enumerate() {
            let is_end_of_run = [k.wrapping_sub(1), k + 1]
                .into_iter()
                .any(|next| self.places.get(next).is_none_or(|other| other.1 != part));
            if k.is_multiple_of(every) || is_end_of_run {
                marks::mark(canvas, self.style, point)?;
            }
        }
        Ok(())
    }
}
