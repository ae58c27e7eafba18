//! Pieces that several built-in scenes share: the floor, the open-lidded box, slopes, and
//! what things are made of.

use glam::{DQuat, DVec3};
use serde_json::json;

use crate::{Body, Pole, Scene, Shape};

/// Half of the thickness of floors and walls, m: thick, so that little falls through.
const HALF_THICKNESS: f64 = 0.5;

/// A level floor about the origin; its top is at y = 0.
pub(super) fn floor(half_x: f64, half_z: f64) -> Body {
    let half_extents = DVec3::new(half_x, HALF_THICKNESS, half_z);
    static_box(half_extents, DVec3::new(0.0, -HALF_THICKNESS, 0.0))
}

/// A scene with a floor and four walls about the origin, inner faces at x = ±`inner_x`, z = ±`inner_z`
/// and y = 0. Its `meta` has their places and the seed.
pub(super) fn in_open_box(name: &str, inner: [f64; 2], wall_height: f64, seed: u64) -> Scene {
    let mut scene = Scene::new(name);
    scene.bodies = open_box(inner, wall_height).into();
    for (key, value) in [
        ("inner_half_extents", json!(inner)),
        ("wall_height", json!(wall_height)),
        ("seed", json!(seed)),
    ] {
        scene.meta.insert(key.to_owned(), value);
    }
    scene
}

fn open_box([inner_x, inner_z]: [f64; 2], wall_height: f64) -> [Body; 5] {
    let [outer_x, outer_z] = [inner_x, inner_z].map(|inner| inner + 2.0 * HALF_THICKNESS);
    let [x, z] = [inner_x, inner_z].map(|inner| inner + HALF_THICKNESS);
    let half = wall_height / 2.0;
    let wall_x = DVec3::new(HALF_THICKNESS, half, outer_z);
    let wall_z = DVec3::new(inner_x, half, HALF_THICKNESS);
    [
        floor(outer_x, outer_z),
        static_box(wall_x, DVec3::new(x, half, 0.0)),
        static_box(wall_x, DVec3::new(-x, half, 0.0)),
        static_box(wall_z, DVec3::new(0.0, half, z)),
        static_box(wall_z, DVec3::new(0.0, half, -z)),
    ]
}

/// A box that nothing moves.
pub(super) fn static_box(half_extents: DVec3, position: DVec3) -> Body {
    Body::new(Shape::Box { half_extents }, 0.0, position)
}

/// Gives all bodies these coefficients, so that they are those of every pair too: the mean
/// of equal numbers and their geometric mean are the number.
pub(super) fn of_one_stuff(bodies: &mut [Body], restitution: f64, friction: f64) {
    for body in bodies {
        body.restitution = restitution;
        body.friction = friction;
    }
}

/// The two poles of a bar magnet on its y axis, so far from its middle: north on its +y side, and south.
pub(super) fn poles_of(body: usize, from_middle: f64, strength: f64) -> [Pole; 2] {
    [1.0, -1.0].map(|end| Pole {
        body,
        position: DVec3::new(0.0, end * from_middle, 0.0),
        strength: end * strength,
    })
}

/// An inclined plane: the upper face of a static box, which falls towards +x.
pub(super) struct Slope {
    /// Above the horizontal, rad.
    angle: f64,
    /// Half of its length down the slope, m.
    half_length: f64,
    /// The middle of its upper face, m.
    middle: DVec3,
}

impl Slope {
    const HALF_THICKNESS: f64 = 0.2;
    /// Height of the lower edge of its upper face, m.
    const FOOT: f64 = 0.5;

    /// A slope about x = 0 at this z.
    pub(super) fn new(angle: f64, half_length: f64, z: f64) -> Self {
        let height = Self::FOOT + half_length * libm::sin(angle);
        Self {
            angle,
            half_length,
            middle: DVec3::new(0.0, height, z),
        }
    }

    /// Its x axis points straight down the slope, its y axis out of it.
    pub(super) fn orientation(&self) -> DQuat {
        DQuat::from_rotation_z(-self.angle)
    }

    /// The point at this distance down the slope from its middle, and this far above it, m.
    pub(super) fn point(&self, along: f64, above: f64) -> DVec3 {
        self.middle + self.orientation() * DVec3::new(along, above, 0.0)
    }

    pub(super) fn body(&self, half_width: f64) -> Body {
        let half_extents = DVec3::new(self.half_length, Self::HALF_THICKNESS, half_width);
        Body {
            orientation: self.orientation(),
            ..static_box(half_extents, self.point(0.0, -Self::HALF_THICKNESS))
        }
    }
}
