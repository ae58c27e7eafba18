//! All joints at once: the rows of all joints are one system of equations, A λ = b with A = J M⁻¹ Jᵀ, solved
//! by Cholesky's factors, so that a chain of any length has nothing to converge. Contacts and limits, which
//! may let go, are swept in between. Dense, to be read: chapter 6 solves the same along the tree, in a
//! time that grows with the number of joints and not with its cube.

use super::constant_spin;
use super::real::{Real, free_rotation, rotation};
use super::row::Row;
use super::sequential_impulses::{
    Ready, approaches, press_contacts_again, solve_contacts, touches,
};
use super::world::{Knobs, World};

/// Share of a gap that is mended in a substep: all of it, since nothing is left over from sweeps.
const MENDED: Real = 1.0;
/// Of the largest diagonal element: so much is added to all, so that rows that say the same are no harm.
const SOFT: Real = 1e-9;

// ANCHOR: step
/// A step.
pub fn step(world: &mut World, dt: Real, knobs: Knobs) {
    world.contacts.find(&world.bodies, world.gravity, dt);
    let h = dt / Real::from(knobs.substeps as u16);
    for _ in 0..knobs.substeps {
        let approaches = approaches(world);
        world.accelerate(h, constant_spin::spun);
        let touches = touches(world, &approaches, h);
        press_contacts_again(world, &touches);
        let limits = limits(world, h);
        let (rows, factors) = factored(world);
        for _ in 0..knobs.sweeps {
            solve_contacts(world, &touches);
            solve_limits(world, &limits);
            solve_joints(world, &rows, &factors, h);
        }
        fly(world, h);
    }
}
// ANCHOR_END: step

// ANCHOR: fly
/// Everything moves on, and turns as in free space: angular momenta stay, spins don't.
fn fly(world: &mut World, h: Real) {
    let bodies = &mut world.bodies;
    for row in 0..bodies.count() {
        if bodies.moves(row) {
            bodies.position[row] += bodies.velocity[row] * h;
            let (q, inertia) = (bodies.attitude[row], bodies.inertia[row]);
            let momentum = bodies.angular_momentum(row);
            let turned = free_rotation::attitude_after(q, inertia, momentum, h);
            bodies.attitude[row] = turned;
            bodies.angular_velocity[row] =
                rotation::moment(turned, bodies.inverse_inertia[row], momentum);
        }
    }
}
// ANCHOR_END: fly

/// Limits that are reached or may be in the substep, afresh: they begin with nothing.
fn limits(world: &World, h: Real) -> Vec<Ready> {
    let rows = world.joints.iter().map(|joint| joint.row(&world.bodies));
    let ready = |row: Row| {
        let part = if row.gap > 0.0 { 1.0 } else { MENDED };
        Ready::of(world, row, -part * row.gap / h)
    };
    rows.filter(|row| row.one_sided).map(ready).collect()
}

fn solve_limits(world: &mut World, limits: &[Ready]) {
    for ready in limits {
        let missing = ready.target - ready.row.speed(&world.bodies);
        ready
            .row
            .press(&mut world.bodies, (missing * ready.mass).max(0.0));
    }
}

// ANCHOR: system
/// The rows that always hold, and Cholesky's factor of their system: a lower triangle, row by row.
fn factored(world: &World) -> (Vec<Row>, Vec<Vec<Real>>) {
    let rows = world.joints.iter().map(|joint| joint.row(&world.bodies));
    let rows: Vec<Row> = rows.filter(|row| !row.one_sided).collect();
    let element = |i: usize, j: usize| coupling(world, &rows[i], &rows[j]);
    let mut lower: Vec<Vec<Real>> = (0..rows.len())
        .map(|i| (0..=i).map(|j| element(i, j)).collect())
        .collect();
    let largest = lower.iter().enumerate().map(|(i, row)| row[i]);
    let soft = SOFT * largest.fold(0.0, Real::max);
    for i in 0..lower.len() {
        lower[i][i] += soft;
        for j in 0..=i {
            let known: Real = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = lower[i][j] - known;
            lower[i][j] = if i == j {
                rest.max(soft).sqrt()
            } else {
                rest / lower[j][j]
            };
        }
    }
    (rows, lower)
}

/// How fast the gap of one row grows a unit of impulse of another.
fn coupling(world: &World, one: &Row, other: &Row) -> Real {
    let bodies = &world.bodies;
    let sides = |row: &Row| [(row.a, row.angular_a, -1.0), (row.b, row.angular_b, 1.0)];
    let mut sum = 0.0;
    for (body, turning, sign) in sides(one) {
        for (other_body, other_turning, other_sign) in sides(other) {
            if body == other_body {
                let along = one.linear.dot(other.linear) * bodies.inverse_mass[body];
                let about: Real = turning.dot(bodies.turned_by(body, other_turning));
                let product: Real = sign * other_sign;
                sum += product * (along + about);
            }
        }
    }
    sum
}

/// All joints get the speeds that mend their gaps, in one go.
fn solve_joints(world: &mut World, rows: &[Row], lower: &[Vec<Real>], h: Real) {
    let missing = |row: &Row| -MENDED * row.gap / h - row.speed(&world.bodies);
    let mut impulses: Vec<Real> = rows.iter().map(missing).collect();
    for i in 0..rows.len() {
        let known: Real = (0..i).map(|k| lower[i][k] * impulses[k]).sum();
        impulses[i] = (impulses[i] - known) / lower[i][i];
    }
    for i in (0..rows.len()).rev() {
        let known: Real = (i + 1..rows.len()).map(|k| lower[k][i] * impulses[k]).sum();
        impulses[i] = (impulses[i] - known) / lower[i][i];
    }
    for (row, impulse) in rows.iter().zip(impulses) {
        row.press(&mut world.bodies, impulse);
    }
}
// ANCHOR_END: system
