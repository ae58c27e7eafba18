//! What an engine draws of its inner state: lines, faces and marks in the world, with a key to
//! their colours, and the figures that are made of them: arrows, frames, boxes, cones, sectors.
//!
//! Lengths are in metres, widths in points of the screen. Where a figure asks for a unit vector
//! and gets none, it draws nothing that matters.

use std::f32::consts::TAU;

use glam::{Quat, Vec2, Vec3};

/// Red, green and blue as displayed, each 0 … 1.
pub type Rgb = [f32; 3];

/// Okabe and Ito's palette, which people of all kinds of colour vision tell apart.
pub mod palette {
    use super::Rgb;

    /// E69F00
    pub const ORANGE: Rgb = [0.902, 0.624, 0.0];
    /// 56B4E9
    pub const SKY: Rgb = [0.337, 0.706, 0.914];
    /// 009E73
    pub const GREEN: Rgb = [0.0, 0.620, 0.451];
    /// F0E442
    pub const YELLOW: Rgb = [0.941, 0.894, 0.259];
    /// 0072B2
    pub const BLUE: Rgb = [0.0, 0.447, 0.698];
    /// D55E00
    pub const VERMILLION: Rgb = [0.835, 0.369, 0.0];
    /// CC79A7
    pub const PURPLE: Rgb = [0.8, 0.475, 0.655];
    /// For what stays in the background.
    pub const GREY: Rgb = [0.5, 0.53, 0.57];
}

/// A line to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// From, m.
    pub from: [f32; 3],
    /// To, m.
    pub to: [f32; 3],
    /// Points of the screen.
    pub width: f32,
    /// Its colour.
    pub color: Rgb,
}

/// A triangle to draw, seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Its corners, m.
    pub corners: [[f32; 3]; 3],
    /// Red, green, blue as displayed, and opacity, each 0 … 1.
    pub color: [f32; 4],
}

/// A dot that is seen through everything, with a few letters beside it or none.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where, m.
    pub at: [f32; 3],
    /// Its colour.
    pub color: Rgb,
    /// What stands beside it.
    pub text: String,
}

/// What a colour means.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// The colour.
    pub color: Rgb,
    /// Its meaning.
    pub text: String,
}

/// A drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Its lines.
    pub lines: Vec<Line>,
    /// Its faces.
    pub faces: Vec<Face>,
    /// Its marks.
    pub marks: Vec<Mark>,
    /// What its colours mean.
    pub key: Vec<Key>,
}

/// Straight pieces of a full circle.
const PIECES: u32 = 48;

/// Sides of discs and rings.
const ROUND: u32 = 16;

/// Sides of an arrow's head.
const HEAD_SIDES: u32 = 8;

/// Opacity of the inside of cones and sectors.
const INSIDE: f32 = 0.22;

impl Drawing {
    /// Adds all of another drawing.
    pub fn append(&mut self, mut other: Self) {
        self.lines.append(&mut other.lines);
        self.faces.append(&mut other.faces);
        self.marks.append(&mut other.marks);
        self.key.append(&mut other.key);
    }

    /// Says what a colour means.
    pub fn explain(&mut self, color: Rgb, text: impl Into<String>) {
        let text = text.into();
        self.key.push(Key { color, text });
    }

    /// A dot with a few letters.
    pub fn mark(&mut self, at: Vec3, color: Rgb, text: impl Into<String>) {
        self.marks.push(Mark {
            at: at.to_array(),
            color,
            text: text.into(),
        });
    }

    /// A line.
    pub fn line(&mut self, from: Vec3, to: Vec3, width: f32, color: Rgb) {
        self.lines.push(Line {
            from: from.to_array(),
            to: to.to_array(),
            width,
            color,
        });
    }

    /// Lines from each point to the next.
    pub fn path(&mut self, points: &[Vec3], width: f32, color: Rgb) {
        for ends in points.windows(2) {
            self.line(ends[0], ends[1], width, color);
        }
    }

    /// A line of dashes of this length, each as long as the gap after it.
    pub fn dashes(&mut self, from: Vec3, to: Vec3, dash: f32, width: f32, color: Rgb) {
        let count = ((to - from).length() / (2.0 * dash))
            .ceil()
            .clamp(1.0, 200.0);
        for i in 0..count as u32 {
            let at = |half: f32| from.lerp(to, ((i as f32 + half) / (count - 0.5)).min(1.0));
            self.line(at(0.0), at(0.5), width, color);
        }
    }

    /// A triangle.
    pub fn face(&mut self, corners: [Vec3; 3], color: Rgb, opacity: f32) {
        let [r, g, b] = color;
        self.faces.push(Face {
            corners: corners.map(|corner| corner.to_array()),
            color: [r, g, b, opacity],
        });
    }

    /// A flat convex shape with this outline, which may come back to its beginning.
    pub fn polygon(&mut self, outline: &[Vec3], color: Rgb, opacity: f32) {
        for pair in outline.windows(2).skip(1) {
            if pair[1] != outline[0] {
                self.face([outline[0], pair[0], pair[1]], color, opacity);
            }
        }
    }

    /// A line with a solid head at its end, which takes up at most a third of it.
    pub fn arrow(&mut self, from: Vec3, to: Vec3, width: f32, color: Rgb) {
        self.arrow_with_head(from, to, 0.3 * (to - from).length(), width, color);
    }

    /// A line with a solid head of this length at its end.
    pub fn arrow_with_head(&mut self, from: Vec3, to: Vec3, head: f32, width: f32, color: Rgb) {
        let Some(axis) = (to - from).try_normalize() else {
            return;
        };
        let neck = to - axis * head.min((to - from).length());
        self.line(from, neck, width, color);
        let rim = circle(neck, axis, 0.36 * head, HEAD_SIDES);
        for side in rim.windows(2) {
            let normal = (side[1] - side[0]).cross(to - side[0]).normalize_or_zero();
            self.face([side[0], side[1], to], shaded(color, normal), 1.0);
        }
        self.polygon(&rim, shaded(color, -axis), 1.0);
    }

    /// Two lines that cross at a point, across `normal`, a unit vector.
    pub fn cross(&mut self, at: Vec3, normal: Vec3, size: f32, width: f32, color: Rgb) {
        let (u, v) = normal.any_orthonormal_pair();
        for arm in [u, v] {
            self.line(at - size * arm, at + size * arm, width, color);
        }
    }

    /// A circle about `normal`, a unit vector.
    pub fn ring(&mut self, at: Vec3, normal: Vec3, radius: f32, width: f32, color: Rgb) {
        self.path(&circle(at, normal, radius, ROUND), width, color);
    }

    /// A filled circle about `normal`, a unit vector.
    pub fn disc(&mut self, at: Vec3, normal: Vec3, radius: f32, color: Rgb, opacity: f32) {
        self.polygon(&circle(at, normal, radius, ROUND), color, opacity);
    }

    /// Three axes: x vermillion, y green, z blue.
    pub fn frame(&mut self, at: Vec3, orientation: Quat, length: f32, width: f32) {
        for (axis, color) in Vec3::AXES.into_iter().zip(AXES) {
            let tip = at + orientation * axis * length;
            self.arrow_with_head(at, tip, 0.2 * length, width, color);
        }
    }

    /// The twelve edges of a box along the world's axes.
    pub fn cuboid(&mut self, min: Vec3, max: Vec3, width: f32, color: Rgb) {
        let size = max - min;
        for axis in 0..3 {
            let along = Vec3::AXES[axis] * size;
            let one = Vec3::AXES[(axis + 1) % 3] * size;
            let two = Vec3::AXES[(axis + 2) % 3] * size;
            for corner in [Vec3::ZERO, one, two, one + two] {
                self.line(min + corner, min + corner + along, width, color);
            }
        }
    }

    /// Triangles from an apex to each piece of a rim, and the rim itself. A rim that doesn't
    /// come back to its beginning gets two sides.
    pub fn fan(&mut self, apex: Vec3, rim: &[Vec3], width: f32, color: Rgb) {
        for piece in rim.windows(2) {
            self.face([apex, piece[0], piece[1]], color, INSIDE);
        }
        self.path(rim, width, color);
        if let [first, .., last] = rim
            && first.distance(*last) > 1e-4 * first.distance(apex)
        {
            self.line(apex, *first, width, color);
            self.line(apex, *last, width, color);
        }
    }

    /// The cone of all directions at most `angle` from `axis`, a unit vector, with sides of this
    /// length. Angles up to π: past π/2 it opens backwards.
    pub fn cone(&mut self, apex: Vec3, axis: Vec3, angle: f32, length: f32, color: Rgb) {
        let [cos, sin] = Vec2::from_angle(angle).to_array();
        let rim = circle(apex + axis * (length * cos), axis, length * sin, PIECES);
        self.fan(apex, &rim, 1.5, color);
    }

    /// The cone whose half angle differs from side to side: `angle(0)` towards the frame's x,
    /// `angle(π/2)` towards its z, about its y, the axis of a bone.
    pub fn swing_cone(
        &mut self,
        apex: Vec3,
        frame: Quat,
        angle: impl Fn(f32) -> f32,
        length: f32,
        color: Rgb,
    ) {
        let towards = |i: u32| {
            let azimuth = TAU * i as f32 / PIECES as f32;
            let side = Vec2::from_angle(azimuth);
            let tilt = Vec2::from_angle(angle(azimuth));
            let direction = Vec3::new(side.x * tilt.y, tilt.x, side.y * tilt.y);
            apex + frame * direction * length
        };
        let rim: Vec<Vec3> = (0..=PIECES).map(towards).collect();
        self.fan(apex, &rim, 1.5, color);
    }

    /// The sector that `zero`, a unit vector, sweeps when it turns about `axis`, a unit vector
    /// across it, from angle `low` to `high`.
    pub fn sector(
        &mut self,
        centre: Vec3,
        axis: Vec3,
        zero: Vec3,
        [low, high]: [f32; 2],
        radius: f32,
        color: Rgb,
    ) {
        let pieces = (PIECES as f32 * (high - low).abs() / TAU).ceil().max(1.0);
        let side = axis.cross(zero);
        let at = |i: u32| {
            let turn = Vec2::from_angle(low + (high - low) * i as f32 / pieces);
            centre + (zero * turn.x + side * turn.y) * radius
        };
        let rim: Vec<Vec3> = (0..=pieces as u32).map(at).collect();
        self.fan(centre, &rim, 1.5, color);
    }
}

/// Of x, y and z.
const AXES: [Rgb; 3] = [palette::VERMILLION, palette::GREEN, palette::BLUE];

/// Points of a circle about a unit vector, the last one the first again.
fn circle(centre: Vec3, axis: Vec3, radius: f32, pieces: u32) -> Vec<Vec3> {
    let (u, v) = axis.any_orthonormal_pair();
    let piece = Vec2::from_angle(TAU / pieces as f32);
    let mut turn = Vec2::X;
    let mut points = Vec::with_capacity(pieces as usize + 1);
    for _ in 0..pieces {
        points.push(centre + (u * turn.x + v * turn.y) * radius);
        turn = piece.rotate(turn);
    }
    points.push(points[0]);
    points
}

/// A colour in the light from above, so that a solid shows its form.
fn shaded(color: Rgb, normal: Vec3) -> Rgb {
    let light = 0.82 + 0.18 * normal.dot(Vec3::new(0.39, 0.83, 0.39));
    color.map(|part| (part * light).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests;
