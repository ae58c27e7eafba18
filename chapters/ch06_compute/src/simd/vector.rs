//! Vectors of three numbers.

use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use super::Real;

/// A vector in each lane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3<R> {
    /// Along x.
    pub x: R,
    /// Along y.
    pub y: R,
    /// Along z.
    pub z: R,
}

impl<R: Real> Vec3<R> {
    /// Of three numbers.
    #[inline(always)]
    pub fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }

    /// The same number thrice.
    #[inline(always)]
    #[must_use]
    pub fn splat(number: R) -> Self {
        Self::new(number, number, number)
    }

    /// Nothing.
    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        Self::splat(R::splat(0.0))
    }

    /// The same vector in each lane.
    #[inline(always)]
    #[must_use]
    pub fn all(vector: glam::Vec3) -> Self {
        Self::new(R::splat(vector.x), R::splat(vector.y), R::splat(vector.z))
    }

    /// What `vector` gives for each lane.
    #[inline(always)]
    pub fn of(mut vector: impl FnMut(usize) -> glam::Vec3) -> Self {
        Self::new(
            R::of(|lane| vector(lane).x),
            R::of(|lane| vector(lane).y),
            R::of(|lane| vector(lane).z),
        )
    }

    /// The vector in a lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> glam::Vec3 {
        glam::Vec3::new(self.x.lane(lane), self.y.lane(lane), self.z.lane(lane))
    }

    /// u·v.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> R {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// u × v.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// |v|².
    #[inline(always)]
    #[must_use]
    pub fn length_squared(self) -> R {
        self.dot(self)
    }

    /// |v|.
    #[inline(always)]
    #[must_use]
    pub fn length(self) -> R {
        self.length_squared().sqrt()
    }

    /// 1/x of each.
    #[inline(always)]
    #[must_use]
    pub fn recip(self) -> Self {
        Self::new(self.x.recip(), self.y.recip(), self.z.recip())
    }

    /// One where yes, the other where no.
    #[inline(always)]
    #[must_use]
    pub fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self::new(
            R::select(mask, yes.x, no.x),
            R::select(mask, yes.y, no.y),
            R::select(mask, yes.z, no.z),
        )
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, number: R) -> Self {
        Self::new(self.x * number, self.y * number, self.z * number)
    }
}

/// Number by number.
impl<R: Real> Mul for Vec3<R> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(self.x * other.x, self.y * other.y, self.z * other.z)
    }
}

impl<R: Real> AddAssign for Vec3<R> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> SubAssign for Vec3<R> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl From<glam::Vec3> for Vec3<f32> {
    #[inline(always)]
    fn from(v: glam::Vec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}
