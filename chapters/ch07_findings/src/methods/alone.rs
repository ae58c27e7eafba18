//! A body alone: nothing touches it and no joint holds it, but it may turn about a fixed point. This is where
//! methods of integration differ.

use super::real::{Quat, Real, Vec3, inertia};
use super::world::{Knobs, World};

/// A body alone, and what acts on it.
#[derive(Clone, Copy, Debug)]
pub struct Alone {
    /// Of the centre, m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
    /// Body to world.
    pub attitude: Quat,
    /// rad/s, world.
    pub angular_velocity: Vec3,
    /// About the centre, or the fixed point; body axes, kg m².
    pub inertia: Vec3,
    /// And constant forces, m/s².
    pub gravity: Vec3,
    /// m g r: weight times the way from the fixed point to the centre, in the body, N m; 0 where there is none.
    pub heavy_arm: Vec3,
}

impl Alone {
    /// The torque of its weight about the fixed point, N m, if its attitude were q.
    #[must_use]
    pub fn torque(&self, q: Quat) -> Vec3 {
        (q * self.heavy_arm).cross(self.gravity)
    }
}

/// Why a body can't be alone.
pub const OFF_AXIS: &str = "a body on a fixed point that lies on none of its axes";

/// Whether a body on a fixed point turns about its own axes.
#[must_use]
pub fn has_axes(moments: Vec3, mass: Real, arm: Vec3) -> bool {
    inertia::about_point(moments, mass, arm).is_some()
}

// ANCHOR: each_alone
/// Moves every body by itself, a substep at a time.
pub fn each_alone(world: &mut World, dt: Real, knobs: Knobs, moved: fn(Alone, Real) -> Alone) {
    let h = dt / Real::from(knobs.substeps as u16);
    for row in 0..world.bodies.count() {
        if world.bodies.moves(row) {
            let mut body = alone(world, row);
            for _ in 0..knobs.substeps {
                body = moved(body, h);
            }
            put_back(world, row, &body);
        }
    }
}
// ANCHOR_END: each_alone

fn alone(world: &World, row: usize) -> Alone {
    let bodies = &world.bodies;
    let mass = 1.0 / bodies.inverse_mass[row];
    let arm = world.pivots.iter().find(|pivot| pivot.body == row);
    let arm = arm.map_or(Vec3::ZERO, |pivot| pivot.arm);
    let moments = bodies.inertia[row];
    let pushes = world.pushes.iter().filter(|push| push.0 == row);
    let pushed = pushes.fold(Vec3::ZERO, |sum, push| sum + push.1);
    Alone {
        position: bodies.position[row],
        velocity: bodies.velocity[row],
        attitude: bodies.attitude[row],
        angular_velocity: bodies.angular_velocity[row],
        inertia: inertia::about_point(moments, mass, arm).unwrap_or(moments),
        gravity: world.gravity + pushed,
        heavy_arm: arm * mass,
    }
}

fn put_back(world: &mut World, row: usize, body: &Alone) {
    let pivot = world.pivots.iter().find(|pivot| pivot.body == row);
    let (mut position, mut velocity) = (body.position, body.velocity);
    if let Some(pivot) = pivot {
        let arm = body.attitude * pivot.arm;
        (position, velocity) = (pivot.point + arm, body.angular_velocity.cross(arm));
    }
    let bodies = &mut world.bodies;
    bodies.position[row] = position;
    bodies.velocity[row] = velocity;
    bodies.attitude[row] = body.attitude;
    bodies.angular_velocity[row] = body.angular_velocity;
}
