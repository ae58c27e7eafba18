//! A contact while it is resolved: what stays the same during all sweeps, and what one visit does.

use ch00_maths::f32::impulse::{self, coulomb, mixed_friction, mixed_restitution, surface_speed};
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use super::Rules;
use crate::Contact;

/// A lift that nobody pays for, m: what rounding makes of a body that rests and owes nothing.
const LIFT_FOR_FREE: f32 = 1e-5;

/// A contact while it is resolved.
pub struct Constraint {
    pub(super) a: usize,
    pub(super) b: usize,
    /// n̂, from body 2 to body 1.
    pub(super) normal: Vec3,
    /// Inverse masses, 1/kg.
    pub(super) w1: f32,
    pub(super) w2: f32,
    /// From the centres to the contact, m.
    pub(super) r1: Vec3,
    pub(super) r2: Vec3,
    /// Depth to be pushed out, m; negative for a gap.
    pub(super) depth: f32,
    /// How far this contact has pushed its bodies apart in this step, m.
    pub(super) pushed: f32,
    /// Speed at which the gap between them would just close in a step, m/s.
    pub(super) gap_speed: f32,
    /// Acceleration with which the bodies are pulled together, m/s².
    pub(super) closing: f32,
    /// What a unit impulse changes, along the normal and across it, 1/kg.
    pub(super) response: f32,
    pub(super) response_across: f32,
    pub(super) restitution: f32,
    pub(super) friction: f32,
    pub(super) static_friction: f32,
    /// Impulses of the impacts, N s: never taken back.
    pub(super) impact: Vec3,
    /// Impulses of resting contact, N s: taken back where a neighbour made them superfluous.
    pub(super) support: f32,
    pub(super) rub: Vec3,
}

impl Constraint {
    /// Works out what stays the same while a step of `dt` seconds is resolved.
    pub fn new(one: &RigidBody, two: &RigidBody, contact: &Contact, rules: Rules, dt: f32) -> Self {
        let n = contact.normal;
        let r1 = contact.point - one.position();
        let r2 = contact.point - two.position();
        let response = |u| impulse::response(one.answers(), r1, two.answers(), r2, u);
        let (across_1, across_2) = n.any_orthonormal_pair();
        let (material_1, material_2) = (one.material(), two.material());
        let closing = (two.acceleration() - one.acceleration()).dot(n);
        let approach = impulse::relative_velocity(one.moving(), r1, two.moving(), r2).dot(n);
        let speed = surface_speed((-approach).max(0.0), closing, contact.depth.max(0.0));
        // Who bounces starts from the surface; who rests may stay a little inside.
        let slop = if speed > rules.restitution_threshold {
            0.0
        } else {
            rules.slop
        };
        Self {
            a: contact.a,
            b: contact.b,
            normal: n,
            w1: one.answers().inverse_mass,
            w2: two.answers().inverse_mass,
            r1,
            r2,
            depth: contact.depth - slop,
            pushed: 0.0,
            gap_speed: (-contact.depth).max(0.0) / dt,
            closing,
            response: response(n),
            response_across: response(across_1).max(response(across_2)),
            restitution: mixed_restitution(material_1.restitution, material_2.restitution),
            friction: mixed_friction(material_1.friction, material_2.friction),
            static_friction: mixed_friction(material_1.static_friction, material_2.static_friction),
            impact: Vec3::ZERO,
            support: contact.support,
            rub: contact.rub - contact.rub.dot(n) * n,
        }
    }

    /// v_r: velocity of body 1 relative to body 2 at the contact, m/s.
    pub fn relative_velocity(&self, bodies: &[Shared<RigidBody>]) -> Vec3 {
        let (one, two) = (bodies[self.a].borrow(), bodies[self.b].borrow());
        impulse::relative_velocity(one.moving(), self.r1, two.moving(), self.r2)
    }

    // ANCHOR: impact_speed
    /// The speed of approach at the surface, m/s, if that is an impact.
    pub fn impact_speed(&self, v_r: Vec3, rules: Rules) -> Option<f32> {
        let approach = v_r.dot(self.normal);
        if approach >= 0.0 || self.gap_speed > 0.0 {
            return None;
        }
        let speed = surface_speed(-approach, self.closing, self.pushed);
        (speed > rules.restitution_threshold).then_some(speed)
    }
    // ANCHOR_END: impact_speed

    // ANCHOR: part
    /// Shifts the two bodies by what is left of their depth, the lighter one further. Says whether
    /// there was anything left.
    pub fn part(&mut self, shifts: &mut [Vec3]) -> bool {
        let left = self.depth - self.normal.dot(shifts[self.a] - shifts[self.b]);
        if left <= 0.0 {
            return false;
        }
        self.pushed += left;
        let push = self.normal * (left / (self.w1 + self.w2));
        shifts[self.a] += push * self.w1;
        shifts[self.b] -= push * self.w2;
        true
    }
    // ANCHOR_END: part

    // ANCHOR: pay_for_lift
    /// Takes from the rest of its speed what a body's lift out of an obstacle costs beyond what its
    /// fall pays: ½ v² must drop by the acceleration times the lift.
    pub fn pay_for_lift(&self, bodies: &[Shared<RigidBody>]) {
        if !self.is_against_static() || self.closing <= 0.0 {
            return;
        }
        let (moving, out, weight) = if self.w1 > 0.0 {
            (self.a, self.normal, self.w1)
        } else {
            (self.b, -self.normal, self.w2)
        };
        let mut body = bodies[moving].borrow_mut();
        let v = body.moving().v;
        let fall = (-v.dot(out)).max(0.0);
        let unpaid = self.pushed - fall * fall / (2.0 * self.closing);
        let rest = v + fall * out;
        let speed = rest.length();
        if unpaid > LIFT_FOR_FREE && speed > 0.0 {
            let left = surface_speed(speed, self.closing, unpaid);
            body.push(Vec3::ZERO, rest * ((left / speed - 1.0) / weight));
        }
    }
    // ANCHOR_END: pay_for_lift

    // ANCHOR: hold
    /// Mends the support and then the friction of this contact.
    pub fn hold(&mut self, bodies: &[Shared<RigidBody>], rules: Rules) {
        let approach = self.relative_velocity(bodies).dot(self.normal) + self.gap_speed;
        if self.gap_speed > 0.0 && approach < self.gap_speed - rules.restitution_threshold {
            // It comes fast enough to bounce: let it come.
            return;
        }
        let support = (self.support - approach / self.response).max(0.0);
        if support == 0.0 && self.support == 0.0 {
            return;
        }
        self.apply(bodies, (support - self.support) * self.normal);
        self.support = support;
        let v_r = self.relative_velocity(bodies);
        let sliding = v_r - v_r.dot(self.normal) * self.normal;
        let wanted = self.rub - sliding / self.response_across;
        let rub = coulomb(wanted, support, self.static_friction, self.friction);
        self.apply(bodies, rub - self.rub);
        self.rub = rub;
    }
    // ANCHOR_END: hold

    /// Whether one of its bodies can't move.
    pub fn is_against_static(&self) -> bool {
        self.w1 == 0.0 || self.w2 == 0.0
    }

    /// The impulse on body 1, N s, and its opposite on body 2.
    pub fn apply(&self, bodies: &[Shared<RigidBody>], impulse: Vec3) {
        bodies[self.a].borrow_mut().push(self.r1, impulse);
        bodies[self.b].borrow_mut().push(self.r2, -impulse);
    }
}
