//! Matrices of three by three numbers, and symmetric ones, which need six.

use std::ops::{Add, Mul};

use super::{Real, Vec3};

/// A matrix in each lane, by columns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mat3<R> {
    /// First column.
    pub x: Vec3<R>,
    /// Second column.
    pub y: Vec3<R>,
    /// Third column.
    pub z: Vec3<R>,
}

impl<R: Real> Mat3<R> {
    /// Of three columns.
    #[inline(always)]
    pub fn from_cols(x: Vec3<R>, y: Vec3<R>, z: Vec3<R>) -> Self {
        Self { x, y, z }
    }

    /// One where yes, the other where no.
    #[inline(always)]
    #[must_use]
    pub fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self {
            x: Vec3::select(mask, yes.x, no.x),
            y: Vec3::select(mask, yes.y, no.y),
            z: Vec3::select(mask, yes.z, no.z),
        }
    }

    /// Mᵀ v: what v is along the columns.
    #[inline(always)]
    #[must_use]
    pub fn transposed_times(self, v: Vec3<R>) -> Vec3<R> {
        Vec3::new(self.x.dot(v), self.y.dot(v), self.z.dot(v))
    }
}

impl<R: Real> Add for Mat3<R> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::from_cols(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Mul<Vec3<R>> for Mat3<R> {
    type Output = Vec3<R>;

    #[inline(always)]
    fn mul(self, v: Vec3<R>) -> Vec3<R> {
        self.x * v.x + self.y * v.y + self.z * v.z
    }
}

// ANCHOR: inertia
/// How a body answers to angular impulses: a matrix in general, a number for a ball.
pub trait Inertia<R: Real>: Copy {
    /// Whether all that presses goes through its centre, as it does on a ball: then it turns nothing.
    const CENTRAL: bool = false;

    /// Whether the pair has friction: where it has none, nothing of it is computed.
    const RUBS: bool = true;

    /// I⁻¹ T: what an angular impulse makes of the spin.
    fn answer(self, turning: Vec3<R>) -> Vec3<R>;
}

impl<R: Real> Inertia<R> for Symmetric<R> {
    #[inline(always)]
    fn answer(self, turning: Vec3<R>) -> Vec3<R> {
        self.times(turning)
    }
}

/// That of a ball: the same about each axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Round<R>(pub R);

impl<R: Real> Inertia<R> for Round<R> {
    const CENTRAL: bool = true;

    #[inline(always)]
    fn answer(self, turning: Vec3<R>) -> Vec3<R> {
        turning * self.0
    }
}
// ANCHOR_END: inertia

/// A symmetric matrix in each lane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Symmetric<R> {
    /// xx, yy, zz.
    pub diagonal: Vec3<R>,
    /// yz, zx, xy.
    pub off: Vec3<R>,
}

impl<R: Real> Symmetric<R> {
    /// The same number thrice on the diagonal.
    #[inline(always)]
    #[must_use]
    pub fn splat(number: R) -> Self {
        Self {
            diagonal: Vec3::splat(number),
            off: Vec3::zero(),
        }
    }

    /// u uᵀ.
    #[inline(always)]
    #[must_use]
    pub fn outer(u: Vec3<R>) -> Self {
        Self {
            diagonal: u * u,
            off: Vec3::new(u.y * u.z, u.z * u.x, u.x * u.y),
        }
    }

    /// u vᵀ + v uᵀ.
    #[inline(always)]
    #[must_use]
    pub fn outer_pair(u: Vec3<R>, v: Vec3<R>) -> Self {
        Self {
            diagonal: u * v * R::splat(2.0),
            off: Vec3::new(
                u.y * v.z + u.z * v.y,
                u.z * v.x + u.x * v.z,
                u.x * v.y + u.y * v.x,
            ),
        }
    }

    /// R diag(d) Rᵀ, where R's columns are `axes`: principal moments in world axes.
    #[inline(always)]
    #[must_use]
    pub fn turned(axes: Mat3<R>, moments: Vec3<R>) -> Self {
        Self::outer(axes.x)
            .scaled(moments.x)
            .plus(Self::outer(axes.y).scaled(moments.y))
            .plus(Self::outer(axes.z).scaled(moments.z))
    }

    /// The sum of both.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            diagonal: self.diagonal + other.diagonal,
            off: self.off + other.off,
        }
    }

    /// All six times a number.
    #[inline(always)]
    #[must_use]
    pub fn scaled(self, number: R) -> Self {
        Self {
            diagonal: self.diagonal * number,
            off: self.off * number,
        }
    }

    /// S v.
    #[inline(always)]
    #[must_use]
    pub fn times(self, v: Vec3<R>) -> Vec3<R> {
        let Self { diagonal, off } = self;
        Vec3::new(
            diagonal.x * v.x + off.z * v.y + off.y * v.z,
            diagonal.y * v.y + off.z * v.x + off.x * v.z,
            diagonal.z * v.z + off.y * v.x + off.x * v.y,
        )
    }

    /// Its columns, which are its rows too.
    #[inline(always)]
    #[must_use]
    pub fn columns(self) -> [Vec3<R>; 3] {
        let Self { diagonal, off } = self;
        [
            Vec3::new(diagonal.x, off.z, off.y),
            Vec3::new(off.z, diagonal.y, off.x),
            Vec3::new(off.y, off.x, diagonal.z),
        ]
    }

    // ANCHOR: inverse
    /// S⁻¹ of a positive definite S, none of whose eigenvalues is below `least`: by S = L D Lᵀ.
    ///
    /// The numbers of D are Schur complements of S, and none of these is below its least eigenvalue. So
    /// `least` changes nothing but what rounding spoiled: a thin link that carries a heavy ball has
    /// moments that differ by more than f32 can hold.
    #[inline(always)]
    #[must_use]
    pub fn inverse(self, least: R) -> Self {
        let Self { diagonal, off } = self;
        let d1 = diagonal.x.max(least).recip();
        let l21 = off.z * d1;
        let l31 = off.y * d1;
        let d2 = (diagonal.y - off.z * l21).max(least).recip();
        let below = off.x - off.y * l21;
        let l32 = below * d2;
        let d3 = (diagonal.z - off.y * l31 - below * l32).max(least).recip();
        let m31 = l21 * l32 - l31;
        Self {
            diagonal: Vec3::new(
                d1 + l21 * l21 * d2 + m31 * m31 * d3,
                d2 + l32 * l32 * d3,
                d3,
            ),
            off: Vec3::new(-l32 * d3, m31 * d3, -l21 * d2 - m31 * l32 * d3),
        }
    }
    // ANCHOR_END: inverse
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(x: f32, y: f32, z: f32) -> Vec3<f32> {
        Vec3::new(x, y, z)
    }

    fn some() -> Symmetric<f32> {
        Symmetric {
            diagonal: vector(4.0, 3.0, 2.0),
            off: vector(0.5, -0.25, 1.0),
        }
    }

    fn units() -> [Vec3<f32>; 3] {
        glam::Vec3::AXES.map(Vec3::from)
    }

    #[test]
    fn the_inverse_times_the_matrix_is_one() {
        let inverse = some().inverse(1e-3);
        for unit in units() {
            let back = inverse.times(some().times(unit));
            assert!((back - unit).length() < 1e-6, "{back:?}");
        }
    }

    #[test]
    fn the_columns_are_what_the_unit_vectors_become() {
        for (unit, column) in units().into_iter().zip(some().columns()) {
            assert_eq!(some().times(unit), column);
        }
    }

    #[test]
    fn outer_products_are_those_of_full_matrices() {
        let (u, v) = (vector(1.0, 2.0, 3.0), vector(-1.0, 0.5, 2.0));
        let w = vector(0.3, -2.0, 1.0);
        let one = Symmetric::outer(u).times(w);
        assert!((one - u * u.dot(w)).length() < 1e-5, "{one:?}");
        let two = Symmetric::outer_pair(u, v).times(w);
        let exact = u * v.dot(w) + v * u.dot(w);
        assert!((two - exact).length() < 1e-5, "{two:?}");
    }

    #[test]
    fn a_matrix_that_rounding_left_indefinite_has_an_inverse_all_the_same() {
        // Two equal rows: its least eigenvalue was 1e-6 and is lost.
        let spoiled = Symmetric {
            diagonal: vector(10.0, 10.0, 1.0),
            off: vector(0.0, 0.0, 10.000_001),
        };
        let diagonal = spoiled.inverse(1e-6).diagonal.lane(0);
        assert!(diagonal.min_element() > 0.0, "{diagonal}");
    }
}
