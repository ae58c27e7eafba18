//! Symmetric 3 × 3 matrices: six numbers instead of nine.

use glam::Vec3;

/// A symmetric 3 × 3 matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Symmetric {
    /// xx, yy, zz.
    pub diagonal: Vec3,
    /// yz, zx, xy.
    pub off: Vec3,
}

impl Symmetric {
    /// The same number thrice on the diagonal.
    #[must_use]
    pub fn splat(number: f32) -> Self {
        Self {
            diagonal: Vec3::splat(number),
            off: Vec3::ZERO,
        }
    }

    /// u uᵀ.
    #[must_use]
    pub fn outer(u: Vec3) -> Self {
        Self {
            diagonal: u * u,
            off: Vec3::new(u.y * u.z, u.z * u.x, u.x * u.y),
        }
    }

    /// u vᵀ + v uᵀ.
    #[must_use]
    pub fn outer_pair(u: Vec3, v: Vec3) -> Self {
        Self {
            diagonal: 2.0 * u * v,
            off: Vec3::new(
                u.y * v.z + u.z * v.y,
                u.z * v.x + u.x * v.z,
                u.x * v.y + u.y * v.x,
            ),
        }
    }

    /// The sum of both.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            diagonal: self.diagonal + other.diagonal,
            off: self.off + other.off,
        }
    }

    /// All six times a number.
    #[must_use]
    pub fn scaled(self, number: f32) -> Self {
        Self {
            diagonal: self.diagonal * number,
            off: self.off * number,
        }
    }

    /// S v.
    #[must_use]
    pub fn times(self, v: Vec3) -> Vec3 {
        self.diagonal * v
            + Vec3::new(self.off.z, self.off.z, self.off.y) * Vec3::new(v.y, v.x, v.x)
            + Vec3::new(self.off.y, self.off.x, self.off.x) * Vec3::new(v.z, v.z, v.y)
    }

    /// Its columns, which are its rows too.
    #[must_use]
    pub fn columns(self) -> [Vec3; 3] {
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
    #[must_use]
    pub fn inverse(self, least: f32) -> Self {
        let Self { diagonal, off } = self;
        let d1 = 1.0 / diagonal.x.max(least);
        let l21 = off.z * d1;
        let l31 = off.y * d1;
        let d2 = 1.0 / (diagonal.y - off.z * l21).max(least);
        let below = off.x - off.y * l21;
        let l32 = below * d2;
        let d3 = 1.0 / (diagonal.z - off.y * l31 - below * l32).max(least);
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

    fn some() -> Symmetric {
        Symmetric {
            diagonal: Vec3::new(4.0, 3.0, 2.0),
            off: Vec3::new(0.5, -0.25, 1.0),
        }
    }

    #[test]
    fn the_inverse_times_the_matrix_is_one() {
        let inverse = some().inverse(1e-3);
        for unit in Vec3::AXES {
            let back = inverse.times(some().times(unit));
            assert!((back - unit).length() < 1e-6, "{back}");
        }
    }

    #[test]
    fn the_columns_are_what_the_unit_vectors_become() {
        for (unit, column) in Vec3::AXES.into_iter().zip(some().columns()) {
            assert_eq!(some().times(unit), column);
        }
    }

    #[test]
    fn outer_products_are_those_of_full_matrices() {
        let (u, v, w) = (
            Vec3::new(1.0, 2.0, 3.0),
            Vec3::new(-1.0, 0.5, 2.0),
            Vec3::new(0.3, -2.0, 1.0),
        );
        let one = Symmetric::outer(u).times(w);
        assert!((one - u * u.dot(w)).length() < 1e-5, "{one}");
        let two = Symmetric::outer_pair(u, v).times(w);
        assert!((two - u * v.dot(w) - v * u.dot(w)).length() < 1e-5, "{two}");
    }

    #[test]
    fn a_matrix_that_rounding_left_indefinite_has_an_inverse_all_the_same() {
        // Two equal rows: its least eigenvalue was 1e-6 and is lost.
        let spoiled = Symmetric {
            diagonal: Vec3::new(10.0, 10.0, 1.0),
            off: Vec3::new(0.0, 0.0, 10.000_001),
        };
        let inverse = spoiled.inverse(1e-6);
        assert!(inverse.diagonal.min_element() > 0.0, "{inverse:?}");
    }
}
