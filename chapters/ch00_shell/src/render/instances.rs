//! Bodies as the bodies' shader wants them: one instance a body, sorted by what is drawn
//! with the same mesh and pipeline.

use std::ops::Range;

use ch00_scenes::{Body, Shape};
use glam::Vec3;

use super::Picture;
use super::surroundings::Surroundings;
use super::theme::{Colors, body_color, pair_color};

/// A body in the instance buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Instance {
    position: [f32; 3],
    shape: u32,
    orientation: [f32; 4],
    size: [f32; 4],
    color: [f32; 4],
}

/// Which of a shape's pipelines draws a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Two tones that show how it turns.
    Moving,
    /// Plain, with the ground's grid.
    Static,
    /// To look through.
    Glass,
}

const LOOKS: [Look; 3] = [Look::Moving, Look::Static, Look::Glass];

/// Bodies drawn in one go: of one shape and one look.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// 0 ball, 1 box, 2 capsule, 3 cylinder.
    pub shape: usize,
    /// How they are drawn.
    pub look: Look,
    /// Their instances.
    pub range: Range<u32>,
}

/// Instances of all bodies but walls, and their groups. Kept over frames for its memory.
#[derive(Debug, Default)]
pub struct Instances {
    sorted: [Vec<Instance>; 4 * LOOKS.len()],
    /// All instances, group after group.
    pub all: Vec<Instance>,
    /// The groups that are not empty.
    pub groups: Vec<Group>,
}

impl Instances {
    /// Fills it with the bodies of a picture. Balls come last, the farthest first, as their
    /// edges are mixed with what is behind them.
    pub fn fill(&mut self, picture: &Picture, surroundings: &Surroundings, colors: &Colors) {
        self.sorted.iter_mut().for_each(Vec::clear);
        for (i, body) in picture.session.scene().bodies.iter().enumerate() {
            if surroundings.is_scenery(i) {
                continue;
            }
            let (shape, size) = shape_and_size(&body.shape);
            let (position, orientation) = picture.session.pose(i, picture.alpha);
            let place = picture
                .pair
                .and_then(|pair| pair.iter().position(|&j| j == i));
            let color = match place {
                Some(place) => pair_color(place),
                None if body.is_static() => colors.ground,
                None => color_in_family(surroundings.number(i), surroundings.family(i)),
            };
            let is_glass = picture.is_glass && place.is_none();
            let glow = if picture.picked == Some(i) { 1.0 } else { 0.0 };
            let group = LOOKS.len() * shape + look(body, is_glass) as usize;
            self.sorted[group].push(Instance {
                position: position.as_vec3().to_array(),
                shape: [0, 1, 2, 3][shape],
                orientation: orientation.as_quat().to_array(),
                size,
                color: color.extend(glow).to_array(),
            });
        }
        self.sort_balls(picture.camera.position());
        self.join();
    }

    fn sort_balls(&mut self, eye: Vec3) {
        let distance = |ball: &Instance| Vec3::from(ball.position).distance_squared(eye);
        for balls in &mut self.sorted[..LOOKS.len()] {
            balls.sort_unstable_by(|a, b| distance(b).total_cmp(&distance(a)));
        }
    }

    fn join(&mut self) {
        self.all.clear();
        self.groups.clear();
        for (i, instances) in self.sorted.iter().enumerate().rev() {
            let (shape, look) = (i / LOOKS.len(), LOOKS[i % LOOKS.len()]);
            let start = count(self.all.len());
            self.all.extend_from_slice(instances);
            let range = start..count(self.all.len());
            if !range.is_empty() {
                self.groups.push(Group { shape, look, range });
            }
        }
    }
}

/// The colour of the family, every other member darker, so that limbs can be told apart.
fn color_in_family(number: usize, family: usize) -> Vec3 {
    body_color(family) * [1.0, 0.6][(number - family) % 2]
}

/// How a body is drawn; one that can't move is never of glass.
fn look(body: &Body, is_glass: bool) -> Look {
    match (body.is_static(), &body.shape) {
        // A ball's own pattern is the only one that its shader has.
        (true, Shape::Sphere { .. }) => Look::Moving,
        (true, _) => Look::Static,
        (false, _) if is_glass => Look::Glass,
        (false, _) => Look::Moving,
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
