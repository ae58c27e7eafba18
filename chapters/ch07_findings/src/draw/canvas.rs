//! Where lines, shapes and letters go into the file: plotters' SVG backend, which counts in
//! whole pixels. The file is drawn ten times as large as it is shown, so that curves are smooth.

use std::fmt::Display;
use std::io;

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Units of the file a pixel.
const FINE: f64 = 10.0;

/// plotters' answer to anything drawn.
pub type Drawn = Result<(), DrawingAreaErrorKind<io::Error>>;

/// A point, pixels from the upper left corner.
pub type Point = (f64, f64);

/// A colour with its opacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    /// Red, green, blue.
    pub color: (u8, u8, u8),
    /// 0 for nothing, 1 for all.
    pub opacity: f64,
}

/// How letters look and which of their points is given.
#[derive(Clone, Copy)]
pub struct Lettering {
    /// Height of the font, pixels.
    pub size: f64,
    /// Bold letters.
    pub bold: bool,
    /// Which end of the line is given.
    pub anchor: HPos,
    /// Whether the line runs upwards.
    pub upwards: bool,
    /// Their colour.
    pub ink: Ink,
}

/// What is drawn on.
pub struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

impl Ink {
    /// A full colour.
    pub const fn full(color: (u8, u8, u8)) -> Self {
        Self {
            color,
            opacity: 1.0,
        }
    }

    /// The same colour, fainter.
    pub const fn faint(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    fn rgba(self) -> RGBAColor {
        let (red, green, blue) = self.color;
        RGBAColor(red, green, blue, self.opacity)
    }
}

impl<'a> Canvas<'a> {
    /// An empty canvas of so many pixels.
    pub fn new(file: &'a mut String, width: f64, height: f64) -> Self {
        let size = (units(width).unsigned_abs(), units(height).unsigned_abs());
        Self {
            area: SVGBackend::with_string(file, size).into_drawing_area(),
        }
    }

    /// A line through points, `width` pixels wide.
    pub fn line(&mut self, points: &[Point], ink: Ink, width: f64) -> Drawn {
        self.area
            .draw(&PathElement::new(fine(points), stroke(ink, width)))
    }

    /// The same in dashes.
    pub fn dashes(&mut self, points: &[Point], ink: Ink, width: f64) -> Drawn {
        let (dash, gap) = (units(6.0), units(5.0));
        self.area.draw(&DashedPathElement::new(
            fine(points),
            dash,
            gap,
            stroke(ink, width),
        ))
    }

    /// A filled disc.
    pub fn disc(&mut self, centre: Point, radius: f64, ink: Ink) -> Drawn {
        let style = ink.rgba().filled();
        self.area
            .draw(&Circle::new(fine_point(centre), units(radius), style))
    }

    /// A filled polygon.
    pub fn polygon(&mut self, points: &[Point], ink: Ink) -> Drawn {
        self.area.draw(&Polygon::new(fine(points), ink.rgba()))
    }

    /// One line of text; its middle is at the height of `y`.
    pub fn text(&mut self, text: &str, x: f64, y: f64, lettering: &Lettering) -> Drawn {
        let color = lettering.ink.rgba();
        // plotters divides by 1.24 for SVG.
        let font = FontDesc::new(
            FontFamily::SansSerif,
            lettering.size * FINE * 1.24,
            if lettering.bold {
                FontStyle::Bold
            } else {
                FontStyle::Normal
            },
        );
        let turn = if lettering.upwards {
            FontTransform::Rotate270
        } else {
            FontTransform::None
        };
        let style = TextStyle::from(font.transform(turn))
            .color(&color)
            .pos(Pos::new(lettering.anchor, VPos::Center));
        self.area.draw(&Text::new(text, fine_point((x, y)), style))
    }

    /// Ends the file.
    pub fn finish(&self) -> Drawn {
        self.area.present()
    }
}

/// The finished file, to be shown in pixels instead of fine units, and named for those who
/// can't see it.
pub fn in_pixels(file: &str, width: f64, height: f64, name: &str) -> String {
    let drawn = size(units(width), units(height));
    let shown = size(width.round(), height.round());
    let name = escaped(name);
    file.replacen(
        &drawn,
        &format!("{shown} role=\"img\" aria-label=\"{name}\" stroke-linejoin=\"round\""),
        1,
    )
}

fn size(width: impl Display, height: impl Display) -> String {
    format!("width=\"{width}\" height=\"{height}\"")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn units(pixels: f64) -> i32 {
    (pixels * FINE).round() as i32
}

fn fine_point((x, y): Point) -> (i32, i32) {
    (units(x), units(y))
}

fn fine(points: &[Point]) -> Vec<(i32, i32)> {
    points.iter().copied().map(fine_point).collect()
}

fn stroke(ink: Ink, width: f64) -> ShapeStyle {
    ink.rgba().stroke_width(units(width).unsigned_abs())
}
