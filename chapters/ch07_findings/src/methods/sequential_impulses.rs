//! Sequential impulses with Baumgarte's stabilisation: sweeps over all rows, each solved as if it were alone,
//! with what it pressed so far kept and what it pressed in the last step given first. Errors of position are
//! mended by a speed that is part of the velocity, and stays in it.

use super::contacts::{Contact, Touch};
use super::implicit_gyro;
use super::real::{Real, Vec3};
use super::row::Row;
use super::world::{Knobs, World};

/// Share of a gap that is mended in a substep.
const BAUMGARTE: Real = 0.2;

// ANCHOR: step
/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    world.contacts.find(&world.bodies, world.gravity, dt);
    let h = dt / Real::from(knobs.substeps as u16);
    for _ in 0..knobs.substeps {
        let approaches = approaches(world);
        world.accelerate(h, implicit_gyro::spun);
        let rows = joint_rows(world, h);
        let touches = touches(world, &approaches, h);
        press_again(world, &rows, &touches);
        for _ in 0..knobs.sweeps {
            solve_joints(world, &rows);
            solve_contacts(world, &touches);
        }
        world.advance(h);
    }
}
// ANCHOR_END: step

/// A row, ready to be solved.
pub struct Ready {
    /// Where it is.
    pub row: Row,
    /// Its effective mass, kg or kg m²; 0 where nothing can move.
    pub mass: Real,
    /// The speed that it shall have, m/s or rad/s.
    pub target: Real,
}

impl Ready {
    /// A row that shall have a speed.
    #[must_use]
    pub fn of(world: &World, row: Row, target: Real) -> Self {
        let inverse = row.inverse_mass(&world.bodies);
        let mass = if inverse > 0.0 { 1.0 / inverse } else { 0.0 };
        Self { row, mass, target }
    }
}

/// How fast each contact comes, m/s, before gravity has its share.
#[must_use]
pub fn approaches(world: &World) -> Vec<Real> {
    let bodies = &world.bodies;
    let speed = |contact: &Contact| contact.row(&contact.touch(bodies)).speed(bodies);
    world.contacts.points.iter().map(speed).collect()
}

fn joint_rows(world: &World, h: Real) -> Vec<Ready> {
    let ready = |row: Row| {
        let part = if row.one_sided && row.gap > 0.0 {
            1.0
        } else {
            BAUMGARTE
        };
        Ready::of(world, row, -part * row.gap / h)
    };
    let rows = world.joints.iter().map(|joint| joint.row(&world.bodies));
    rows.map(ready).collect()
}

// ANCHOR: touches
/// A contact that is apart may close its gap and no more; one that comes fast and will bounce is left alone
/// until it is there. One that is there shall not go deeper, mends a part of its depth, and bounces.
#[must_use]
pub fn touches(world: &World, approaches: &[Real], h: Real) -> Vec<Option<(Touch, Ready)>> {
    let ready = |(contact, &approach): (&Contact, &Real)| {
        let touch = contact.touch(&world.bodies);
        let bounces = contact.restitution > 0.0 && approach < -world.restitution_threshold;
        let target = match touch.gap > 0.0 {
            true if bounces => return None,
            true => -touch.gap / h,
            false if bounces => (-BAUMGARTE * touch.gap / h).max(-contact.restitution * approach),
            false => -BAUMGARTE * touch.gap / h,
        };
        Some((touch, Ready::of(world, contact.row(&touch), target)))
    };
    let contacts = world.contacts.points.iter();
    contacts.zip(approaches).map(ready).collect()
}
// ANCHOR_END: touches

fn press_again(world: &mut World, rows: &[Ready], touches: &[Option<(Touch, Ready)>]) {
    for (joint, ready) in world.joints.iter().zip(rows) {
        ready.row.press(&mut world.bodies, joint.impulse);
    }
    press_contacts_again(world, touches);
}

/// Contacts begin with what they pressed in the last substep.
pub fn press_contacts_again(world: &mut World, touches: &[Option<(Touch, Ready)>]) {
    let bodies = &mut world.bodies;
    for (contact, touch) in world.contacts.points.iter_mut().zip(touches) {
        if let Some((touch, ready)) = touch {
            ready.row.press(bodies, contact.impulse);
            contact.give(touch, bodies, contact.friction);
        } else {
            (contact.impulse, contact.friction) = (0.0, Vec3::ZERO);
        }
    }
}

// ANCHOR: solve
fn solve_joints(world: &mut World, rows: &[Ready]) {
    for (joint, ready) in world.joints.iter_mut().zip(rows) {
        let speed = ready.row.speed(&world.bodies);
        let mut sum = joint.impulse + (ready.target - speed) * ready.mass;
        if ready.row.one_sided {
            sum = sum.max(0.0);
        }
        ready.row.press(&mut world.bodies, sum - joint.impulse);
        joint.impulse = sum;
    }
}

/// A sweep over the contacts.
pub fn solve_contacts(world: &mut World, touches: &[Option<(Touch, Ready)>]) {
    for (contact, touch) in world.contacts.points.iter_mut().zip(touches) {
        let Some((touch, ready)) = touch else {
            continue;
        };
        let speed = ready.row.speed(&world.bodies);
        let sum = (contact.impulse + (ready.target - speed) * ready.mass).max(0.0);
        ready.row.press(&mut world.bodies, sum - contact.impulse);
        contact.impulse = sum;
        contact.rub(touch, &mut world.bodies);
    }
}
// ANCHOR_END: solve
