//! How a curve looks: the same on all charts. Colours are told apart by colour-blind readers too
//! (Okabe and Ito 2008; orange and sky blue a little darker, to be seen on white), and every
//! colour has a mark of its own.

use super::canvas::{Canvas, Drawn, Ink, Point};
use super::text::GREY;
use crate::chart::{Class, Style};

/// Shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Disc,
    Square,
    Triangle,
    Diamond,
    Down,
    Cross,
    Plus,
    Ring,
    Star,
}

/// Radius of a disc, pixels; the other shapes look as large.
const RADIUS: f64 = 4.0;

/// The style of a ring about a mark, for the legend.
pub const RINGED: Style = Style::Marks(10);

/// Colours and shapes of what is neither printed nor corrected, in turn.
const OTHERS: [(Ink, Shape); 17] = [
    (Ink::full((0x00, 0x9E, 0x73)), Shape::Triangle),
    (Ink::full((0xCC, 0x79, 0xA7)), Shape::Diamond),
    (Ink::full((0xC8, 0x88, 0x00)), Shape::Down),
    (Ink::full((0x3E, 0x9F, 0xD8)), Shape::Cross),
    (Ink::full((0x9A, 0x8F, 0x1A)), Shape::Triangle),
    (Ink::full((0x80, 0x80, 0x80)), Shape::Plus),
    (Ink::full((0x7A, 0x52, 0xA3)), Shape::Disc),
    (Ink::full((0xA6, 0x56, 0x28)), Shape::Diamond),
    (Ink::full((0x4F, 0x7F, 0x6B)), Shape::Square),
    (Ink::full((0xC2, 0x3B, 0x5E)), Shape::Cross),
    (GREY, Shape::Ring),
    (Ink::full((0x00, 0x6B, 0x52)), Shape::Plus),
    (Ink::full((0x9C, 0x4A, 0x7C)), Shape::Plus),
    (Ink::full((0xE0, 0x40, 0x30)), Shape::Diamond),
    (Ink::full((0xA0, 0x20, 0x18)), Shape::Down),
    (Ink::full((0x5B, 0x6A, 0xC4)), Shape::Square),
    (Ink::full((0xDD, 0x6B, 0x5E)), Shape::Cross),
];

/// The colours of a bar's parts, in order: neighbours are light and dark in turn.
const PARTS: [Style; 7] = [
    Style::Corrected,
    Style::Other(3),
    Style::Other(0),
    Style::Other(2),
    Style::Printed,
    Style::Other(1),
    Style::Theory,
];
/// Between two parts, pixels.
const BETWEEN_PARTS: f64 = 0.8;

/// The colour of a curve.
pub fn ink(style: Style) -> Ink {
    look(style).0
}

fn look(style: Style) -> (Ink, Option<Shape>) {
    match style {
        Style::Printed => (Ink::full((0xD5, 0x5E, 0x00)), Some(Shape::Disc)),
        Style::Corrected => (Ink::full((0x00, 0x72, 0xB2)), Some(Shape::Square)),
        Style::Theory => (GREY, None),
        Style::Other(number) | Style::Dashed(number) | Style::Marks(number) => {
            let (ink, shape) = OTHERS[number % OTHERS.len()];
            (ink, Some(shape))
        }
        Style::Published => (GREY, Some(Shape::Star)),
    }
}

/// Draws a piece of a curve.
pub fn line(canvas: &mut Canvas, style: Style, points: &[Point]) -> Drawn {
    match style {
        Style::Theory => canvas.dashes(points, ink(style), 1.5),
        Style::Dashed(_) => canvas.dashes(points, ink(style), 2.0),
        Style::Marks(_) | Style::Published => Ok(()),
        _ => canvas.line(points, ink(style), 2.0),
    }
}

/// The colour of a bar's part.
pub fn ink_of_part(number: usize) -> Ink {
    ink(PARTS[number % PARTS.len()])
}

/// Draws a part of a bar about the height `y`, and a line of nothing at its right end, which tells it
/// from the next one whatever the colours.
pub fn part(canvas: &mut Canvas, ink: Ink, ends: [f64; 2], y: f64, height: f64) -> Drawn {
    let [left, right] = ends;
    let (right, half) = (right - BETWEEN_PARTS, 0.5 * height);
    if right <= left {
        return Ok(());
    }
    let corners = [
        (left, y - half),
        (right, y - half),
        (right, y + half),
        (left, y + half),
    ];
    canvas.polygon(&corners, ink)
}

/// The colour of a map's cell: the worse the darker, so that print in grey tells them apart too.
fn ink_of_cell(class: Class) -> Ink {
    match class {
        Class::Held => ink(Style::Corrected).faint(0.2),
        Class::Worse => ink(Style::Other(2)).faint(0.6),
        Class::Failed => ink(Style::Printed),
    }
}

/// Draws a map's cell between two of its corners.
pub fn cell(canvas: &mut Canvas, class: Class, from: [f64; 2], to: [f64; 2]) -> Drawn {
    let ([left, top], [right, bottom]) = (from, to);
    let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
    canvas.polygon(&corners, ink_of_cell(class))
}

/// Draws theory over cells: dark dashes on a light line, which stand out on any cell and any ground.
pub fn law(canvas: &mut Canvas, points: &[Point]) -> Drawn {
    const LIGHT: Ink = Ink::full((0xFF, 0xFF, 0xFF));
    const DARK: Ink = Ink::full((0x10, 0x10, 0x10));
    canvas.line(points, LIGHT.faint(0.85), 3.4)?;
    canvas.dashes(points, DARK, 1.6)
}

/// Draws an error bar between two points, one above the other, with a short line across each end.
pub fn bar(canvas: &mut Canvas, style: Style, ends: [Point; 2]) -> Drawn {
    canvas.line(&ends, ink(style), 1.3)?;
    for (x, y) in ends {
        canvas.line(&[(x - RADIUS, y), (x + RADIUS, y)], ink(style), 1.3)?;
    }
    Ok(())
}

/// Draws a ring about a mark.
pub fn ring(canvas: &mut Canvas, at: Point) -> Drawn {
    mark(canvas, RINGED, at)
}

/// Draws a curve's mark at a point; theory has none.
pub fn mark(canvas: &mut Canvas, style: Style, at: Point) -> Drawn {
    let (ink, Some(shape)) = look(style) else {
        return Ok(());
    };
    let corners = |corners: &[Point]| -> Vec<Point> {
        let place = |&(x, y): &Point| (at.0 + RADIUS * x, at.1 + RADIUS * y);
        corners.iter().map(place).collect()
    };
    match shape {
        Shape::Disc => canvas.disc(at, RADIUS, ink),
        Shape::Square => canvas.polygon(&corners(&SQUARE), ink),
        Shape::Triangle => canvas.polygon(&corners(&TRIANGLE), ink),
        Shape::Down => canvas.polygon(&corners(&TRIANGLE.map(|(x, y)| (x, -y))), ink),
        Shape::Diamond => canvas.polygon(&corners(&DIAMOND), ink),
        Shape::Plus => {
            canvas.line(&corners(&[(-1.2, 0.0), (1.2, 0.0)]), ink, 2.2)?;
            canvas.line(&corners(&[(0.0, -1.2), (0.0, 1.2)]), ink, 2.2)
        }
        Shape::Star => STAR
            .iter()
            .try_for_each(|&(x, y)| canvas.line(&corners(&[(-x, -y), (x, y)]), ink, 1.8)),
        Shape::Ring => canvas.line(&corners(&RING), ink, 1.3),
        Shape::Cross => {
            canvas.line(&corners(&[(-0.95, -0.95), (0.95, 0.95)]), ink, 2.2)?;
            canvas.line(&corners(&[(-0.95, 0.95), (0.95, -0.95)]), ink, 2.2)
        }
    }
}

const SQUARE: [Point; 4] = [(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)];
const TRIANGLE: [Point; 3] = [(0.0, -1.25), (1.15, 0.8), (-1.15, 0.8)];
/// Ends of three strokes.
const STAR: [Point; 3] = [(0.0, 1.6), (1.39, 0.8), (1.39, -0.8)];
const RING: [Point; 9] = [
    (1.9, 0.0),
    (1.34, 1.34),
    (0.0, 1.9),
    (-1.34, 1.34),
    (-1.9, 0.0),
    (-1.34, -1.34),
    (0.0, -1.9),
    (1.34, -1.34),
    (1.9, 0.0),
];
const DIAMOND: [Point; 4] = [(0.0, -1.35), (1.15, 0.0), (0.0, 1.35), (-1.15, 0.0)];
