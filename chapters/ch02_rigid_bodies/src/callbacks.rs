//! Forces and torques as callbacks: functions that are asked, every step, what they do to a body
//! where it is now. Report 8.1, first footnote.

use ch00_maths::f32::force;
use ch01_hierarchy::Shared;
use glam::{Quat, Vec3};

use crate::RigidBody;

// ANCHOR: callback
/// What a callback may know of the body that it acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feel {
    /// Position, m.
    pub p: Vec3,
    /// Body to world.
    pub q: Quat,
    /// kg.
    pub mass: f32,
}

/// A force (N) or torque (N m) in world axes, as a function of the body that it acts on.
/// What else it depends on, it holds.
pub type Callback = Box<dyn Fn(&Feel) -> Vec3>;
// ANCHOR_END: callback

/// A magnetic pole on a body.
#[derive(Clone)]
struct Pole {
    body: Shared<RigidBody>,
    place: Vec3,
    strength: f32,
}

// ANCHOR: magnets
/// Lets every pole feel every pole of the other bodies: like poles push and unlike ones pull with
/// s₁ s₂/(d² + ε²), N, along the line between them.
///
/// A pole off its body's centre gives a torque too, so each pair is two callbacks a body.
pub fn add_magnets(poles: &[(Shared<RigidBody>, Vec3, f32)], softening: f32) {
    let poles: Vec<Pole> = poles
        .iter()
        .map(|(body, place, strength)| Pole {
            body: body.clone(),
            place: *place,
            strength: *strength,
        })
        .collect();
    for own in &poles {
        for other in &poles {
            if std::rc::Rc::ptr_eq(&own.body, &other.body) {
                continue;
            }
            let force = pole_force(own, other, softening);
            let place = own.place;
            let torque = pole_force(own, other, softening);
            let mut body = own.body.borrow_mut();
            body.add_force(Box::new(force));
            body.add_torque(Box::new(move |feel| (feel.q * place).cross(torque(feel))));
        }
    }
}
// ANCHOR_END: magnets

// ANCHOR: pole_force
/// The force on the pole `own` by the pole `other`.
fn pole_force(own: &Pole, other: &Pole, softening: f32) -> impl Fn(&Feel) -> Vec3 + use<> {
    let (place, other_place) = (own.place, other.place);
    let strength = own.strength * other.strength;
    let other = std::rc::Rc::downgrade(&other.body);
    move |feel| {
        let Some(other) = other.upgrade() else {
            return Vec3::ZERO;
        };
        let other = other.borrow();
        let between =
            feel.p + feel.q * place - (other.position() + other.orientation() * other_place);
        force::pole(between, strength, softening)
    }
}
// ANCHOR_END: pole_force
