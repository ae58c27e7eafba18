//! The collision impulse: how two bodies that touch at a point push each other. Report 8.4.
//!
//! The normal n̂ points from body 2 to body 1. The impulse C acts on body 1, −C on body 2.
//! Errata 1, 2 and 7 are about this file; friction is the section that the report left open.

use super::real::{Mat3, Quat, Real, Vec3};

// ANCHOR: mass
/// What an impulse needs to know of a body; a static body has zeros.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass<I = Mat3> {
    /// 1/m, 1/kg.
    pub inverse_mass: Real,
    /// I⁻¹ in world axes, 1/(kg m²): a matrix, or one number where all bodies are balls.
    pub inverse_inertia: I,
}

impl Mass {
    /// Of a body with these inverse principal moments whose axes are turned by q.
    ///
    /// The report calls M(q, I, a) at every use, since turning I every frame costs too much. A step
    /// uses I⁻¹ some fifty times a body, so one turn of the matrix is cheaper than a hundred of vectors.
    #[inline]
    #[must_use]
    pub fn new(inverse_mass: Real, inverse_inertia: Vec3, q: Quat) -> Self {
        let is_ball =
            inverse_inertia.x == inverse_inertia.y && inverse_inertia.y == inverse_inertia.z;
        let diagonal = Mat3::from_diagonal(inverse_inertia);
        let inverse_inertia = if is_ball {
            diagonal
        } else {
            let r = Mat3::from_quat(q);
            r * diagonal * r.transpose()
        };
        Self {
            inverse_mass,
            inverse_inertia,
        }
    }
}
// ANCHOR_END: mass

// ANCHOR: inertia
/// What turns an angular impulse into a change of angular velocity.
pub trait Inertia: Copy {
    /// I⁻¹ a.
    fn moment(self, a: Vec3) -> Vec3;
}

impl Inertia for Mat3 {
    #[inline]
    fn moment(self, a: Vec3) -> Vec3 {
        self * a
    }
}

impl Inertia for Real {
    #[inline]
    fn moment(self, a: Vec3) -> Vec3 {
        self * a
    }
}

impl<I: Inertia> Mass<I> {
    /// M(q, I, a) of this body.
    #[inline]
    #[must_use]
    pub fn moment(&self, a: Vec3) -> Vec3 {
        self.inverse_inertia.moment(a)
    }
}
// ANCHOR_END: inertia

/// Linear (m/s) and angular (rad/s, world) velocity of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// m/s.
    pub v: Vec3,
    /// rad/s.
    pub omega: Vec3,
}

// ANCHOR: point_velocity
/// v_c = v + ω × r: velocity of the body's point at r from its centre, m/s.
#[inline]
#[must_use]
pub fn point_velocity(body: Velocity, r: Vec3) -> Vec3 {
    body.v + body.omega.cross(r)
}

/// v_r = v_c1 − v_c2: velocity of body 1 relative to body 2 at the contact, m/s.
#[inline]
#[must_use]
pub fn relative_velocity(body_1: Velocity, r1: Vec3, body_2: Velocity, r2: Vec3) -> Vec3 {
    point_velocity(body_1, r1) - point_velocity(body_2, r2)
}
// ANCHOR_END: point_velocity

// ANCHOR: response
/// m₁⁻¹ + m₂⁻¹ + û·(M₁(r₁×û)×r₁) + û·(M₂(r₂×û)×r₂): how much the relative velocity along û
/// changes by a unit impulse along û, 1/kg. The denominator of J.
#[inline]
#[must_use]
pub fn response<I: Inertia>(
    mass_1: &Mass<I>,
    r1: Vec3,
    mass_2: &Mass<I>,
    r2: Vec3,
    u: Vec3,
) -> Real {
    mass_1.inverse_mass
        + mass_2.inverse_mass
        + u.dot(mass_1.moment(r1.cross(u)).cross(r1))
        + u.dot(mass_2.moment(r2.cross(u)).cross(r2))
}
// ANCHOR_END: response

// ANCHOR: magnitude
/// J = −(1 + e) v_r·n̂ / response, N s: the impulse after which the bodies part with e times
/// the speed of their approach.
#[inline]
#[must_use]
pub fn magnitude(approach: Real, restitution: Real, response: Real) -> Real {
    -approach * (1.0 + restitution) / response
}
// ANCHOR_END: magnitude

// ANCHOR: apply
/// The velocity of a body after the impulse C at r: v + C/m, ω + M(r × C). For body 2 hand over −C.
///
/// Each body gets the whole impulse (erratum 2), with its own sign (erratum 7).
#[inline]
#[must_use]
pub fn applied<I: Inertia>(body: Velocity, mass: &Mass<I>, r: Vec3, impulse: Vec3) -> Velocity {
    Velocity {
        v: body.v + impulse * mass.inverse_mass,
        omega: body.omega + mass.moment(r.cross(impulse)),
    }
}
// ANCHOR_END: apply

// ANCHOR: surface_speed
/// The speed of approach at the surface, m/s, of bodies that approach with `speed` at the
/// depth `depth` and are pulled together with the acceleration `a_n` (negative: apart).
///
/// Energy along the normal: u_s² = u² − 2 a_n d. Whoever pushes bodies apart by d and lets them
/// part with e u_s adds no energy; and a body that rests, and so only fell by d, has u_s = 0.
#[inline]
#[must_use]
pub fn surface_speed(speed: Real, a_n: Real, depth: Real) -> Real {
    (speed * speed - 2.0 * a_n * depth).max(0.0).sqrt()
}
// ANCHOR_END: surface_speed

// ANCHOR: coulomb
/// Coulomb's law: the tangential impulse, N s, that friction can give against `wanted`, the one that
/// would stop the sliding. Up to μ_s N it sticks; beyond that it slides with μ_k N.
#[inline]
#[must_use]
pub fn coulomb(wanted: Vec3, normal: Real, friction_static: Real, friction_kinetic: Real) -> Vec3 {
    let size = wanted.length();
    if size <= friction_static * normal {
        wanted
    } else {
        wanted * (friction_kinetic * normal / size)
    }
}
// ANCHOR_END: coulomb

// ANCHOR: mixing
/// Restitution of a pair: the mean of the two. Report 8.4.1.
#[inline]
#[must_use]
pub fn mixed_restitution(e1: Real, e2: Real) -> Real {
    0.5 * (e1 + e2)
}

/// Friction of a pair: the geometric mean, so that a frictionless body has none with any other.
#[inline]
#[must_use]
pub fn mixed_friction(mu1: Real, mu2: Real) -> Real {
    (mu1 * mu2).sqrt()
}
// ANCHOR_END: mixing

/// The formulas as the report prints them.
pub mod printed {
    use super::{Mass, Real, Vec3, Velocity, point_velocity};

    // ANCHOR: printed
    /// v_r with r₁ in both places. Erratum 1.
    #[inline]
    #[must_use]
    pub fn relative_velocity(body_1: Velocity, r1: Vec3, body_2: Velocity) -> Vec3 {
        point_velocity(body_1, r1) - point_velocity(body_2, r1)
    }

    /// s₁ = m₂/(m₁ + m₂), s₂ = m₁/(m₁ + m₂): shares of an impulse that already accounts for
    /// both masses. Erratum 2. A static body has an infinite mass, so the other gets all of it.
    #[inline]
    #[must_use]
    pub fn shares(mass_1: &Mass, mass_2: &Mass) -> (Real, Real) {
        let sum = mass_1.inverse_mass + mass_2.inverse_mass;
        (mass_1.inverse_mass / sum, mass_2.inverse_mass / sum)
    }

    /// The velocity of either body as the second set of formulas in 8.4.2 prints it: body 2
    /// gets C with the sign of body 1. Erratum 7.
    #[inline]
    #[must_use]
    pub fn applied(body: Velocity, mass: &Mass, r: Vec3, share: Real, impulse: Vec3) -> Velocity {
        super::applied(body, mass, r, share * impulse)
    }
    // ANCHOR_END: printed
}
