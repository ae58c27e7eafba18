//! How a body answers to impulses when others hang on it: its articulated inertia. [Featherstone 1983]
//!
//! A velocity is a pair (v, ω) at some point, an impulse a pair (P, T) about it, and the inertia the
//! symmetric 6 × 6 matrix with P = A v + Cᵀ ω, T = C v + D ω, in three blocks of 3 × 3.

use crate::simd::{Mat3, Quat, Real, Symmetric, Vec3};

// ANCHOR: rate
/// How a body moves, or by how much a solve changes that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rate<R> {
    /// Velocity of the point that it is taken at, m/s.
    pub velocity: Vec3<R>,
    /// Angular velocity, rad/s.
    pub spin: Vec3<R>,
}

/// What moves a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench<R> {
    /// Impulse, N s.
    pub impulse: Vec3<R>,
    /// Turning impulse about the point that it is taken at, N m s.
    pub turning: Vec3<R>,
}

impl<R: Real> Rate<R> {
    /// The same motion, taken at the point that is `arm` away.
    #[inline(always)]
    #[must_use]
    pub fn at(self, arm: Vec3<R>) -> Self {
        Self {
            velocity: self.velocity + self.spin.cross(arm),
            spin: self.spin,
        }
    }

    /// The sum of both.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            velocity: self.velocity + other.velocity,
            spin: self.spin + other.spin,
        }
    }
}

impl<R: Real> Wrench<R> {
    /// The same impulse, taken about the point that is `arm` away.
    #[inline(always)]
    #[must_use]
    pub fn at(self, arm: Vec3<R>) -> Self {
        Self {
            impulse: self.impulse,
            turning: self.turning - arm.cross(self.impulse),
        }
    }

    /// The sum of both.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            impulse: self.impulse + other.impulse,
            turning: self.turning + other.turning,
        }
    }

    /// What is left without the other.
    #[inline(always)]
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self {
            impulse: self.impulse - other.impulse,
            turning: self.turning - other.turning,
        }
    }
}
// ANCHOR_END: rate

// ANCHOR: articulated
/// A body's inertia with that of all that hangs on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Articulated<R> {
    /// A: the impulse that goes with a velocity, kg.
    pub mass: Symmetric<R>,
    /// C: the angular impulse that goes with a velocity, kg m; a column an axis.
    pub coupling: Mat3<R>,
    /// D: the angular impulse that goes with an angular velocity, kg m².
    pub inertia: Symmetric<R>,
}
// ANCHOR_END: articulated

impl<R: Real> Articulated<R> {
    /// That of a body alone, of this mass, kg, and these principal moments, kg m², at its centre of mass.
    #[inline(always)]
    #[must_use]
    pub fn of_body(mass: R, moments: Vec3<R>, attitude: Quat<R>) -> Self {
        Self {
            mass: Symmetric::splat(mass),
            coupling: Mat3::default(),
            inertia: Symmetric::turned(attitude.matrix(), moments),
        }
    }

    /// The sum of both, which are taken at the same point.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            mass: self.mass.plus(other.mass),
            coupling: self.coupling + other.coupling,
            inertia: self.inertia.plus(other.inertia),
        }
    }

    // ANCHOR: at
    /// The same inertia, taken at the point that is r away, where the velocity is v' = v + ω × r.
    ///
    /// With v = v' + [r] ω: A' = A, C' = C − [r] A, D' = D + (C [r])ᵀ + C' [r].
    #[inline(always)]
    #[must_use]
    pub fn at(self, r: Vec3<R>) -> Self {
        let [x, y, z] = self.mass.columns();
        let moved = Mat3::from_cols(x.cross(r), y.cross(r), z.cross(r));
        let coupling = self.coupling + moved;
        let turned = times_crossing(self.coupling, r);
        let inertia = self
            .inertia
            .plus(symmetric_part(turned, times_crossing(coupling, r)));
        Self {
            mass: self.mass,
            coupling,
            inertia,
        }
    }
    // ANCHOR_END: at

    // ANCHOR: felt_at
    /// What is felt at the point that is s away from where only `mass` is felt: [`Self::at`] for −s,
    /// with C = D = 0.
    #[inline(always)]
    #[must_use]
    pub fn felt_at(mass: Symmetric<R>, s: Vec3<R>) -> Self {
        let [x, y, z] = mass.columns();
        let coupling = Mat3::from_cols(s.cross(x), s.cross(y), s.cross(z));
        Self {
            mass,
            coupling,
            inertia: symmetric_part(Mat3::default(), times_crossing(coupling, -s)),
        }
    }
    // ANCHOR_END: felt_at

    /// The impulses that go with a motion.
    #[inline(always)]
    #[must_use]
    pub fn times(self, rate: Rate<R>) -> Wrench<R> {
        Wrench {
            impulse: self.mass.times(rate.velocity) + self.coupling.transposed_times(rate.spin),
            turning: self.coupling * rate.velocity + self.inertia.times(rate.spin),
        }
    }
}

/// M [r], with [r] the matrix of r × .
#[inline(always)]
fn times_crossing<R: Real>(m: Mat3<R>, r: Vec3<R>) -> Mat3<R> {
    Mat3::from_cols(
        m.y * r.z - m.z * r.y,
        m.z * r.x - m.x * r.z,
        m.x * r.y - m.y * r.x,
    )
}

/// Mᵀ + N, which is symmetric.
#[inline(always)]
fn symmetric_part<R: Real>(m: Mat3<R>, n: Mat3<R>) -> Symmetric<R> {
    Symmetric {
        diagonal: Vec3::new(m.x.x + n.x.x, m.y.y + n.y.y, m.z.z + n.z.z),
        off: Vec3::new(m.y.z + n.z.y, m.z.x + n.x.z, m.x.y + n.y.x),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(x: f32, y: f32, z: f32) -> Vec3<f32> {
        Vec3::new(x, y, z)
    }

    fn body() -> Articulated<f32> {
        let attitude = glam::Quat::from_xyzw(0.5, -0.5, 0.1, 0.7).normalize();
        let moments = vector(0.5, 0.2, 1.0 / 9.0);
        let at_centre = Articulated::of_body(2.0, moments, attitude.into());
        // No body is like this; but one with others that hang on it may be.
        Articulated {
            mass: Symmetric {
                off: vector(0.1, -0.2, 0.3),
                ..at_centre.mass
            },
            coupling: Mat3::from_cols(
                vector(0.1, 0.2, -0.1),
                vector(0.0, 0.3, 0.1),
                vector(-0.2, 0.1, 0.05),
            ),
            ..at_centre
        }
    }

    #[test]
    fn an_inertia_taken_elsewhere_gives_the_same_motion_the_same_impulse() {
        let arm = vector(0.3, -0.7, 0.2);
        let rate = Rate {
            velocity: vector(1.0, -2.0, 0.5),
            spin: vector(0.4, 0.3, -1.0),
        };
        let here = body().times(rate).at(arm);
        let there = body().at(arm).times(rate.at(arm));
        assert!(
            (here.impulse - there.impulse).length() < 1e-5,
            "{here:?} {there:?}"
        );
        assert!(
            (here.turning - there.turning).length() < 1e-5,
            "{here:?} {there:?}"
        );
    }

    #[test]
    fn a_mass_felt_at_a_point_is_an_inertia_without_moments_taken_elsewhere() {
        let arm = vector(0.3, -0.7, 0.2);
        let mass = body().mass;
        let there = Articulated {
            mass,
            ..Articulated::default()
        };
        let (one, other) = (Articulated::felt_at(mass, arm), there.at(-arm));
        assert_eq!(one.coupling, other.coupling);
        assert!((one.inertia.diagonal - other.inertia.diagonal).length() < 1e-6);
        assert!((one.inertia.off - other.inertia.off).length() < 1e-6);
    }
}
