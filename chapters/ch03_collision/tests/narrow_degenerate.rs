//! The narrow phase where it is hardest: solids in one place, parallel, touching exactly, very
//! thin, of very different sizes, far from the origin. The result is finite, its normal has length
//! 1, and its depth is right.

#[path = "narrow_degenerate/any.rs"]
mod any;
#[path = "narrow_degenerate/boxes.rs"]
mod boxes;
#[path = "narrow_degenerate/round.rs"]
mod round;

use ch00_maths::f32::shape::Shape;
use ch03_collision::narrow::{Placed, Touch, touch};
use glam::{Quat, Vec3};

const QUARTER: f32 = std::f32::consts::FRAC_PI_2;
const EIGHTH: f32 = std::f32::consts::FRAC_PI_4;

/// A solid somewhere.
#[derive(Clone, Copy, Debug)]
struct Solid {
    shape: Shape,
    p: Vec3,
    q: Quat,
    p_before: Vec3,
}

impl Solid {
    fn at(mut self, x: f32, y: f32, z: f32) -> Self {
        self.p = Vec3::new(x, y, z);
        self.p_before = self.p;
        self
    }

    fn turned(mut self, q: Quat) -> Self {
        self.q = q;
        self
    }

    fn came_from(mut self, x: f32, y: f32, z: f32) -> Self {
        self.p_before = Vec3::new(x, y, z);
        self
    }

    fn placed(&self) -> Placed<'_> {
        Placed {
            shape: &self.shape,
            p: self.p,
            q: self.q,
            p_before: self.p_before,
        }
    }
}

fn solid(shape: Shape) -> Solid {
    Solid {
        shape,
        p: Vec3::ZERO,
        q: Quat::IDENTITY,
        p_before: Vec3::ZERO,
    }
}

fn ball(radius: f32) -> Solid {
    solid(Shape::Sphere { radius })
}

fn block(x: f32, y: f32, z: f32) -> Solid {
    let half_extents = Vec3::new(x, y, z);
    solid(Shape::Box { half_extents })
}

fn capsule(radius: f32, half_height: f32) -> Solid {
    solid(Shape::Capsule {
        radius,
        half_height,
    })
}

fn cylinder(radius: f32, half_height: f32) -> Solid {
    solid(Shape::Cylinder {
        radius,
        half_height,
    })
}

/// A floor of 40 m whose upper face is y = 0.
fn floor() -> Solid {
    block(20.0, 0.5, 20.0).at(0.0, -0.5, 0.0)
}

/// Lying along x.
fn lying() -> Quat {
    Quat::from_rotation_z(QUARTER)
}

/// The touch of a and b, after looking at what every touch must be, and that b and a touch alike.
#[track_caller]
fn met(a: &Solid, b: &Solid, margin: f32) -> Option<Touch> {
    let found = touch(&a.placed(), &b.placed(), margin);
    let other = touch(&b.placed(), &a.placed(), margin);
    assert_eq!(found.is_some(), other.is_some(), "{a:?} {b:?}");
    let (found, other) = (found?, other?);
    assert!((found.depth() - other.depth()).abs() < 1e-4, "{a:?} {b:?}");
    for touch in [&found, &other] {
        assert!(!touch.spots().is_empty());
        assert!((touch.normal.length() - 1.0).abs() < 1e-5, "{touch:?}");
        let mut features: Vec<u32> = touch.spots().iter().map(|spot| spot.feature).collect();
        features.sort_unstable();
        features.dedup();
        assert_eq!(features.len(), touch.spots().len(), "{touch:?}");
        for spot in touch.spots() {
            assert!(
                spot.point.is_finite() && spot.depth.is_finite(),
                "{touch:?}"
            );
            assert!(spot.depth >= -margin - 1e-5, "{touch:?}");
        }
    }
    Some(found)
}

/// [`met`], for solids that must touch with this depth.
#[track_caller]
fn meets(a: &Solid, b: &Solid, depth: f32, tolerance: f32) -> Touch {
    let touch = met(a, b, 0.02).expect("they touch");
    assert!(
        (touch.depth() - depth).abs() <= tolerance,
        "{} is not {depth}: {touch:?}",
        touch.depth()
    );
    touch
}

#[track_caller]
fn points_along(touch: &Touch, normal: Vec3) {
    assert!((touch.normal - normal).length() < 1e-4, "{touch:?}");
}

/// Sine and cosine.
fn sin_cos(angle: f32) -> (f32, f32) {
    angle.sin_cos()
}
