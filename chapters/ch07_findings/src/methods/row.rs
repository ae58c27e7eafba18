//! A row: one number that the bodies shall keep, and how it changes as they move. Contacts, pins, hinges and
//! limits are all made of rows, and a solver knows nothing else.

use super::bodies::Bodies;
use super::real::{Real, Vec3};

// ANCHOR: row
/// A row where the bodies are now. Its gap changes at the rate
/// n·(v_b − v_a) + t_b·ω_b − t_a·ω_a, and an impulse λ along it gives b λn and λt_b, and takes as much, λn
/// and λt_a, from a.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Row of the body a in its table.
    pub a: usize,
    /// Row of the body b.
    pub b: usize,
    /// n: unit vector, or 0 where only turning counts.
    pub linear: Vec3,
    /// t_a: arm × n, or an axis.
    pub angular_a: Vec3,
    /// t_b.
    pub angular_b: Vec3,
    /// C: how far it is from where it shall be, m or rad; what only must not be negative is free above 0.
    pub gap: Real,
    /// Whether the gap may be above 0, and the impulse only positive.
    pub one_sided: bool,
}
// ANCHOR_END: row

impl Row {
    /// Of a point of a and a point of b, along n; arms from the centres.
    #[must_use]
    pub fn along(a: (usize, Vec3), b: (usize, Vec3), n: Vec3, gap: Real) -> Self {
        Self {
            a: a.0,
            b: b.0,
            linear: n,
            angular_a: a.1.cross(n),
            angular_b: b.1.cross(n),
            gap,
            one_sided: false,
        }
    }

    /// Of the turn of b against a about an axis.
    #[must_use]
    pub fn about(a: usize, b: usize, axis: Vec3, gap: Real) -> Self {
        Self {
            a,
            b,
            linear: Vec3::ZERO,
            angular_a: axis,
            angular_b: axis,
            gap,
            one_sided: false,
        }
    }

    /// The same, free above 0.
    #[must_use]
    pub fn at_least_zero(self) -> Self {
        Self {
            one_sided: true,
            ..self
        }
    }

    // ANCHOR: inverse_mass
    /// 1/m of the row: how fast the gap changes a unit of impulse, 1/kg or 1/(kg m²).
    #[must_use]
    pub fn inverse_mass(&self, bodies: &Bodies) -> Real {
        let turning_a = self.angular_a.dot(bodies.turned_by(self.a, self.angular_a));
        let turning_b = self.angular_b.dot(bodies.turned_by(self.b, self.angular_b));
        let linear = bodies.inverse_mass[self.a] + bodies.inverse_mass[self.b];
        linear * self.linear.length_squared() + turning_a + turning_b
    }

    /// How fast the gap grows, m/s or rad/s.
    #[must_use]
    pub fn speed(&self, bodies: &Bodies) -> Real {
        let (a, b) = (self.a, self.b);
        self.linear.dot(bodies.velocity[b] - bodies.velocity[a])
            + self.angular_b.dot(bodies.angular_velocity[b])
            - self.angular_a.dot(bodies.angular_velocity[a])
    }

    /// Gives both bodies an impulse along the row, N s or N m s.
    pub fn press(&self, bodies: &mut Bodies, impulse: Real) {
        let (a, b) = (self.a, self.b);
        let (turned_a, turned_b) = (
            bodies.turned_by(a, self.angular_a),
            bodies.turned_by(b, self.angular_b),
        );
        bodies.velocity[a] -= self.linear * (impulse * bodies.inverse_mass[a]);
        bodies.velocity[b] += self.linear * (impulse * bodies.inverse_mass[b]);
        bodies.angular_velocity[a] -= turned_a * impulse;
        bodies.angular_velocity[b] += turned_b * impulse;
    }
    // ANCHOR_END: inverse_mass
}
