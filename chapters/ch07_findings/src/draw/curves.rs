//! The curves: a line through the points of each part of the plot, and marks. Theory lies
//! underneath.

use super::canvas::{Canvas, Drawn, Point};
use super::frame::{Frame, Part};
use super::marks;
use crate::chart::{Series, Style};

/// Points up to which each has its mark; of more, every k-th has, so that about so many do.
const MARKS: usize = 40;

/// Draws all curves.
pub fn draw(canvas: &mut Canvas, series: &[Series], frame: &Frame) -> Drawn {
    let lanes = series.len();
    for is_theory in [true, false] {
        for (lane, one) in series.iter().enumerate() {
            if (one.style == Style::Theory) == is_theory {
                let places = one.points.iter();
                let places: Vec<_> = places.map(|&at| frame.locate(at, lane, lanes)).collect();
                draw_curve(canvas, one.style, &places)?;
            }
        }
    }
    Ok(())
}

fn draw_curve(canvas: &mut Canvas, style: Style, places: &[(Point, Part)]) -> Drawn {
    for run in places.chunk_by(|a, b| a.1 == b.1) {
        let points: Vec<Point> = run.iter().map(|place| place.0).collect();
        if points.len() > 1 {
            marks::line(canvas, style, &points)?;
        }
    }
    let every = places.len().div_ceil(MARKS).max(1);
    for (k, &(point, part)) in places.iter().enumerate() {
        let is_end_of_run = [k.wrapping_sub(1), k + 1]
            .into_iter()
            .any(|next| places.get(next).is_none_or(|other| other.1 != part));
        if k.is_multiple_of(every) || is_end_of_run {
            marks::mark(canvas, style, point)?;
        }
    }
    Ok(())
}
