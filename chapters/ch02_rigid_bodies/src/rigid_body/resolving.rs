//! What a rigid body goes through while contacts and joints are resolved: impulses that change what
//! it moves with, and nudges and displacements that change where it is. Report 8.4 and 9.3.

use ch00_maths::f32::impulse::{self, Mass, Velocity};
use ch00_maths::f32::{rotation, spin};
use glam::{Quat, Vec3};

use super::RigidBody;

impl RigidBody {
    /// Before collisions are resolved: reads its velocities and turns its inertia, once.
    pub fn begin_resolving(&mut self) {
        self.moving = self.velocity();
        self.weigh();
        self.shift = Vec3::ZERO;
        self.turn = Vec3::ZERO;
    }

    /// Turns its inertia to where it is now.
    pub fn weigh(&mut self) {
        self.answers = Mass::new(self.inverse_mass, self.inverse_inertia, self.q);
    }

    /// Its velocities as far as they are resolved.
    #[must_use]
    pub fn moving(&self) -> Velocity {
        self.moving
    }

    /// How it answers to impulses while collisions are resolved.
    #[must_use]
    pub fn answers(&self) -> &Mass {
        &self.answers
    }

    /// An impulse, N s, at `r` from its centre, m, world axes.
    pub fn push(&mut self, r: Vec3, impulse: Vec3) {
        self.moving = impulse::applied(self.moving, &self.answers, r, impulse);
    }

    /// An angular impulse, N m s, world axes.
    pub fn twist(&mut self, impulse: Vec3) {
        self.moving.omega += self.answers.moment(impulse);
    }

    // ANCHOR: resting
    /// Before supports, friction and joints are resolved: from now on [`Self::moving`] is what it will
    /// move with in the middle of the coming step.
    pub fn begin_resting(&mut self) {
        self.held_by = self.moving;
        let half = 0.5 * self.dt_last;
        let omega = self.moving.omega;
        let kick = spin::half_kick(self.q, self.inertia, omega, self.torque, self.dt_last);
        self.half_kick = Velocity {
            v: half * self.acceleration,
            omega: self.answers.moment(kick),
        };
        self.moving.v += self.half_kick.v;
        self.moving.omega += self.half_kick.omega;
    }

    /// After collisions are resolved: moves it by its shift and turn, and gives it the velocities it
    /// has now.
    pub fn end_resolving(&mut self) {
        self.moving.v -= self.half_kick.v;
        self.moving.omega -= self.half_kick.omega;
        let held_by = Velocity {
            v: self.moving.v - self.held_by.v,
            omega: self.moving.omega - self.held_by.omega,
        };
        self.displace(self.shift, self.turn);
        self.set_velocity(self.moving);
        self.held_by = held_by;
    }
    // ANCHOR_END: resting

    /// Says that what holds it holds it from now on only, and not for half a step already.
    pub fn begin_now(&mut self) {
        self.held_by.v *= 2.0;
        self.held_by.omega *= 2.0;
    }

    // ANCHOR: nudge
    /// A positional impulse, kg m, at `r` from its centre, that [`Self::end_resolving`] will carry out:
    /// it moves and turns the body but leaves its velocities.
    pub fn nudge(&mut self, r: Vec3, impulse: Vec3) {
        self.shift += impulse * self.answers.inverse_mass;
        self.turn += self.answers.moment(r.cross(impulse));
    }

    /// The same for a positional angular impulse, kg m².
    pub fn nudge_turn(&mut self, impulse: Vec3) {
        self.turn += self.answers.moment(impulse);
    }

    /// Where the point `r` from its centre has been nudged to, m.
    #[must_use]
    pub fn nudged(&self, r: Vec3) -> Vec3 {
        self.shift + self.turn.cross(r)
    }
    // ANCHOR_END: nudge

    /// Where its nudges have brought it: position, m, and orientation.
    #[must_use]
    pub fn nudged_pose(&self) -> (Vec3, Quat) {
        (self.p + self.shift, rotation::turned(self.q, self.turn))
    }

    /// Makes its shift at most `longest`, m.
    pub fn shorten_shift(&mut self, longest: f32) {
        self.shift = self.shift.clamp_length_max(longest);
    }

    /// Moves it by `shift`, m, and turns it by `turn`, rad; p* and q* stay, so that its velocities
    /// follow.
    pub fn displace(&mut self, shift: Vec3, turn: Vec3) {
        self.p += shift;
        if turn != Vec3::ZERO {
            self.q = rotation::turned(self.q, turn);
        }
    }

    /// Carries out a positional impulse, kg m, at `r` from its centre at once; velocities follow.
    pub fn displace_by(&mut self, r: Vec3, impulse: Vec3) {
        self.displace_about(r, impulse, Vec3::ZERO);
    }

    /// The same together with a positional angular impulse, kg m².
    pub fn displace_about(&mut self, r: Vec3, impulse: Vec3, turning: Vec3) {
        let turn = self.answers.moment(r.cross(impulse) + turning);
        self.displace(impulse * self.inverse_mass, turn);
    }

    /// Moves and turns it as the report prints it: to first order, in the wrong frame (erratum 4).
    pub fn displace_printed(&mut self, shift: Vec3, turn: Vec3) {
        self.p += shift;
        self.q = rotation::printed::turned(self.q, turn);
    }
}
