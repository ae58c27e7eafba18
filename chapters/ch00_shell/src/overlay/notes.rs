//! What stands over the scene itself: letters at the marks of drawings, what their colours mean,
//! and the numbers of the contact that the pointer is at.

use ch00_scenes::ContactPoint;
use egui::{Painter, Pos2, Rect, Visuals, pos2, vec2};
use glam::Vec3;

use super::format::length;
use super::marks::{dot, key_box, note};
use crate::camera::{Camera, Viewport};
use crate::guides::Guides;

/// The pointer is at a contact that is so many points away.
const REACH: f32 = 12.0;

/// Where points of the world are in a part of the screen.
pub struct Projection {
    view_projection: glam::Mat4,
    room: Rect,
}

impl Projection {
    /// Of a camera that sees `room`.
    pub fn new(camera: &Camera, room: Rect) -> Self {
        Self {
            view_projection: camera.view_projection(viewport_of(room)),
            room,
        }
    }

    /// Where a point is, and its depth: the larger the nearer. None behind the viewer.
    pub fn place(&self, point: impl Into<Vec3>) -> Option<(Pos2, f32)> {
        let clip = self.view_projection * point.into().extend(1.0);
        (clip.w > 0.0).then(|| {
            let [x, y, z] = (clip.truncate() / clip.w).to_array();
            let size = self.room.size();
            let across = vec2(0.5 + 0.5 * x, 0.5 - 0.5 * y) * size;
            (self.room.min + across, z)
        })
    }
}

/// A part of the screen as a camera's viewport, in points.
pub fn viewport_of(room: Rect) -> Viewport {
    Viewport {
        origin: glam::Vec2::new(room.min.x, room.min.y),
        size: glam::Vec2::new(room.width().max(1.0), room.height().max(1.0)),
    }
}

/// Paints them onto the room that the panels have left.
pub fn paint(painter: &Painter, visuals: &Visuals, room: Rect, camera: &Camera, guides: &Guides) {
    let projection = Projection::new(camera, room);
    for mark in &guides.marks {
        if let Some((at, _)) = projection.place(mark.at) {
            dot(painter, visuals, at, mark.color, &mark.text);
        }
    }
    if !guides.key.is_empty() {
        let corner = pos2(room.min.x + 10.0, room.max.y - 10.0);
        key_box(painter, visuals, corner, &guides.key);
    }
    let pointer = painter.ctx().input(|input| input.pointer.hover_pos());
    if let Some(pointer) = pointer.filter(|&pointer| room.contains(pointer))
        && let Some(contact) = nearest(&guides.contacts, &projection, pointer)
    {
        note(painter, visuals, pointer, room, words(contact));
    }
}

/// The contact that the pointer is at.
fn nearest<'a>(
    contacts: &'a [ContactPoint],
    projection: &Projection,
    pointer: Pos2,
) -> Option<&'a ContactPoint> {
    let distance = |contact: &ContactPoint| {
        let place = projection.place(contact.point.as_vec3());
        place.map_or(f32::INFINITY, |(at, _)| at.distance(pointer))
    };
    let distances = contacts.iter().map(|contact| (contact, distance(contact)));
    distances
        .filter(|(_, distance)| *distance < REACH)
        .min_by(|one, two| one.1.total_cmp(&two.1))
        .map(|(contact, _)| contact)
}

/// Its numbers.
fn words(contact: &ContactPoint) -> String {
    let along = contact.impulse.dot(contact.normal);
    let across = (contact.impulse - along * contact.normal).length();
    let depth = if contact.depth < 0.0 {
        format!("gap      {}", length(-contact.depth))
    } else {
        format!("depth    {}", length(contact.depth))
    };
    // Adding 0 makes −0 a 0.
    let [x, y, z] = contact
        .normal
        .to_array()
        .map(|part| (100.0 * part).round() / 100.0 + 0.0);
    let share = if along > 0.0 {
        format!(" = {:.2} of it", across / along)
    } else {
        String::new()
    };
    format!(
        "bodies   {} and {}\n{depth}\nnormal   {x:.2} {y:.2} {z:.2}\nimpulse  {along:.4} N s\n\
         friction {across:.4} N s{share}",
        contact.a, contact.b
    )
}

#[cfg(test)]
mod tests {
    use ch00_scenes::Scene;
    use glam::DVec3;

    use super::*;
    use crate::render::Surroundings;

    fn contact(point: DVec3) -> ContactPoint {
        ContactPoint {
            a: 1,
            b: 2,
            point,
            normal: DVec3::Y,
            depth: 0.001,
            impulse: DVec3::new(0.3, 0.5, 0.4),
        }
    }

    #[test]
    fn the_contact_under_the_pointer_is_found_and_none_beside_it() {
        let room = Rect::from_min_size(pos2(300.0, 0.0), vec2(900.0, 700.0));
        let around = Surroundings::of(&Scene::new("empty"));
        let camera = Camera::framing(&around, Viewport::whole([900, 700]));
        let projection = Projection::new(&camera, room);
        let contacts = [contact(DVec3::ZERO), contact(DVec3::X)];
        let (at, _) = projection.place(Vec3::X).expect("it is in the picture");
        let found = nearest(&contacts, &projection, at + vec2(3.0, 3.0));
        assert_eq!(found.map(|contact| contact.point), Some(DVec3::X));
        assert!(nearest(&contacts, &projection, at + vec2(30.0, 0.0)).is_none());
    }

    #[test]
    fn the_middle_of_the_room_is_what_the_camera_looks_at() {
        let room = Rect::from_min_size(pos2(300.0, 10.0), vec2(900.0, 700.0));
        let around = Surroundings::of(&Scene::new("empty"));
        let camera = Camera::framing(&around, Viewport::whole([900, 700]));
        let place = Projection::new(&camera, room).place(camera.target);
        assert!(place.is_some_and(|(at, _)| at.distance(room.center()) < 1e-3));
    }

    #[test]
    fn friction_is_the_part_across_the_normal() {
        let text = words(&contact(DVec3::ZERO));
        assert!(text.contains("impulse  0.5000 N s"), "{text}");
        assert!(text.contains("friction 0.5000 N s = 1.00 of it"), "{text}");
        assert!(text.contains("depth    1.00 mm"), "{text}");
    }
}
