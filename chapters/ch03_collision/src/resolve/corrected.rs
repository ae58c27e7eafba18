//! Resolution with the errata mended: every contact looks at what its neighbours did, sweep
//! after sweep. Report 8.4; friction is the section it left open.
//!
//! Three things happen, none of which can add energy: overlapping bodies are pushed apart, fast
//! ones bounce as if they had met at the surface, and what then still approaches is stopped
//! and rubs.

use ch00_maths::f32::impulse::{self, coulomb, mixed_friction, mixed_restitution, surface_speed};
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use super::{LONGEST_SHIFT, Rules};
use crate::Contact;

/// A contact while it is resolved.
struct Constraint {
    a: usize,
    b: usize,
    /// n̂, from body 2 to body 1.
    normal: Vec3,
    /// From the centres to the contact, m.
    r1: Vec3,
    r2: Vec3,
    /// Depth to be pushed out, m; negative for a gap.
    depth: f32,
    /// How far this contact has pushed its bodies apart in this step, m.
    pushed: f32,
    /// Speed at which the gap between them would just close in a step, m/s.
    gap_speed: f32,
    /// Acceleration with which the bodies are pulled together, m/s².
    closing: f32,
    /// What a unit impulse changes, along the normal and across it, 1/kg.
    response: f32,
    response_across: f32,
    restitution: f32,
    friction: f32,
    static_friction: f32,
    /// Impulses of the impacts, N s: never taken back.
    impact: Vec3,
    /// Impulses of resting contact, N s: taken back where a neighbour made them superfluous.
    support: f32,
    rub: Vec3,
}

// ANCHOR: resolve
/// Resolves all contacts together. Returns how many impacts were left when the sweeps ended; the
/// resting contact then stops those bodies without a bounce.
pub fn resolve_corrected(
    bodies: &[Shared<RigidBody>],
    contacts: &mut [Contact],
    rules: Rules,
    dt: f32,
) -> usize {
    begin(bodies, contacts);
    let mut constraints = prepare(bodies, contacts, rules, dt);
    let shifts = push_apart(bodies, &mut constraints, rules);
    let left = bounce(bodies, &mut constraints, rules);
    rest(bodies, &mut constraints, rules);
    end(bodies, contacts, &constraints, &shifts);
    left
}
// ANCHOR_END: resolve

/// Reads the velocities of all bodies that touch something.
fn begin(bodies: &[Shared<RigidBody>], contacts: &[Contact]) {
    for i in touching(bodies.len(), contacts) {
        bodies[i].borrow_mut().begin_resolving();
    }
}

/// The bodies that appear in a contact, each once, in order.
fn touching(count: usize, contacts: &[Contact]) -> impl Iterator<Item = usize> {
    let mut touches = vec![false; count];
    for contact in contacts {
        touches[contact.a] = true;
        touches[contact.b] = true;
    }
    (0..count).filter(move |&i| touches[i])
}

/// Works out what stays the same during all sweeps.
fn prepare(
    bodies: &[Shared<RigidBody>],
    contacts: &[Contact],
    rules: Rules,
    dt: f32,
) -> Vec<Constraint> {
    contacts
        .iter()
        .map(|contact| {
            prepare_one(
                &bodies[contact.a].borrow(),
                &bodies[contact.b].borrow(),
                contact,
                rules,
                dt,
            )
        })
        .collect()
}

fn prepare_one(
    one: &RigidBody,
    two: &RigidBody,
    contact: &Contact,
    rules: Rules,
    dt: f32,
) -> Constraint {
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
    Constraint {
        a: contact.a,
        b: contact.b,
        normal: n,
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

// ANCHOR: push_apart
/// Finds shifts, m, that part the bodies: each contact moves its two by what is left of its
/// depth, the lighter more, until all have had their turns. Velocities stay.
fn push_apart(
    bodies: &[Shared<RigidBody>],
    constraints: &mut [Constraint],
    rules: Rules,
) -> Vec<Vec3> {
    let mut shifts = vec![Vec3::ZERO; bodies.len()];
    for _ in 0..rules.sweeps {
        for c in &mut *constraints {
            c.part(bodies, &mut shifts);
        }
    }
    for shift in &mut shifts {
        *shift = shift.clamp_length_max(LONGEST_SHIFT);
    }
    for c in constraints
        .iter_mut()
        .filter(|c| c.is_against_static(bodies))
    {
        c.part(bodies, &mut shifts);
    }
    shifts
}
// ANCHOR_END: push_apart

// ANCHOR: bounce
/// Impacts, one after the other, until nobody approaches fast: each is a collision of two bodies
/// that leaves them parting with e times the speed they had at the surface.
fn bounce(bodies: &[Shared<RigidBody>], constraints: &mut [Constraint], rules: Rules) -> usize {
    for _ in 0..rules.sweeps {
        let mut impacts = 0;
        for c in &mut *constraints {
            let v_r = c.relative_velocity(bodies);
            let Some(speed) = c.impact_speed(v_r, rules) else {
                continue;
            };
            let approach = v_r.dot(c.normal);
            let normal = (c.restitution * speed - approach) / c.response;
            let wanted = -(v_r - approach * c.normal) / c.response_across;
            let friction = coulomb(wanted, normal, c.static_friction, c.friction);
            c.apply(bodies, normal * c.normal + friction);
            c.impact += normal * c.normal + friction;
            impacts += 1;
        }
        if impacts == 0 {
            return 0;
        }
    }
    constraints
        .iter()
        .filter(|c| c.impact_speed(c.relative_velocity(bodies), rules).is_some())
        .count()
}
// ANCHOR_END: bounce

// ANCHOR: rest
/// Resting contact: supports stop what still approaches, friction stops what slides. Both are
/// kept as sums, so that a later sweep can take back what an earlier one gave too much.
fn rest(bodies: &[Shared<RigidBody>], constraints: &mut [Constraint], rules: Rules) {
    for c in &*constraints {
        c.apply(bodies, c.support * c.normal + c.rub);
    }
    for _ in 0..rules.sweeps {
        for c in &mut *constraints {
            c.hold(bodies, rules);
        }
    }
    for c in constraints
        .iter_mut()
        .filter(|c| c.is_against_static(bodies))
    {
        c.hold(bodies, rules);
    }
}
// ANCHOR_END: rest

/// Writes shifts and velocities into the bodies, and impulses into the contacts.
fn end(
    bodies: &[Shared<RigidBody>],
    contacts: &mut [Contact],
    constraints: &[Constraint],
    shifts: &[Vec3],
) {
    for i in touching(bodies.len(), contacts) {
        bodies[i].borrow_mut().end_resolving(shifts[i]);
    }
    for (contact, c) in contacts.iter_mut().zip(constraints) {
        contact.impulse = c.impact + c.support * c.normal + c.rub;
        contact.support = c.support;
        contact.rub = c.rub;
    }
}

impl Constraint {
    fn relative_velocity(&self, bodies: &[Shared<RigidBody>]) -> Vec3 {
        let (one, two) = (bodies[self.a].borrow(), bodies[self.b].borrow());
        impulse::relative_velocity(one.moving(), self.r1, two.moving(), self.r2)
    }

    /// The speed of approach at the surface, m/s, if that is an impact.
    fn impact_speed(&self, v_r: Vec3, rules: Rules) -> Option<f32> {
        let approach = v_r.dot(self.normal);
        if approach >= 0.0 || self.gap_speed > 0.0 {
            return None;
        }
        let speed = surface_speed(-approach, self.closing, self.pushed);
        (speed > rules.restitution_threshold).then_some(speed)
    }

    /// Shifts the two bodies by what is left of their depth.
    fn part(&mut self, bodies: &[Shared<RigidBody>], shifts: &mut [Vec3]) {
        let left = self.depth - self.normal.dot(shifts[self.a] - shifts[self.b]);
        if left <= 0.0 {
            return;
        }
        let (one, two) = (bodies[self.a].borrow(), bodies[self.b].borrow());
        let (w1, w2) = (one.answers().inverse_mass, two.answers().inverse_mass);
        self.pushed += left;
        let push = self.normal * (left / (w1 + w2));
        shifts[self.a] += push * w1;
        shifts[self.b] -= push * w2;
    }

    /// Mends the support and then the friction of this contact.
    fn hold(&mut self, bodies: &[Shared<RigidBody>], rules: Rules) {
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

    /// Whether one of its bodies can't move.
    fn is_against_static(&self, bodies: &[Shared<RigidBody>]) -> bool {
        bodies[self.a].borrow().is_static() || bodies[self.b].borrow().is_static()
    }

    /// The impulse on body 1, N s, and its opposite on body 2.
    fn apply(&self, bodies: &[Shared<RigidBody>], impulse: Vec3) {
        bodies[self.a].borrow_mut().push(self.r1, impulse);
        bodies[self.b].borrow_mut().push(self.r2, -impulse);
    }
}
