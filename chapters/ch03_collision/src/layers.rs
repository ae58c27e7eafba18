//! What the overlay can draw of the broad phase, of contacts and of bodies. All of it is drawn from plain
//! values, so that it doesn't matter whether an engine keeps them in objects or in columns.

use ch00_maths::f32::shape::Shape;
use ch00_scenes::{ContactPoint, Drawing, Rgb, palette};
use glam::{Quat, Vec3};

use crate::aabb::Aabb;

const NORMAL: Rgb = palette::BLUE;
const IMPULSE: Rgb = palette::VERMILLION;
const FRICTION: Rgb = palette::PURPLE;
const GAP: Rgb = palette::GREY;

/// Colours of the KD-tree's levels, from the root down: a ramp from dark to light, so that order
/// shows without its key.
const LEVELS: [Rgb; 5] = [
    [0.267, 0.005, 0.329],
    [0.231, 0.322, 0.545],
    [0.129, 0.569, 0.549],
    [0.369, 0.789, 0.384],
    [0.800, 0.860, 0.180],
];

/// A body as drawings see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyView {
    /// Its solid.
    pub shape: Shape,
    /// Its centre, m.
    pub position: Vec3,
    /// Body to world.
    pub orientation: Quat,
    /// Its mass, kg; `None` for a body that can't move.
    pub mass: Option<f32>,
}

impl BodyView {
    /// Whether nothing moves it.
    #[must_use]
    pub fn is_static(&self) -> bool {
        self.mass.is_none()
    }
}

/// The bounding boxes of the bodies that have one: those that overlap one of another moving body
/// stand out. `pairs` are the broad phase's.
#[must_use]
pub fn boxes(aabbs: &[Aabb], pairs: &[(usize, usize)], bodies: &[BodyView]) -> Drawing {
    let mut drawing = Drawing::default();
    let mut is_paired = vec![false; bodies.len()];
    for &(a, b) in pairs {
        is_paired[a] |= !bodies[b].is_static();
        is_paired[b] |= !bodies[a].is_static();
    }
    for (i, aabb) in aabbs.iter().enumerate() {
        if !aabb.min.is_finite() {
            continue;
        }
        let (width, color) = match (bodies[i].is_static(), is_paired[i]) {
            (true, _) => (0.8, palette::GREY),
            (false, true) => (1.5, palette::ORANGE),
            (false, false) => (1.5, palette::BLUE),
        };
        drawing.cuboid(aabb.min, aabb.max, width, color);
    }
    drawing.explain(
        palette::BLUE,
        "bounding box that meets none of another moving body",
    );
    drawing.explain(palette::ORANGE, "one that does: the narrow phase looks");
    drawing.explain(palette::GREY, "that of a body that can't move");
    drawing
}

/// The cells of the KD-tree with how deep each lies, a colour a level.
#[must_use]
pub fn cells(cells: &[(Aabb, u32)]) -> Drawing {
    let mut drawing = Drawing::default();
    let deepest = cells.iter().map(|(_, depth)| *depth).max().unwrap_or(0);
    for (cell, depth) in cells.iter().filter(|(cell, _)| cell.min.is_finite()) {
        let width = 1.0 + 1.6 / (1.0 + *depth as f32);
        drawing.cuboid(cell.min, cell.max, width, level_color(*depth, deepest));
    }
    for depth in 0..=deepest {
        let count = cells.iter().filter(|cell| cell.1 == depth).count();
        let cells = if count == 1 { "cell" } else { "cells" };
        let text = format!("level {depth}: {count} {cells}");
        drawing.explain(level_color(depth, deepest), text);
    }
    drawing
}

/// Of a level in a tree with so many below the root.
fn level_color(depth: u32, deepest: u32) -> Rgb {
    let place = (LEVELS.len() - 1) as f32 * depth as f32 / deepest.max(1) as f32;
    let i = (place as usize).min(LEVELS.len() - 2);
    let (from, to) = (Vec3::from(LEVELS[i]), Vec3::from(LEVELS[i + 1]));
    from.lerp(to, place - i as f32).to_array()
}

/// How large contacts are drawn: the same from step to step.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scale {
    /// Mean radius of balls as large as the bodies that can move, m.
    radius: f32,
    /// What carries a body of mean mass for 1/60 s, N s: an arrow as long as `radius`.
    impulse: f32,
}

/// Volume of a ball of radius 1 m, m³.
const BALL: f32 = 4.0 / 3.0 * std::f32::consts::PI;

/// An arrow is at most as long as so many mean radii.
const LONGEST: f32 = 6.0;

impl Scale {
    fn of(bodies: &[BodyView]) -> Self {
        let (mut radius, mut mass, mut count) = (0.0, 0.0, 0.0_f32);
        for (body, its_mass) in bodies.iter().filter_map(|body| Some((body, body.mass?))) {
            radius += (body.shape.volume() / BALL).powf(1.0 / 3.0);
            mass += its_mass;
            count += 1.0;
        }
        Self {
            radius: radius / count.max(1.0),
            impulse: (mass / count.max(1.0) * 9.81 / 60.0).max(1e-9),
        }
    }

    /// Length and width both grow with the root, so that the area that an arrow covers shows
    /// the impulse.
    fn arrow(self, drawing: &mut Drawing, from: Vec3, impulse: Vec3, color: Rgb) {
        let size = (impulse.length() / self.impulse).sqrt().min(LONGEST);
        let length = size * self.radius;
        if size > 0.05 {
            let head = (0.4 * length).min(0.45 * self.radius);
            let to = from + impulse.normalize() * length;
            drawing.arrow_with_head(from, to, head, (2.2 * size).clamp(1.5, 5.0), color);
        }
    }
}

/// A disc at each contact, or a ring where there is still a gap; its normal; the impulse along
/// the normal and the one across it, which is friction. All are drawn as the body that can move
/// gets them; where both can, as body 1 does.
#[must_use]
pub fn contacts(contacts: &[ContactPoint], bodies: &[BodyView]) -> Drawing {
    let mut drawing = Drawing::default();
    let scale = Scale::of(bodies);
    let spot = 0.16 * scale.radius;
    for contact in contacts {
        let sign = if bodies[contact.a].is_static() {
            -1.0
        } else {
            1.0
        };
        let (point, normal) = (contact.point.as_vec3(), sign * contact.normal.as_vec3());
        let impulse = sign * contact.impulse.as_vec3();
        let along = impulse.project_onto_normalized(normal);
        let across = impulse - along;
        if contact.depth >= 0.0 {
            drawing.disc(point, normal, spot, NORMAL, 0.45);
            drawing.ring(point, normal, spot, 1.5, NORMAL);
        } else {
            drawing.ring(point, normal, spot, 1.2, GAP);
        }
        if contact.depth >= 0.0 || impulse != Vec3::ZERO {
            let tip = point + normal * (0.6 * scale.radius);
            drawing.arrow_with_head(point, tip, 0.12 * scale.radius, 1.2, NORMAL);
        }
        scale.arrow(&mut drawing, point, along, IMPULSE);
        scale.arrow(&mut drawing, point, across, FRICTION);
    }
    drawing.explain(
        NORMAL,
        "contact and its normal; a grey ring while there is a gap",
    );
    let unit = scale.impulse;
    drawing.explain(
        IMPULSE,
        format!("impulse; {unit:.2} N s: one mean radius long, 4 times as much: two"),
    );
    drawing.explain(FRICTION, "the part of it that is friction");
    drawing
}

/// The axes of each body that can move.
#[must_use]
pub fn frames(bodies: &[BodyView]) -> Drawing {
    let mut drawing = Drawing::default();
    for body in bodies.iter().filter(|body| !body.is_static()) {
        let length = 1.2 * body.shape.bounding_radius();
        drawing.frame(body.position, body.orientation, length, 1.8);
    }
    drawing
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_go_from_the_darkest_to_the_lightest() {
        assert_eq!(level_color(0, 7), LEVELS[0]);
        let last = Vec3::from(level_color(7, 7));
        assert!(last.distance(LEVELS[4].into()) < 1e-6);
        assert_eq!(level_color(0, 0), LEVELS[0]);
        let brightness = |depth| Vec3::from(level_color(depth, 7)).element_sum();
        assert!((0..7).all(|depth| brightness(depth) < brightness(depth + 1)));
    }

    #[test]
    fn an_arrows_area_grows_with_the_impulse_up_to_a_limit() {
        let scale = Scale {
            radius: 0.5,
            impulse: 2.0,
        };
        let length = |impulse: f32| {
            let mut drawing = Drawing::default();
            scale.arrow(&mut drawing, Vec3::ZERO, impulse * Vec3::X, IMPULSE);
            drawing
                .faces
                .iter()
                .map(|face| face.corners[2][0])
                .fold(0.0, f32::max)
        };
        assert!((length(2.0) - 0.5).abs() < 1e-6);
        assert!((length(8.0) - 1.0).abs() < 1e-6);
        assert!((length(1e9) - 3.0).abs() < 1e-6);
        assert_eq!(length(0.0), 0.0);
    }
}
