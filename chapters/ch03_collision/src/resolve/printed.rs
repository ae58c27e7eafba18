//! The report's `resolveCollisions` as printed: one visit a contact, no friction. Report 8.4.
//!
//! Where the report is silent: an impulse is given only to bodies that approach, and the
//! position correction moves p and p* together, shared by s₁ and s₂.

use ch00_maths::f32::impulse;
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use crate::Contact;

// ANCHOR: printed
/// Resolves every contact once, in order.
pub fn resolve_printed(bodies: &[Shared<RigidBody>], contacts: &mut [Contact]) {
    for contact in contacts {
        let mut body_1 = bodies[contact.a].borrow_mut();
        let mut body_2 = bodies[contact.b].borrow_mut();
        body_1.begin_resolving();
        body_2.begin_resolving();
        let (mass_1, mass_2) = (*body_1.answers(), *body_2.answers());
        let (r1, r2) = (
            contact.point - body_1.position(),
            contact.point - body_2.position(),
        );
        let n = contact.normal;
        let v_r = impulse::printed::relative_velocity(body_1.moving(), r1, body_2.moving());
        let approach = v_r.dot(n);
        let (s1, s2) = impulse::printed::shares(&mass_1, &mass_2);
        if approach < 0.0 {
            let response = impulse::response(&mass_1, r1, &mass_2, r2, n);
            let j = impulse::magnitude(approach, restitution(&body_1, &body_2), response);
            body_1.push(r1, s1 * j * n);
            body_2.push(r2, -s2 * j * n);
            contact.impulse = s1 * j * n;
        }
        for (body, share) in [(&mut body_1, s1), (&mut body_2, -s2)] {
            body.displace(share * contact.depth * n, Vec3::ZERO);
            let moving = body.moving();
            body.set_velocity(moving);
        }
    }
}
// ANCHOR_END: printed

/// e of the pair.
fn restitution(body_1: &RigidBody, body_2: &RigidBody) -> f32 {
    impulse::mixed_restitution(body_1.material().restitution, body_2.material().restitution)
}
