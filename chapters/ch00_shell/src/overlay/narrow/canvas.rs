//! The set of differences a − b, seen as glass, with what an iteration has found in it. All is
//! projected here and painted from far to near; the camera turns with the scene's, so that
//! directions are the same in both, and can be turned further with the mouse.

use ch00_scenes::{Dissection, Drawing, SurfacePoint, palette};
use egui::epaint::Mesh;
use egui::{Align2, Color32, Pos2, Rect, Sense, Shape, Stroke, Visuals, vec2};
use glam::{Vec2, Vec3};

use crate::camera::Camera;
use crate::overlay::marks::{color32, dot, letters, plain_color};
use crate::overlay::notes::{Projection, viewport_of};
use crate::show::Pair;

/// A line is cut into so many pieces, so that each has a depth of its own.
const PIECES: u8 = 8;

/// Closest and farthest view.
const ZOOMS: std::ops::RangeInclusive<f32> = 0.4..=60.0;

/// Shows it, and lets the user turn it.
pub fn show(
    ui: &mut egui::Ui,
    height: f32,
    pair: &mut Pair,
    dissection: &Dissection,
    camera: &Camera,
) {
    let size = vec2(ui.available_width(), height);
    let (room, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    turn(ui, &response, pair);
    let visuals = ui.visuals();
    let painter = ui.painter_at(room);
    let edge = visuals.widgets.noninteractive.bg_stroke;
    let paper = visuals.extreme_bg_color;
    painter.rect(room, 6.0, paper, edge, egui::StrokeKind::Inside);
    let view = View::new(pair, dissection, camera, room);
    let axes = axes(view.radius);
    painter.extend([view.surface(&dissection.surface, visuals, Side::Back)]);
    painter.extend([view.surface(&dissection.core, visuals, Side::Back)]);
    painter.extend(view.drawings(&[&axes, &dissection.difference], visuals));
    painter.extend([view.surface(&dissection.core, visuals, Side::Front)]);
    painter.extend([view.surface(&dissection.surface, visuals, Side::Front)]);
    painter.extend(view.outline(&dissection.core, visuals, 0.8));
    painter.extend(view.outline(&dissection.surface, visuals, 1.3));
    view.paint_marks(&painter, visuals, &dissection.difference);
    let corner = room.right_bottom() - vec2(8.0, 6.0);
    letters(
        &painter,
        visuals,
        corner,
        Align2::RIGHT_BOTTOM,
        "a − b",
        12.0,
    );
}

/// Dragging turns, the wheel moves closer, a double click undoes both.
fn turn(ui: &egui::Ui, response: &egui::Response, pair: &mut Pair) {
    const RADIANS_PER_POINT: f32 = 0.008;
    let drag = response.drag_delta();
    pair.turn += Vec2::new(-drag.x, drag.y) * RADIANS_PER_POINT;
    if response.hovered() {
        let scroll = ui.input(|input| input.smooth_scroll_delta.y);
        pair.zoom = (pair.zoom * (0.004 * scroll).exp()).clamp(*ZOOMS.start(), *ZOOMS.end());
    }
    if response.double_clicked() {
        *pair = Pair {
            step: pair.step,
            ..Pair::new(pair.bodies)
        };
    }
}

/// Short axes at the origin of differences, those of the world.
fn axes(radius: f32) -> Drawing {
    let mut drawing = Drawing::default();
    for axis in Vec3::AXES {
        let tip = 0.22 * radius * axis;
        drawing.arrow_with_head(Vec3::ZERO, tip, 0.05 * radius, 1.0, palette::GREY);
    }
    drawing
}

/// Triangles of a closed surface.
type Surface = [[SurfacePoint; 3]];

/// Which half of a surface.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    /// Turned away from the viewer.
    Back,
    /// Turned to the viewer.
    Front,
}

/// From where the differences are seen.
struct View {
    projection: Projection,
    eye: Vec3,
    /// Of what there is to see, m.
    radius: f32,
}

impl View {
    fn new(pair: &Pair, dissection: &Dissection, camera: &Camera, room: Rect) -> Self {
        let (centre, radius) = extent(dissection);
        let mut own = Camera {
            // The closer, the more it is about the origin.
            target: centre / pair.zoom.max(1.0),
            yaw: camera.yaw + pair.turn.x,
            pitch: (camera.pitch + pair.turn.y).clamp(-1.55, 1.55),
            ..camera.clone()
        };
        own.fit_ball(radius / pair.zoom, viewport_of(room));
        Self {
            projection: Projection::new(&own, room),
            eye: own.position(),
            radius,
        }
    }

    /// One half of the surface of differences: the more it turns away, the less one sees
    /// through it.
    fn surface(&self, surface: &Surface, visuals: &Visuals, side: Side) -> Shape {
        let (glass, least, most) = match (visuals.dark_mode, side) {
            (true, Side::Back) => (Vec3::new(0.45, 0.60, 0.80), 0.05, 0.25),
            (true, Side::Front) => (Vec3::new(0.70, 0.82, 0.97), 0.05, 0.40),
            (false, Side::Back) => (Vec3::new(0.33, 0.45, 0.60), 0.06, 0.26),
            (false, Side::Front) => (Vec3::new(0.42, 0.56, 0.72), 0.06, 0.42),
        };
        let color = |point: &SurfacePoint| {
            let (at, normal) = (Vec3::from(point.at), Vec3::from(point.normal));
            let to_eye = (self.eye - at).normalize_or_zero();
            let away = 1.0 - normal.dot(to_eye).abs();
            let light = 0.85 + 0.15 * normal.dot(Vec3::new(0.37, 0.79, 0.49));
            plain_color(
                (glass * light).to_array(),
                least + (most - least) * away * away,
            )
        };
        let mut mesh = Mesh::default();
        for corners in surface {
            let outward: Vec3 = corners.iter().map(|point| Vec3::from(point.normal)).sum();
            let is_front = outward.dot(self.eye - Vec3::from(corners[0].at)) > 0.0;
            if is_front == (side == Side::Front) {
                self.add_triangle(
                    &mut mesh,
                    corners.map(|p| p.at),
                    corners.each_ref().map(color),
                );
            }
        }
        Shape::mesh(mesh)
    }

    fn add_triangle(&self, mesh: &mut Mesh, corners: [[f32; 3]; 3], colors: [Color32; 3]) {
        let places = corners.map(|corner| self.projection.place(corner));
        if let [Some(a), Some(b), Some(c)] = places {
            #[expect(clippy::cast_possible_truncation, reason = "a few thousand corners")]
            let first = mesh.vertices.len() as u32;
            for ((at, _), color) in [a, b, c].into_iter().zip(colors) {
                mesh.colored_vertex(at, color);
            }
            mesh.add_triangle(first, first + 1, first + 2);
        }
    }

    /// Lines and faces, the farthest first.
    fn drawings(&self, drawings: &[&Drawing], visuals: &Visuals) -> Vec<Shape> {
        let mut parts: Vec<(f32, Part)> = Vec::new();
        for drawing in drawings {
            for face in &drawing.faces {
                let middle = face.corners.map(Vec3::from).into_iter().sum::<Vec3>() / 3.0;
                if let Some((_, depth)) = self.projection.place(middle) {
                    let [r, g, b, opacity] = face.color;
                    let color = color32(visuals, [r, g, b], opacity);
                    parts.push((depth, Part::Face(face.corners, color)));
                }
            }
            for line in &drawing.lines {
                let (from, to) = (Vec3::from(line.from), Vec3::from(line.to));
                let at = |i: u8| from.lerp(to, f32::from(i) / f32::from(PIECES));
                let stroke = Stroke::new(line.width, color32(visuals, line.color, 1.0));
                for i in 0..PIECES {
                    let ends = [at(i), at(i + 1)].map(|end| self.projection.place(end));
                    if let [Some((a, depth_a)), Some((b, depth_b))] = ends {
                        let depth = f32::midpoint(depth_a, depth_b);
                        // A hair nearer than the face whose edge it is.
                        parts.push((1.002 * depth, Part::Line([a, b], stroke)));
                    }
                }
            }
        }
        parts.sort_by(|one, two| one.0.total_cmp(&two.0));
        let shape = |(_, part): (f32, Part)| match part {
            Part::Line(ends, stroke) => Shape::line_segment(ends, stroke),
            Part::Face(corners, color) => {
                let mut mesh = Mesh::default();
                self.add_triangle(&mut mesh, corners, [color; 3]);
                Shape::mesh(mesh)
            }
        };
        parts.into_iter().map(shape).collect()
    }

    /// The line around the surface as it is seen.
    fn outline(&self, surface: &Surface, visuals: &Visuals, width: f32) -> Option<Shape> {
        let points = surface.iter().flatten();
        let places = points.filter_map(|point| Some(self.projection.place(point.at)?.0));
        let hull = convex_hull(places.collect());
        let ink = visuals.weak_text_color().gamma_multiply(0.8);
        (hull.len() > 2).then(|| Shape::closed_line(hull, Stroke::new(width, ink)))
    }

    /// Its marks, and the origin.
    fn paint_marks(&self, painter: &egui::Painter, visuals: &Visuals, drawing: &Drawing) {
        for mark in &drawing.marks {
            if let Some((at, _)) = self.projection.place(mark.at) {
                dot(painter, visuals, at, mark.color, &mark.text);
            }
        }
        if let Some((at, _)) = self.projection.place(Vec3::ZERO) {
            let (ink, paper) = (visuals.strong_text_color(), visuals.extreme_bg_color);
            painter.circle_filled(at, 5.5, paper);
            painter.circle_stroke(at, 4.5, Stroke::new(1.6, ink));
            painter.circle_filled(at, 1.8, ink);
            let place = at + vec2(-8.0, 8.0);
            letters(painter, visuals, place, Align2::RIGHT_TOP, "0", 13.0);
        }
    }
}

/// A piece of a drawing.
enum Part {
    Line([Pos2; 2], Stroke),
    Face([[f32; 3]; 3], Color32),
}

/// The middle and the radius of a ball about all differences and the origin, m.
fn extent(dissection: &Dissection) -> (Vec3, f32) {
    let points = || {
        dissection
            .surface
            .iter()
            .flatten()
            .map(|p| Vec3::from(p.at))
    };
    let low = points().fold(Vec3::ZERO, Vec3::min);
    let high = points().fold(Vec3::ZERO, Vec3::max);
    let centre = 0.5 * (low + high);
    let radius = points().fold(centre.length(), |radius, p| radius.max(p.distance(centre)));
    // A little more for the axes.
    (centre, 1.1 * radius.max(1e-6))
}

/// The corners of the smallest convex shape about these points, in order around it.
/// Andrew's monotone chain.
fn convex_hull(mut points: Vec<Pos2>) -> Vec<Pos2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let turns_left = |a: Pos2, b: Pos2, c: Pos2| {
        let (ab, bc) = (b - a, c - b);
        ab.x * bc.y - ab.y * bc.x > 0.0
    };
    let chain = |points: &mut dyn Iterator<Item = Pos2>| {
        let mut chain: Vec<Pos2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && !turns_left(a, b, point)
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    hull
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    #[test]
    fn the_hull_of_a_filled_square_is_its_corners() {
        let mut points = Vec::new();
        for x in 0..5_u8 {
            for y in 0..5_u8 {
                points.push(pos2(f32::from(x), f32::from(y)));
            }
        }
        let hull = convex_hull(points);
        assert_eq!(hull.len(), 4);
        for corner in [
            pos2(0.0, 0.0),
            pos2(4.0, 0.0),
            pos2(4.0, 4.0),
            pos2(0.0, 4.0),
        ] {
            assert!(hull.contains(&corner), "{hull:?}");
        }
    }

    #[test]
    fn the_hull_of_nearly_nothing_is_nothing_to_draw() {
        assert!(convex_hull(Vec::new()).is_empty());
        assert!(convex_hull(vec![pos2(1.0, 1.0); 3]).len() < 3);
    }

    #[test]
    fn everything_and_the_origin_are_inside_the_ball_to_see() {
        let point = |at| SurfacePoint {
            at,
            normal: [0.0, 1.0, 0.0],
        };
        let corners = [[3.0, 0.0, 0.0], [5.0, 1.0, 0.0], [4.0, 0.0, 2.0]];
        let dissection = Dissection {
            phases: Vec::new(),
            step: 0,
            title: String::new(),
            text: String::new(),
            bounds: Vec::new(),
            surface: vec![corners.map(point)],
            core: Vec::new(),
            difference: Drawing::default(),
            world: Drawing::default(),
        };
        let (centre, radius) = extent(&dissection);
        for at in corners.into_iter().chain([[0.0; 3]]) {
            assert!(Vec3::from(at).distance(centre) <= radius);
        }
    }
}
