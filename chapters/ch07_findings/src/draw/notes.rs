//! Notes beside the points of a curve: each where it covers least.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn, Ink, Lettering, Point};
use super::text::{self, NUMBER};

/// From a point to its note, pixels.
const GAP: f64 = 8.0;
/// Height of a line, and half of a mark's, pixels.
const HEIGHT: f64 = 13.0;
const MARK: f64 = 5.0;
/// Lines are looked at in pieces of so many pixels.
const PIECE: f64 = 6.0;

/// A rectangle: left, right, top, bottom, pixels.
type Sides = [f64; 4];

/// Where notes are, and what they shouldn't cover.
pub struct Notes {
    sides: [f64; 2],
    taken: Vec<Sides>,
    /// Marks and pieces of lines, and how bad it is to cover them.
    covered: Vec<(Sides, f64)>,
}

impl Notes {
    /// None yet, between the left and the right end of a plot.
    pub fn new(sides: [f64; 2]) -> Self {
        Self {
            sides,
            taken: Vec::new(),
            covered: Vec::new(),
        }
    }

    /// There is a mark; it matters more if it has a note itself.
    pub fn avoid(&mut self, (x, y): Point, noted: bool) {
        let weight = if noted { 10.0 } else { 4.0 };
        self.covered
            .push(([x - MARK, x + MARK, y - MARK, y + MARK], weight));
    }

    /// There is a line.
    pub fn avoid_line(&mut self, points: &[Point]) {
        for ends in points.windows(2) {
            let [(x0, y0), (x1, y1)] = [ends[0], ends[1]];
            let pieces = ((x1 - x0).hypot(y1 - y0) / PIECE).ceil().max(1.0);
            for k in 0..pieces as u32 {
                let share = f64::from(k) / pieces;
                let (x, y) = (x0 + share * (x1 - x0), y0 + share * (y1 - y0));
                self.covered.push(([x, x + 1.0, y, y + 1.0], 0.5));
            }
        }
    }

    /// Writes a note beside a point.
    pub fn draw(&mut self, canvas: &mut Canvas, note: &str, at: Point, ink: Ink) -> Drawn {
        let width = 0.92 * text::width(note, NUMBER);
        let tries = [
            (GAP, 0.0),
            (-GAP - width, 0.0),
            (GAP, HEIGHT),
            (GAP, -HEIGHT),
            (-GAP - width, -HEIGHT),
            (-GAP - width, HEIGHT),
            (-0.5 * width, -HEIGHT),
            (-0.5 * width, HEIGHT),
            (GAP, 2.0 * HEIGHT),
            (GAP, -2.0 * HEIGHT),
        ];
        let place = |(x, y): Point| {
            let (left, middle) = (at.0 + x, at.1 + y);
            [
                left,
                left + width,
                middle - 0.5 * HEIGHT,
                middle + 0.5 * HEIGHT,
            ]
        };
        let mut best = (f64::INFINITY, place(tries[0]));
        for (number, sides) in tries.into_iter().map(place).enumerate() {
            let cost = self.cost(sides) + 0.1 * number as f64;
            if cost < best.0 {
                best = (cost, sides);
            }
        }
        let [left, _, top, bottom] = best.1;
        self.taken.push(best.1);
        let lettering = Lettering {
            ink,
            ..text::number(HPos::Left)
        };
        canvas.text(note, left, 0.5 * (top + bottom), &lettering)
    }

    /// What a note here would cover.
    fn cost(&self, sides: Sides) -> f64 {
        let outside = sides[0] < self.sides[0] || sides[1] > self.sides[1];
        let notes = self.taken.iter().filter(|other| touch(sides, **other));
        let covered = self.covered.iter().filter(|other| touch(sides, other.0));
        let covered: f64 = covered.map(|other| other.1).sum();
        1000.0 * f64::from(u8::from(outside)) + 100.0 * notes.count() as f64 + covered
    }
}

fn touch(one: Sides, other: Sides) -> bool {
    one[0] < other[1] && other[0] < one[1] && one[2] < other[3] && other[2] < one[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_gives_way_to_marks_and_to_other_notes() {
        let mut file = String::new();
        let mut canvas = Canvas::new(&mut file, 200.0, 100.0);
        let mut notes = Notes::new([0.0, 200.0]);
        notes.avoid((112.0, 50.0), true);
        for note in ["8", "9"] {
            let ink = text::GREY;
            notes
                .draw(&mut canvas, note, (100.0, 50.0), ink)
                .expect("drawn");
        }
        let [one, other] = notes.taken[..] else {
            panic!("two notes");
        };
        assert!(one[1] <= 100.0 && !touch(one, other), "{one:?} {other:?}");
    }
}
