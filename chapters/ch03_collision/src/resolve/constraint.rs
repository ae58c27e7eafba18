//! A contact while it is resolved: what stays the same during all sweeps, and what one visit does.

use ch00_maths::f32::contact;
use ch00_maths::f32::impulse::{self, coulomb, mixed_friction, mixed_restitution};
use ch00_maths::f32::shape::Shape;
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use super::{Rules, Span};
use crate::Contact;
use crate::narrow::MOST_SPOTS;

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
    /// The slowest approach that is an impact, m/s: no slower than what a pull makes of rest in a step.
    pub(super) slowest_impact: f32,
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
    /// Works out what stays the same while a step is resolved.
    pub fn new(
        one: &RigidBody,
        two: &RigidBody,
        contact: &Contact,
        rules: Rules,
        span: Span,
    ) -> Self {
        let n = contact.normal;
        let (material_1, material_2) = (one.material(), two.material());
        let static_friction =
            mixed_friction(material_1.static_friction, material_2.static_friction);
        let r1 = arm(one, contact.point, static_friction);
        let r2 = arm(two, contact.point, static_friction);
        let response = |u| impulse::response(one.answers(), r1, two.answers(), r2, u);
        let (across_1, across_2) = n.any_orthonormal_pair();
        let closing = (two.acceleration() - one.acceleration()).dot(n);
        let approach = impulse::relative_velocity(one.moving(), r1, two.moving(), r2).dot(n);
        let slowest = contact::slowest_impact(rules.restitution_threshold, closing, span.dt);
        let e = mixed_restitution(material_1.restitution, material_2.restitution);
        let slop = contact::slop(approach, closing, contact.depth, e, slowest, rules.slop);
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
            gap_speed: contact::gap_speed(contact.depth, span.dt),
            closing,
            slowest_impact: slowest,
            response: response(n),
            response_across: response(across_1).max(response(across_2)),
            restitution: e,
            friction: mixed_friction(material_1.friction, material_2.friction),
            static_friction,
            impact: Vec3::ZERO,
            support: contact.support * span.longer,
            rub: contact::sliding(contact.rub, n) * span.longer,
        }
    }

    /// v_r: velocity of body 1 relative to body 2 at the contact, m/s.
    pub fn relative_velocity(&self, bodies: &[Shared<RigidBody>]) -> Vec3 {
        let (one, two) = (bodies[self.a].borrow(), bodies[self.b].borrow());
        impulse::relative_velocity(one.moving(), self.r1, two.moving(), self.r2)
    }

    /// Whether two contacts are between the same bodies.
    pub fn is_of_same_pair(&self, other: &Self) -> bool {
        (self.a, self.b) == (other.a, other.b)
    }

    // ANCHOR: impact_speed
    /// The speed of approach at the surface, m/s, if that is an impact. What doesn't bounce needs none:
    /// resting contact stops it.
    pub fn impact_speed(&self, v_r: Vec3) -> Option<f32> {
        contact::impact_speed(
            v_r.dot(self.normal),
            self.gap_speed,
            self.restitution,
            self.closing,
            self.pushed,
            self.slowest_impact,
        )
    }
    // ANCHOR_END: impact_speed

    // ANCHOR: part
    /// Nudges the two bodies apart by what is left of their depth, the one that yields more further;
    /// or takes back, of what it has nudged before, what others have made superfluous. Gives how far, m.
    pub fn part(&mut self, bodies: &[Shared<RigidBody>]) -> f32 {
        let (mut one, mut two) = (bodies[self.a].borrow_mut(), bodies[self.b].borrow_mut());
        let parted = one.nudged(self.r1) - two.nudged(self.r2);
        let left = self.depth - self.normal.dot(parted);
        let pushed = contact::accumulated(self.pushed, left);
        let change = pushed - self.pushed;
        if change != 0.0 {
            self.pushed = pushed;
            let nudge = self.normal * (change / self.response);
            one.nudge(self.r1, nudge);
            two.nudge(self.r2, -nudge);
        }
        change.abs()
    }
    // ANCHOR_END: part

    // ANCHOR: pay_for_lift
    /// Takes from the rest of its speed what a body's lift out of an obstacle costs beyond what its
    /// fall pays: ½ v² must drop by the acceleration times the lift. Of a pair's contacts the one that
    /// lifted furthest pays for all.
    pub fn pay_for_lift(pair: &[Self], bodies: &[Shared<RigidBody>]) {
        let further = |a: &&Self, b: &&Self| a.pushed.total_cmp(&b.pushed);
        let Some(c) = pair.iter().max_by(further) else {
            return;
        };
        if !c.is_against_static() || c.closing <= 0.0 || c.restitution == 0.0 {
            return;
        }
        let (moving, out, weight) = if c.w1 > 0.0 {
            (c.a, c.normal, c.w1)
        } else {
            (c.b, -c.normal, c.w2)
        };
        let mut body = bodies[moving].borrow_mut();
        let lift = c.pushed * weight / c.response;
        let v = body.moving().v;
        if let Some(paid) = contact::pay_for_lift(v, out, c.closing, lift, weight) {
            body.push(Vec3::ZERO, paid);
        }
    }
    // ANCHOR_END: pay_for_lift

    // ANCHOR: impact
    /// An impact of two bodies that meet at these points: they part with e times the speed that they
    /// had at the surface. Says whether it was one.
    pub fn impact(pair: &mut [Self], bodies: &[Shared<RigidBody>], rules: Rules) -> bool {
        let mut hits = [(0, 0.0, 0.0); MOST_SPOTS];
        let mut count = 0;
        for (i, c) in pair.iter().enumerate() {
            if let Some(speed) = c.impact_speed(c.relative_velocity(bodies)) {
                hits[count] = (i, c.restitution * speed, 0.0);
                count += 1;
            }
        }
        let hits = &mut hits[..count];
        let visits = if count > 1 { rules.sweeps } else { 1 };
        for _ in 0..visits {
            for (i, parting, sum) in &mut *hits {
                let c = &mut pair[*i];
                let missing = *parting - c.relative_velocity(bodies).dot(c.normal);
                let normal = contact::accumulated(*sum, missing / c.response);
                c.apply_impact(bodies, (normal - *sum) * c.normal);
                *sum = normal;
            }
        }
        for &(i, _, normal) in &*hits {
            let c = &mut pair[i];
            let wanted = -c.sliding(bodies) / c.response_across;
            let friction = coulomb(wanted, normal, c.static_friction, c.friction);
            c.apply_impact(bodies, friction);
        }
        count > 0
    }
    // ANCHOR_END: impact

    /// The part of the relative velocity that lies in the contact's plane, m/s.
    fn sliding(&self, bodies: &[Shared<RigidBody>]) -> Vec3 {
        contact::sliding(self.relative_velocity(bodies), self.normal)
    }

    /// An impulse that no sweep takes back, N s.
    fn apply_impact(&mut self, bodies: &[Shared<RigidBody>], impulse: Vec3) {
        self.apply(bodies, impulse);
        self.impact += impulse;
    }

    // ANCHOR: hold
    /// Mends the support and then the friction of this contact. Says whether that changed anything
    /// worth another sweep.
    pub fn hold(&mut self, bodies: &[Shared<RigidBody>], rules: Rules) -> bool {
        let u = self.relative_velocity(bodies).dot(self.normal);
        if contact::is_let_come(u, self.gap_speed, self.restitution, self.slowest_impact) {
            return false;
        }
        let approach = u + self.gap_speed;
        let support = contact::accumulated(self.support, -approach / self.response);
        if support == 0.0 && self.support == 0.0 {
            return false;
        }
        let change = support - self.support;
        self.apply(bodies, change * self.normal);
        self.support = support;
        let wanted = self.rub - self.sliding(bodies) / self.response_across;
        let rub = coulomb(wanted, support, self.static_friction, self.friction);
        let rubbed = rub - self.rub;
        self.apply(bodies, rubbed);
        self.rub = rub;
        change.abs() * self.response > rules.still
            || rubbed.length() * self.response_across > rules.still
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

/// From a body's centre to where a contact's impulses act on it.
fn arm(body: &RigidBody, point: Vec3, friction: f32) -> Vec3 {
    let is_ball = matches!(body.collider(), Shape::Sphere { .. });
    contact::arm(point, body.position(), is_ball, friction)
}
