//! How a body answers to impulses when others hang on it: its articulated inertia. [Featherstone 1983]
//!
//! A velocity is a pair (v, ω) at some point, an impulse a pair (P, T) about it, and the inertia the
//! symmetric 6 × 6 matrix with P = A v + Cᵀ ω, T = C v + D ω, in three blocks of 3 × 3.

use glam::{Mat3, Quat, Vec3};

use super::Symmetric;

// ANCHOR: rate
/// How a body moves, or by how much a solve changes that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rate {
    /// Velocity of the point that it is taken at, m/s.
    pub velocity: Vec3,
    /// Angular velocity, rad/s.
    pub spin: Vec3,
}

/// What moves a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Impulse, N s.
    pub impulse: Vec3,
    /// Turning impulse about the point that it is taken at, N m s.
    pub turning: Vec3,
}

impl Rate {
    /// The same motion, taken at the point that is `arm` away.
    #[must_use]
    pub fn at(self, arm: Vec3) -> Self {
        Self {
            velocity: self.velocity + self.spin.cross(arm),
            spin: self.spin,
        }
    }
}

impl Wrench {
    /// The same impulse, taken about the point that is `arm` away.
    #[must_use]
    pub fn at(self, arm: Vec3) -> Self {
        Self {
            impulse: self.impulse,
            turning: self.turning - arm.cross(self.impulse),
        }
    }

    /// The sum of both.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            impulse: self.impulse + other.impulse,
            turning: self.turning + other.turning,
        }
    }

    /// What is left without the other.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Articulated {
    /// A: the impulse that goes with a velocity, kg.
    pub mass: Symmetric,
    /// C: the turning impulse that goes with a velocity, kg m; a column an axis.
    pub coupling: Mat3,
    /// D: the turning impulse that goes with an angular velocity, kg m².
    pub inertia: Symmetric,
}
// ANCHOR_END: articulated

impl Default for Articulated {
    /// None: glam's default matrix is one.
    fn default() -> Self {
        Self {
            mass: Symmetric::default(),
            coupling: Mat3::ZERO,
            inertia: Symmetric::default(),
        }
    }
}

impl Articulated {
    /// That of a body alone, at its centre of mass.
    #[must_use]
    pub fn of_body(inverse_mass: f32, inverse_inertia: Vec3, attitude: Quat) -> Self {
        Self {
            mass: Symmetric::splat(1.0 / inverse_mass),
            coupling: Mat3::ZERO,
            inertia: world_moments(attitude, inverse_inertia.recip()),
        }
    }

    /// The sum of both, which are taken at the same point.
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
    #[must_use]
    pub fn at(self, r: Vec3) -> Self {
        let [x, y, z] = self.mass.columns().map(|column| column.cross(r));
        let coupling = self.coupling + Mat3::from_cols(x, y, z);
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
    #[must_use]
    pub fn felt_at(mass: Symmetric, s: Vec3) -> Self {
        let [x, y, z] = mass.columns().map(|column| s.cross(column));
        let coupling = Mat3::from_cols(x, y, z);
        Self {
            mass,
            coupling,
            inertia: symmetric_part(Mat3::ZERO, times_crossing(coupling, -s)),
        }
    }
    // ANCHOR_END: felt_at

    /// The impulses that go with a motion.
    #[must_use]
    pub fn times(self, rate: Rate) -> Wrench {
        Wrench {
            impulse: self.mass.times(rate.velocity) + transposed_times(self.coupling, rate.spin),
            turning: self.coupling * rate.velocity + self.inertia.times(rate.spin),
        }
    }
}

/// R diag(I) Rᵀ: principal moments in world axes.
#[must_use]
pub fn world_moments(attitude: Quat, moments: Vec3) -> Symmetric {
    let axes = Mat3::from_quat(attitude);
    let along = |axis: Vec3, moment: f32| Symmetric::outer(axis).scaled(moment);
    along(axes.x_axis, moments.x)
        .plus(along(axes.y_axis, moments.y))
        .plus(along(axes.z_axis, moments.z))
}

/// Mᵀ v: what v is along the columns.
#[must_use]
pub fn transposed_times(m: Mat3, v: Vec3) -> Vec3 {
    Vec3::new(m.x_axis.dot(v), m.y_axis.dot(v), m.z_axis.dot(v))
}

/// M [r], with [r] the matrix of r × .
fn times_crossing(m: Mat3, r: Vec3) -> Mat3 {
    Mat3::from_cols(
        r.z * m.y_axis - r.y * m.z_axis,
        r.x * m.z_axis - r.z * m.x_axis,
        r.y * m.x_axis - r.x * m.y_axis,
    )
}

/// Mᵀ + N, which is symmetric.
fn symmetric_part(m: Mat3, n: Mat3) -> Symmetric {
    Symmetric {
        diagonal: Vec3::new(
            m.x_axis.x + n.x_axis.x,
            m.y_axis.y + n.y_axis.y,
            m.z_axis.z + n.z_axis.z,
        ),
        off: Vec3::new(
            m.y_axis.z + n.z_axis.y,
            m.z_axis.x + n.x_axis.z,
            m.x_axis.y + n.y_axis.x,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body() -> Articulated {
        let attitude = Quat::from_xyzw(0.5, -0.5, 0.1, 0.7).normalize();
        let at_centre = Articulated::of_body(0.5, Vec3::new(2.0, 5.0, 9.0), attitude);
        // No body is like this; but one with others that hang on it may be.
        Articulated {
            mass: Symmetric {
                off: Vec3::new(0.1, -0.2, 0.3),
                ..at_centre.mass
            },
            coupling: Mat3::from_cols_array(&[0.1, 0.2, -0.1, 0.0, 0.3, 0.1, -0.2, 0.1, 0.05]),
            ..at_centre
        }
    }

    #[test]
    fn an_inertia_taken_elsewhere_gives_the_same_motion_the_same_impulse() {
        let arm = Vec3::new(0.3, -0.7, 0.2);
        let rate = Rate {
            velocity: Vec3::new(1.0, -2.0, 0.5),
            spin: Vec3::new(0.4, 0.3, -1.0),
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
        let arm = Vec3::new(0.3, -0.7, 0.2);
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
