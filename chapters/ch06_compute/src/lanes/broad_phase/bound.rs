//! Boxes about bodies, as the broad phase compares them: two registers of four lanes.

use ch03_collision::aabb::Aabb;
use ch05_properties::data::shape_of;
use glam::Vec3;
use wide::f32x4;

use crate::bodies::Bodies;
use crate::norm::Norm;
use crate::rules::MARGIN;

/// How many boxes of a crowd are looked at.
const SAMPLE: usize = 1024;

/// Room in a box for what its body may do beyond the step, in reaches of the body.
const ROOM: f32 = 0.1;

/// A box has room for its body's velocity until a body of usual speed has come this far, in reaches …
const FARTHER: f32 = 0.2;

/// … but for no more steps than these.
const MOST_STEPS: f32 = 4.0;

// ANCHOR: bound
/// A box along the world's axes, m: x, y, z and a lane that is always the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    low: f32x4,
    high: f32x4,
}

impl Bound {
    /// Holds nothing and overlaps nothing.
    pub const EMPTY: Self = Self {
        low: f32x4::new([f32::INFINITY; 4]),
        high: f32x4::new([f32::NEG_INFINITY; 4]),
    };

    /// Whether two share a point; touching counts.
    #[inline]
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        (self.low.simd_le(other.high) & other.low.simd_le(self.high)).to_bitmask() == 0b1111
    }
    // ANCHOR_END: bound

    /// Whether all of `other` is inside.
    #[inline]
    #[must_use]
    pub fn holds(&self, other: &Self) -> bool {
        (self.low.simd_le(other.low) & other.high.simd_le(self.high)).to_bitmask() == 0b1111
    }

    /// From its corners, m; [`Self::EMPTY`] if one isn't finite.
    #[must_use]
    pub fn new(low: Vec3, high: Vec3) -> Self {
        if !(low.is_finite() && high.is_finite()) {
            return Self::EMPTY;
        }
        Self {
            low: f32x4::new([low.x, low.y, low.z, 0.0]),
            high: f32x4::new([high.x, high.y, high.z, 0.0]),
        }
    }

    /// Its smallest coordinates, m.
    #[must_use]
    pub fn low(&self) -> [f32; 3] {
        let [x, y, z, _] = self.low.to_array();
        [x, y, z]
    }

    /// Its largest coordinates, m.
    #[must_use]
    pub fn high(&self) -> [f32; 3] {
        let [x, y, z, _] = self.high.to_array();
        [x, y, z]
    }

    /// The smallest box about both.
    #[inline]
    #[must_use]
    pub fn joined(self, other: &Self) -> Self {
        Self {
            low: self.low.fast_min(other.low),
            high: self.high.fast_max(other.high),
        }
    }

    /// Twice its centre, m.
    #[must_use]
    pub fn twice_the_centre(&self) -> [f32; 3] {
        let [x, y, z, _] = (self.low + self.high).to_array();
        [x, y, z]
    }

    /// The sum of its edges, m.
    #[must_use]
    pub fn edges(&self) -> f32 {
        let [x, y, z, _] = (self.high - self.low).to_array();
        x + y + z
    }

    /// Its longest edge, m; negative if it holds nothing.
    #[must_use]
    pub fn extent(&self) -> f32 {
        let [x, y, z, _] = (self.high - self.low).to_array();
        x.max(y).max(z)
    }
}

/// The longest edges of some boxes of a crowd, m.
#[must_use]
pub fn some_extents(bounds: &[Bound]) -> Vec<f32> {
    let step = bounds.len().div_ceil(SAMPLE).max(1);
    let extents = bounds.iter().step_by(step).map(Bound::extent);
    extents.filter(|&extent| extent > 0.0).collect()
}

/// How far the surface of a body comes by turning, at most, m/s.
fn rim_speed(bodies: &Bodies, row: usize) -> f32 {
    if bodies.solid[row].kind == 0 {
        return 0.0;
    }
    bodies.spin[row].angular_velocity.norm() * bodies.place[row].reach
}

/// How far a body looks beyond itself, m: half the margin, and what it may move.
#[must_use]
pub fn ahead(bodies: &Bodies, row: usize, dt: f32) -> f32 {
    if bodies.is_static(row) {
        return 0.5 * MARGIN;
    }
    0.5 * MARGIN + (bodies.motion[row].velocity.norm() + rim_speed(bodies, row)) * dt
}

/// Where a body may be in the step, m.
#[must_use]
pub fn about(bodies: &Bodies, row: usize, dt: f32) -> Bound {
    let (solid, p) = (&bodies.solid[row], bodies.place[row].position);
    let ahead = ahead(bodies, row, dt);
    if solid.kind == 0 {
        let radius = solid.size.x;
        return Bound::new(p - radius - ahead, p + radius + ahead);
    }
    let shape = shape_of(solid.kind, solid.size);
    let aabb = Aabb::of_shape(&shape, p, bodies.attitude[row]).grown(ahead);
    Bound::new(aabb.min, aabb.max)
}

/// How far a body comes in a second at most, in its reaches.
#[must_use]
pub fn speed_in_reaches(bodies: &Bodies, row: usize) -> f32 {
    let reach = bodies.place[row].reach;
    if bodies.is_static(row) || reach <= 0.0 {
        return 0.0;
    }
    (bodies.motion[row].velocity.norm() + rim_speed(bodies, row)) / reach
}

// ANCHOR: roomy
/// For how long boxes get room, s: less than a step if most bodies are too fast for it to be worth it.
#[must_use]
pub fn time_of_room(mean_speed: f32, dt: f32) -> f32 {
    let time = FARTHER / mean_speed;
    if time < dt {
        0.0
    } else {
        time.min(MOST_STEPS * dt)
    }
}

/// A box with room for what its body may do in `time` seconds more. What can't move needs none.
#[must_use]
pub fn roomy(bodies: &Bodies, row: usize, bound: &Bound, time: f32) -> Bound {
    if time == 0.0 || bodies.is_static(row) || *bound == Bound::EMPTY {
        return *bound;
    }
    let room = Vec3::splat(ROOM * bodies.place[row].reach + time * rim_speed(bodies, row));
    let way = time * bodies.motion[row].velocity;
    let low = Vec3::from(bound.low()) - room + way.min(Vec3::ZERO);
    let high = Vec3::from(bound.high()) + room + way.max(Vec3::ZERO);
    Bound::new(low, high)
}
// ANCHOR_END: roomy
