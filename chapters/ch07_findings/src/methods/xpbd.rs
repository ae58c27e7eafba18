//! Extended position-based dynamics in small steps: bodies are moved, then pushed to where their joints and
//! contacts want them, and the velocity is what that came to. Friction that holds is part of the push;
//! friction that slides and restitution change velocities at the end. [Müller et al. 2020]

use super::contacts::{Contact, Touch};
use super::explicit_gyro;
use super::real::{Quat, Real, Vec3, rotation};
use super::row::Row;
use super::world::{Knobs, World};

// ANCHOR: step
/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    world.contacts.find(&world.bodies, world.gravity, dt);
    let h = dt / Real::from(knobs.substeps as u16);
    for _ in 0..knobs.substeps {
        let before = Before::of(world);
        world.accelerate(h, explicit_gyro::spun);
        drift(world, h);
        let mut pressed = vec![0.0; world.contacts.points.len()];
        for _ in 0..knobs.sweeps {
            solve_joints(world);
            solve_contacts(world, &before, &mut pressed);
        }
        read_velocities(world, &before, h);
        rub_and_bounce(world, &before, &pressed, h);
    }
}
// ANCHOR_END: step

/// As it was when the substep began.
struct Before {
    position: Vec<Vec3>,
    attitude: Vec<Quat>,
    /// How fast each contact came, m/s.
    approach: Vec<Real>,
}

impl Before {
    fn of(world: &World) -> Self {
        Self {
            position: world.bodies.position.clone(),
            attitude: world.bodies.attitude.clone(),
            approach: super::sequential_impulses::approaches(world),
        }
    }
}

/// The turn by θ to first order, as the paper has it.
fn drift(world: &mut World, h: Real) {
    let bodies = &mut world.bodies;
    for row in (0..bodies.count())
        .filter(|&row| bodies.inverse_mass[row] > 0.0)
        .collect::<Vec<_>>()
    {
        bodies.position[row] += bodies.velocity[row] * h;
        let turn = bodies.angular_velocity[row] * h;
        bodies.attitude[row] = rotation::turned_first_order(bodies.attitude[row], turn);
    }
}

// ANCHOR: push
/// Pushes both bodies along a row until its gap is closed; gives the push, kg m.
fn push(world: &mut World, row: &Row, gap: Real) -> Real {
    let bodies = &mut world.bodies;
    let inverse_mass = row.inverse_mass(bodies);
    if inverse_mass == 0.0 {
        return 0.0;
    }
    let push = -gap / inverse_mass;
    for (body, turning, sign) in [(row.a, row.angular_a, -1.0), (row.b, row.angular_b, 1.0)] {
        let turn = bodies.turned_by(body, turning) * (sign * push);
        bodies.position[body] += row.linear * (sign * push * bodies.inverse_mass[body]);
        bodies.attitude[body] = rotation::turned_first_order(bodies.attitude[body], turn);
    }
    push
}
// ANCHOR_END: push

fn solve_joints(world: &mut World) {
    for k in 0..world.joints.len() {
        let row = world.joints[k].row(&world.bodies);
        if !(row.one_sided && row.gap > 0.0) {
            push(world, &row, row.gap);
        }
    }
}

// ANCHOR: solve_contacts
/// Pushes overlaps apart, and takes back what slid meanwhile if friction holds that much.
fn solve_contacts(world: &mut World, before: &Before, pressed: &mut [Real]) {
    for (k, pressed) in pressed.iter_mut().enumerate() {
        let touch = world.contacts.points[k].touch(&world.bodies);
        if touch.gap > 0.0 {
            continue;
        }
        let contact = &world.contacts.points[k];
        let (row, holds) = (contact.row(&touch), contact.holds);
        *pressed += push(world, &row, touch.gap);
        let contact = &world.contacts.points[k];
        let slid = slid(world, contact, &touch, before);
        let length = slid.length();
        if length > 0.0 {
            let (a, b) = ((contact.a, touch.arm_a), (contact.b, touch.arm_b));
            let across = Row::along(a, b, slid / length, 0.0);
            let needed = length / across.inverse_mass(&world.bodies);
            if needed <= holds * *pressed {
                push(world, &across, length);
            }
        }
    }
}

/// How far b's point has slid over a's in this substep, m.
fn slid(world: &World, contact: &Contact, touch: &Touch, before: &Before) -> Vec3 {
    let moved = |row: usize, arm: Vec3| {
        let bodies = &world.bodies;
        let turned_back = before.attitude[row] * (bodies.attitude[row].conjugate() * arm);
        bodies.position[row] + arm - before.position[row] - turned_back
    };
    let way = moved(contact.b, touch.arm_b) - moved(contact.a, touch.arm_a);
    way - touch.normal * way.dot(touch.normal)
}
// ANCHOR_END: solve_contacts

// ANCHOR: read_velocities
/// v = Δx / h, and ω = 2 vec(q q̄∗) / h.
fn read_velocities(world: &mut World, before: &Before, h: Real) {
    let bodies = &mut world.bodies;
    for row in 0..bodies.count() {
        if bodies.moves(row) {
            bodies.velocity[row] = (bodies.position[row] - before.position[row]) / h;
            let turn = bodies.attitude[row] * before.attitude[row].conjugate();
            let sign = if turn.w < 0.0 { -2.0 } else { 2.0 };
            bodies.angular_velocity[row] = Vec3::new(turn.x, turn.y, turn.z) * (sign / h);
        }
    }
}
// ANCHOR_END: read_velocities

// ANCHOR: rub_and_bounce
/// Kinetic friction and restitution of all that was pushed.
fn rub_and_bounce(world: &mut World, before: &Before, pressed: &[Real], h: Real) {
    for (k, &pressed) in pressed
        .iter()
        .enumerate()
        .filter(|(_, pressed)| **pressed > 0.0)
    {
        let contact = world.contacts.points[k];
        let touch = contact.touch(&world.bodies);
        let bodies = &mut world.bodies;
        let sliding = contact.sliding(&touch, bodies);
        let speed = sliding.length();
        let (a, b) = ((contact.a, touch.arm_a), (contact.b, touch.arm_b));
        if speed > 0.0 {
            let across = Row::along(a, b, sliding / speed, 0.0);
            let inverse_mass = across.inverse_mass(bodies);
            let most = contact.kinetic * pressed / h;
            across.press(bodies, -most.min(speed / inverse_mass));
        }
        let along = Row::along(a, b, touch.normal, 0.0);
        let approach = before.approach[k];
        let bounces = approach < -world.restitution_threshold;
        let e = if bounces { contact.restitution } else { 0.0 };
        let wanted = (-e * approach).max(0.0);
        let bodies = &mut world.bodies;
        let missing = wanted - along.speed(bodies);
        along.press(bodies, missing / along.inverse_mass(bodies));
    }
}
// ANCHOR_END: rub_and_bounce
