//! Just enough SVG for the drawings: lines, areas, dots, arrows and words, readable in light and dark.

use std::fmt::Write as _;

use glam::{Vec2, Vec3};

pub const A: &str = "#e69f00";
pub const B: &str = "#56b4e9";
pub const SIMPLEX: &str = "#3a86c8";
pub const NEAREST: &str = "#e69f00";
pub const SUPPORT: &str = "#d55e00";
pub const BOUND: &str = "#10a578";
pub const SEEING: &str = "#cc79a7";
pub const GREY: &str = "#8a8f98";
pub const TEXT: &str = "currentColor";

/// A drawing. Places are in its own units, x to the right and y down.
pub struct Svg {
    text: String,
}

impl Svg {
    pub fn new(size: Vec2, label: &str) -> Self {
        let [x, y] = size.to_array();
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {x} {y}\" width=\"100%\" role=\"img\" \
             aria-label=\"{label}\" font-family=\"sans-serif\" font-size=\"13\" fill=\"currentColor\">\n"
        );
        Self { text }
    }

    pub fn finish(self) -> String {
        self.text + "</svg>"
    }

    fn add(&mut self, element: &str) {
        self.text.push_str(element);
        self.text.push('\n');
    }

    pub fn line(&mut self, [from, to]: [Vec2; 2], color: &str, width: f32) {
        self.stroke([from, to], color, width, "");
    }

    pub fn dashes(&mut self, [from, to]: [Vec2; 2], color: &str, width: f32) {
        self.stroke([from, to], color, width, " stroke-dasharray=\"5 4\"");
    }

    fn stroke(&mut self, [from, to]: [Vec2; 2], color: &str, width: f32, more: &str) {
        self.add(&format!(
            "<path d=\"M{:.1} {:.1} L{:.1} {:.1}\" stroke=\"{color}\" stroke-width=\"{width}\"{more}/>",
            from.x, from.y, to.x, to.y
        ));
    }

    pub fn area(&mut self, corners: &[Vec2], color: &str, opacity: f32, outline: f32) {
        let mut points = String::new();
        for corner in corners {
            // Writing into a String can't fail.
            let _ = write!(points, "{:.1},{:.1} ", corner.x, corner.y);
        }
        self.add(&format!(
            "<polygon points=\"{}\" fill=\"{color}\" fill-opacity=\"{opacity}\" stroke=\"{color}\" \
             stroke-width=\"{outline}\" stroke-linejoin=\"round\"/>",
            points.trim_end()
        ));
    }

    pub fn dot(&mut self, at: Vec2, radius: f32, color: &str) {
        let [x, y] = at.to_array();
        self.add(&format!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{color}\"/>"
        ));
    }

    pub fn ring(&mut self, at: Vec2, radius: f32, color: &str) {
        let [x, y] = at.to_array();
        self.add(&format!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>"
        ));
    }

    /// A cross with a ring: the origin.
    pub fn origin(&mut self, at: Vec2) {
        self.line([at - 7.0 * Vec2::X, at + 7.0 * Vec2::X], TEXT, 1.5);
        self.line([at - 7.0 * Vec2::Y, at + 7.0 * Vec2::Y], TEXT, 1.5);
        self.ring(at, 4.0, TEXT);
    }

    pub fn words(&mut self, at: Vec2, words: &str) {
        self.set(at, words, TEXT, "");
    }

    pub fn heading(&mut self, at: Vec2, words: &str) {
        self.set(at, words, TEXT, " font-weight=\"bold\"");
    }

    pub fn letter(&mut self, at: Vec2, letter: &str, color: &str) {
        let style = " font-style=\"italic\" font-size=\"16\" text-anchor=\"middle\"";
        self.set(at, letter, color, style);
    }

    fn set(&mut self, at: Vec2, words: &str, color: &str, style: &str) {
        let [x, y] = at.to_array();
        self.add(&format!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{color}\"{style}>{words}</text>"
        ));
    }
}

/// Where in a drawing the metres of a plane lie: x to the right, y up.
#[derive(Clone, Copy)]
pub struct Frame {
    /// The place of the plane's origin.
    pub origin: Vec2,
    /// Units a metre.
    pub scale: f32,
}

impl Frame {
    pub fn at(&self, p: Vec3) -> Vec2 {
        self.origin + self.scale * Vec2::new(p.x, -p.y)
    }

    pub fn all(&self, points: &[Vec3]) -> Vec<Vec2> {
        points.iter().map(|&p| self.at(p)).collect()
    }

    /// A direction as it points in the drawing.
    pub fn along(direction: Vec3) -> Vec2 {
        Vec2::new(direction.x, -direction.y).normalize_or_zero()
    }
}
