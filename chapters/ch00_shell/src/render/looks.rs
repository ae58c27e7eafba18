//! How bodies look, whatever their place: one instance a body, sorted by what is drawn with the same
//! mesh and pipeline. They change when bodies come, go or are seen as glass, not from frame to frame.

use std::ops::Range;

use ch00_scenes::{Body, Shape};
use glam::Vec3;

use super::Picture;
use super::surroundings::Surroundings;
use super::theme::{Theme, body_color, pair_color};

/// A body in the instance buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Look {
    /// What multiplies a vertex's position, and what its `axis` is multiplied by, m.
    size: [f32; 4],
    /// Linear.
    color: [f32; 3],
    /// 0 ball, 1 box, 2 capsule, 3 cylinder.
    shape: u32,
    /// Index of the body: its row among those that are drawn.
    body: u32,
}

/// How looks lie in their buffer.
pub const LOOK: [wgpu::VertexAttribute; 4] =
    wgpu::vertex_attr_array![3 => Float32x4, 4 => Float32x3, 5 => Uint32, 6 => Uint32];

/// Which of a shape's pipelines draws a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Two tones that show how it turns.
    Moving,
    /// Plain, with the ground's grid.
    Static,
    /// To look through.
    Glass,
}

const KINDS: [Kind; 3] = [Kind::Moving, Kind::Static, Kind::Glass];

/// Bodies drawn in one go: of one shape and one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// 0 ball, 1 box, 2 capsule, 3 cylinder.
    pub shape: usize,
    /// How they are drawn.
    pub kind: Kind,
    /// Their instances.
    pub range: Range<u32>,
}

/// What looks follow from, besides the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Key {
    bodies: usize,
    pair: Option<[usize; 2]>,
    is_glass: bool,
    theme: Theme,
}

/// Balls up to which they are kept in order, the farthest first. An edge is mixed with what was drawn
/// before it, so that out of order it isn't smooth, which many small balls don't show.
const MOST_SORTED: usize = 20_000;

/// So many states later the order is looked at again.
const SORT_EVERY: u64 = 10;

/// Looks of all bodies but walls, and their groups.
#[derive(Debug, Default)]
pub struct Looks {
    key: Option<Key>,
    sorted: [Vec<Look>; 4 * KINDS.len()],
    /// From where and in which state the balls were put in order.
    sorted_for: Option<(Vec3, u64)>,
    /// All looks, group after group.
    pub all: Vec<Look>,
    /// The groups that are not empty.
    pub groups: Vec<Group>,
}

impl Looks {
    /// Takes the bodies of a picture; whether anything has changed.
    pub fn follow(&mut self, picture: &Picture, surroundings: &Surroundings) -> bool {
        let key = Key {
            bodies: picture.session.scene().bodies.len(),
            pair: picture.pair,
            is_glass: picture.is_glass,
            theme: picture.theme,
        };
        let is_new = self.key != Some(key);
        if is_new {
            self.key = Some(key);
            self.sorted_for = None;
            self.collect(picture, surroundings);
        }
        let has_changed = self.sort_balls(picture) || is_new;
        if has_changed {
            self.join();
        }
        has_changed
    }

    /// Another scene has begun, or a body was taken out.
    pub fn forget(&mut self) {
        self.key = None;
    }

    fn collect(&mut self, picture: &Picture, surroundings: &Surroundings) {
        self.sorted.iter_mut().for_each(Vec::clear);
        let ground = picture.theme.colors().ground;
        for (i, body) in picture.session.scene().bodies.iter().enumerate() {
            if surroundings.is_scenery(i) {
                continue;
            }
            let (shape, size) = shape_and_size(&body.shape);
            let place = picture
                .pair
                .and_then(|pair| pair.iter().position(|&j| j == i));
            let color = match place {
                Some(place) => pair_color(place),
                None if body.is_static() => ground,
                None => color_in_family(surroundings.number(i), surroundings.family(i)),
            };
            let is_glass = picture.is_glass && place.is_none();
            let group = KINDS.len() * shape + kind(body, is_glass) as usize;
            self.sorted[group].push(Look {
                size,
                color: color.to_array(),
                shape: [0, 1, 2, 3][shape],
                body: count(i),
            });
        }
    }

    /// Puts the balls in order where that is due, the farthest first; whether it was.
    fn sort_balls(&mut self, picture: &Picture) -> bool {
        let (session, eye) = (picture.session, picture.camera.position());
        let now = session.revision();
        let is_in_order = self
            .sorted_for
            .is_some_and(|(from, then)| from == eye && now < then + SORT_EVERY);
        let balls: usize = self.sorted[..KINDS.len()].iter().map(Vec::len).sum();
        if is_in_order || balls == 0 || balls > MOST_SORTED {
            return false;
        }
        self.sorted_for = Some((eye, now));
        let positions = &session.state_now().position;
        let distance = |ball: &Look| {
            let place = positions.get(ball.body as usize);
            place.map_or(0.0, |place| place.as_vec3().distance_squared(eye))
        };
        for balls in &mut self.sorted[..KINDS.len()] {
            balls.sort_unstable_by(|a, b| distance(b).total_cmp(&distance(a)));
        }
        true
    }

    fn join(&mut self) {
        self.all.clear();
        self.groups.clear();
        for (i, looks) in self.sorted.iter().enumerate().rev() {
            let (shape, kind) = (i / KINDS.len(), KINDS[i % KINDS.len()]);
            let start = count(self.all.len());
            self.all.extend_from_slice(looks);
            let range = start..count(self.all.len());
            if !range.is_empty() {
                self.groups.push(Group { shape, kind, range });
            }
        }
    }
}

/// The colour of the family, every other member darker, so that limbs can be told apart.
fn color_in_family(number: usize, family: usize) -> Vec3 {
    body_color(family) * [1.0, 0.6][(number - family) % 2]
}

/// How a body is drawn; one that can't move is never of glass.
fn kind(body: &Body, is_glass: bool) -> Kind {
    match (body.is_static(), &body.shape) {
        // A ball's own pattern is the only one that its shader has.
        (true, Shape::Sphere { .. }) => Kind::Moving,
        (true, _) => Kind::Static,
        (false, _) if is_glass => Kind::Glass,
        (false, _) => Kind::Moving,
    }
}

/// The shape's number, and how it is scaled: what multiplies a vertex's position, and what
/// its `axis` is multiplied by.
fn shape_and_size(shape: &Shape) -> (usize, [f32; 4]) {
    let round = |radius: f64, half_height: f64| {
        let size = glam::DVec2::new(radius, half_height).as_vec2();
        Vec3::splat(size.x).extend(size.y).to_array()
    };
    match *shape {
        Shape::Sphere { radius } => (0, round(radius, 0.0)),
        Shape::Box { half_extents } => (1, half_extents.as_vec3().extend(0.0).to_array()),
        Shape::Capsule {
            radius,
            half_height,
        } => (2, round(radius, half_height)),
        Shape::Cylinder {
            radius,
            half_height,
        } => (3, round(radius, half_height)),
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "memory ends before 2³² bodies"
)]
fn count(i: usize) -> u32 {
    i as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Session;
    use crate::camera::{Camera, Viewport};
    use crate::test_engine::balls;

    /// A picture from beyond the last of balls in a row.
    fn picture<'a>(session: &'a Session, camera: &'a Camera) -> Picture<'a> {
        Picture {
            session,
            alpha: 1.0,
            camera,
            viewport: Viewport::whole([640, 360]),
            scale: 1.0,
            theme: Theme::Light,
            margin: wgpu::Color::WHITE,
            picked: None,
            pair: None,
            is_glass: false,
            strokes: &[],
            faces: &[],
            is_as_read: false,
        }
    }

    fn camera(around: &Surroundings) -> Camera {
        let mut camera = Camera::framing(around, Viewport::whole([640, 360]));
        camera.target = Vec3::new(100.0, 10.0, 0.0);
        camera
    }

    fn order(looks: &Looks) -> Vec<u32> {
        looks.all.iter().map(|look| look.body).collect()
    }

    #[test]
    fn the_farthest_balls_come_first_as_edges_are_mixed_with_what_was_drawn() {
        let session = balls(4);
        let around = Surroundings::of(session.scene());
        let mut camera = camera(&around);
        let mut looks = Looks::default();
        assert!(looks.follow(&picture(&session, &camera), &around));
        assert_eq!(order(&looks), [0, 1, 2, 3]);
        camera.target.x = -100.0;
        assert!(looks.follow(&picture(&session, &camera), &around));
        assert_eq!(order(&looks), [3, 2, 1, 0]);
    }

    #[test]
    fn nothing_changes_from_frame_to_frame_but_the_order_now_and_then() {
        let mut session = balls(4);
        let around = Surroundings::of(session.scene());
        let camera = camera(&around);
        let mut looks = Looks::default();
        let mut changed = Vec::new();
        for _ in 0..=SORT_EVERY {
            changed.push(looks.follow(&picture(&session, &camera), &around));
            session.step();
        }
        let between = SORT_EVERY as usize - 1;
        assert_eq!(
            changed,
            [vec![true], vec![false; between], vec![true]].concat()
        );
    }

    #[test]
    fn what_is_picked_changes_no_look_and_what_is_looked_at_does() {
        let session = balls(4);
        let around = Surroundings::of(session.scene());
        let camera = camera(&around);
        let mut looks = Looks::default();
        let mut picture = picture(&session, &camera);
        looks.follow(&picture, &around);
        picture.picked = Some(1);
        assert!(!looks.follow(&picture, &around));
        picture.pair = Some([0, 2]);
        picture.is_glass = true;
        assert!(looks.follow(&picture, &around));
        let kinds: Vec<_> = looks.groups.iter().map(|group| group.kind).collect();
        assert_eq!(kinds, [Kind::Glass, Kind::Moving]);
        assert_eq!(order(&looks), [1, 3, 0, 2]);
    }
}
