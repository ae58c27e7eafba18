//! What a pair presses and rubs, and what becomes of it there: rows as lanes.

use glam::Vec4;

use crate::rows::{Impulse, Material};
use crate::simd::{Mask, Real, Vec3, array_of};

/// The material of a pair, a pair a lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Surface<R> {
    /// Coefficient of restitution.
    pub restitution: R,
    /// Kinetic coefficient of friction.
    pub friction: R,
    /// Static coefficient of friction.
    pub static_friction: R,
}

impl<R: Real> Surface<R> {
    /// What `material` gives for each lane.
    #[inline(always)]
    pub fn of<'m>(material: impl Fn(usize) -> &'m Material) -> Self {
        let [restitution, friction, static_friction, _] =
            R::of_rows(|lane| bytemuck::cast(*material(lane)));
        Self {
            restitution,
            friction,
            static_friction,
        }
    }
}

/// What the points of a pair have pressed and rubbed by now, as b receives it; a pair a lane.
#[derive(Clone, Copy, Debug)]
pub struct Impulses<R, const P: usize> {
    /// Normal impulse of each point, N s.
    pub normal: [R; P],
    /// Friction at the mean of the points, in the world, N s.
    pub friction: Vec3<R>,
    /// Friction against turning about the normal, N m s.
    pub twist: R,
}

impl<R: Real, const P: usize> Default for Impulses<R, P> {
    fn default() -> Self {
        Self {
            normal: [R::default(); P],
            friction: Vec3::zero(),
            twist: R::default(),
        }
    }
}

impl<R: Real, const P: usize> Impulses<R, P> {
    /// What `impulse` gives for each lane.
    #[inline(always)]
    pub fn of<'i>(impulse: impl Fn(usize) -> &'i Impulse) -> Self {
        let row = |k: usize| {
            R::of_rows(|lane| {
                let rows: &[[f32; 4]; 2] = bytemuck::cast_ref(impulse(lane));
                rows[k]
            })
        };
        let normal = row(0);
        let [x, y, z, twist] = row(1);
        Self {
            normal: array_of(|k| normal[k]),
            friction: Vec3::new(x, y, z),
            twist,
        }
    }

    /// That of a lane.
    #[inline(always)]
    #[must_use]
    pub fn lane(&self, lane: usize) -> Impulse {
        let mut normal = Vec4::ZERO;
        for (k, number) in self.normal.iter().enumerate() {
            normal[k] = number.lane(lane);
        }
        Impulse {
            normal,
            friction: self.friction.lane(lane),
            twist: self.twist.lane(lane),
        }
    }

    /// All of it where yes, nothing where no.
    #[inline(always)]
    pub(super) fn kept(self, mask: R::Mask) -> Self {
        Self {
            normal: array_of(|k| R::select(mask, self.normal[k], R::splat(0.0))),
            friction: Vec3::select(mask, self.friction, Vec3::zero()),
            twist: R::select(mask, self.twist, R::splat(0.0)),
        }
    }

    /// Whether any point presses.
    #[inline(always)]
    pub(super) fn presses(&self) -> R::Mask {
        let zero = R::splat(0.0);
        let is_any = |any: R::Mask, n: &R| any | n.gt(zero);
        self.normal.iter().fold(R::Mask::splat(false), is_any)
    }

    /// Adds to the normal impulses.
    #[inline(always)]
    pub(super) fn add(&mut self, changes: &[R; P]) {
        for (normal, change) in self.normal.iter_mut().zip(changes) {
            *normal += *change;
        }
    }

    /// The sum over the points.
    #[inline(always)]
    pub(super) fn pressed(&self) -> R {
        self.normal.iter().fold(R::splat(0.0), |sum, n| sum + *n)
    }
}
