//! The soft step: substeps in which rows are springs, damped far beyond need and as stiff as a substep bears,
//! so that errors of position are mended without haste, and after which what the springs added to the
//! velocities is taken out again. Restitution comes last. [Catto 2024, Solver2D's "TGS soft"]

use super::contacts::{Contact, Touch};
use super::implicit_gyro;
use super::real::{PI, Real};
use super::row::Row;
use super::sequential_impulses::{Ready, approaches};
use super::world::{Knobs, World};

/// Of contacts, 1/s, where substeps are short enough.
const CONTACT_HERTZ: Real = 30.0;
/// Of contacts: no spring, a dashpot.
const CONTACT_DAMPING: Real = 10.0;
/// Of joints, 1/s.
const JOINT_HERTZ: Real = 60.0;
/// Of joints.
const JOINT_DAMPING: Real = 2.0;
/// No overlap is mended faster, m/s.
const FASTEST_PUSH: Real = 3.0;

// ANCHOR: softness
/// A damped spring as a solver of velocities sees it.
#[derive(Clone, Copy)]
struct Softness {
    /// Share of a gap that is mended in a second, 1/s.
    rate: Real,
    /// Share of the impulse that a stiff row would give.
    mass: Real,
    /// Share of what was pressed that is taken back.
    impulse: Real,
}

impl Softness {
    const STIFF: Self = Self {
        rate: 0.0,
        mass: 1.0,
        impulse: 0.0,
    };

    fn of(hertz: Real, damping: Real, h: Real) -> Self {
        let omega = 2.0 * PI * hertz;
        let slow = 2.0 * damping + h * omega;
        let stiff = h * omega * slow;
        Self {
            rate: omega / slow,
            mass: stiff / (1.0 + stiff),
            impulse: 1.0 / (1.0 + stiff),
        }
    }
}
// ANCHOR_END: softness

// ANCHOR: step
/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    world.contacts.find(&world.bodies, world.gravity, dt);
    note_approaches(world);
    let h = dt / Real::from(knobs.substeps as u16);
    for _ in 0..knobs.substeps {
        world.accelerate(h, implicit_gyro::spun);
        press_again(world);
        for _ in 0..knobs.sweeps {
            solve(world, h, true);
        }
        world.advance(h);
        for _ in 0..knobs.sweeps {
            solve(world, h, false);
        }
    }
    bounce(world);
}
// ANCHOR_END: step

fn note_approaches(world: &mut World) {
    let approaches = approaches(world);
    for (contact, approach) in world.contacts.points.iter_mut().zip(approaches) {
        contact.approach = approach;
        contact.most = 0.0;
    }
}

fn press_again(world: &mut World) {
    let bodies = &mut world.bodies;
    for joint in &world.joints {
        joint.row(bodies).press(bodies, joint.impulse);
    }
    for contact in &world.contacts.points {
        let touch = contact.touch(bodies);
        contact.row(&touch).press(bodies, contact.impulse);
        contact.give(&touch, bodies, contact.friction);
    }
}

/// A sweep, with springs or without.
fn solve(world: &mut World, h: Real, springs: bool) {
    let joint_spring = Softness::of(JOINT_HERTZ, JOINT_DAMPING, h);
    let contact_spring = Softness::of(CONTACT_HERTZ.min(0.25 / h), CONTACT_DAMPING, h);
    for k in 0..world.joints.len() {
        let joint = &world.joints[k];
        let row = joint.row(&world.bodies);
        let (target, softness) = wanted(&row, h, springs.then_some(joint_spring));
        let sum = sum_of(world, row, target, softness, joint.impulse);
        row.press(&mut world.bodies, sum - world.joints[k].impulse);
        world.joints[k].impulse = sum;
    }
    for k in 0..world.contacts.points.len() {
        let contact = &world.contacts.points[k];
        let touch = contact.touch(&world.bodies);
        let row = contact.row(&touch);
        let (target, softness) = wanted(&row, h, springs.then_some(contact_spring));
        let sum = sum_of(
            world,
            row,
            target.min(FASTEST_PUSH),
            softness,
            contact.impulse,
        );
        let contact = &mut world.contacts.points[k];
        row.press(&mut world.bodies, sum - contact.impulse);
        contact.impulse = sum;
        contact.most = contact.most.max(sum);
        contact.rub(&touch, &mut world.bodies);
    }
}

// ANCHOR: wanted
/// The speed that a row shall have, and how soft it is. What is apart and may be is stiff: it closes its gap
/// at most.
fn wanted(row: &Row, h: Real, spring: Option<Softness>) -> (Real, Softness) {
    match spring {
        _ if row.one_sided && row.gap > 0.0 => (-row.gap / h, Softness::STIFF),
        Some(spring) => (-spring.rate * row.gap, spring),
        None => (0.0, Softness::STIFF),
    }
}

/// What a row has pressed in all after it was solved.
fn sum_of(world: &World, row: Row, target: Real, softness: Softness, sum: Real) -> Real {
    let ready = Ready::of(world, row, target);
    let missing = target - row.speed(&world.bodies);
    let sum = sum + softness.mass * ready.mass * missing - softness.impulse * sum;
    if row.one_sided { sum.max(0.0) } else { sum }
}
// ANCHOR_END: wanted

// ANCHOR: bounce
/// Contacts that came fast and met go back as fast as they shall.
fn bounce(world: &mut World) {
    let threshold = world.restitution_threshold;
    let bounces = |contact: &Contact| {
        contact.restitution > 0.0 && contact.approach < -threshold && contact.most > 0.0
    };
    for k in 0..world.contacts.points.len() {
        let contact = &world.contacts.points[k];
        if bounces(contact) {
            let touch: Touch = contact.touch(&world.bodies);
            let target = -contact.restitution * contact.approach;
            let ready = Ready::of(world, contact.row(&touch), target);
            let missing = target - ready.row.speed(&world.bodies);
            let sum = (contact.impulse + missing * ready.mass).max(0.0);
            ready.row.press(&mut world.bodies, sum - contact.impulse);
            world.contacts.points[k].impulse = sum;
        }
    }
}
// ANCHOR_END: bounce
