//! The scenarios, a file each: a set-up, its exact answer, what counts as the error, and what a pass is.

use glam::{DQuat, DVec3};

use ch00_scenes::{Body, Scene, Shape};

use super::scenario::Scenario;

pub(super) mod ball_and_chain;
mod bounces;
mod cradle;
mod dzhanibekov;
mod elastic_gas;
pub(super) mod fast_spin;
mod free_top;
pub(super) mod friction_directions;
mod hanging_chain;
mod heavy_top;
pub(super) mod mass_ratio;
mod oblique;
mod pendulum;
mod pile;
mod pushed_box;
mod ragdoll_pile;
pub(super) mod rolling;
mod slip_to_roll;
pub(super) mod spin_kept;
pub(super) mod stack;
pub(super) mod stall;
mod start_up;
mod swings;
pub(super) mod tunnelling;
mod uneven_steps;

/// All of them, in the order of the reference.
pub const SCENARIOS: &[Scenario] = &[
    start_up::SCENARIO,
    uneven_steps::SCENARIO,
    stall::SCENARIO,
    free_top::SCENARIO,
    dzhanibekov::SCENARIO,
    spin_kept::SCENARIO,
    fast_spin::SCENARIO,
    heavy_top::SCENARIO,
    pendulum::SCENARIO,
    pendulum::HIGH,
    hanging_chain::SCENARIO,
    bounces::ELASTIC,
    bounces::INELASTIC,
    slip_to_roll::SCENARIO,
    rolling::SCENARIO,
    pushed_box::SCENARIO,
    friction_directions::SCENARIO,
    oblique::SCENARIO,
    cradle::SCENARIO,
    elastic_gas::SCENARIO,
    pile::SCENARIO,
    stack::SCENARIO,
    mass_ratio::HUNDRED,
    mass_ratio::THOUSAND,
    ball_and_chain::SCENARIO,
    tunnelling::SCENARIO,
    ragdoll_pile::SCENARIO,
    ragdoll_pile::HITCHES,
];

/// m/s².
pub(super) const G: f64 = 9.81;

/// A ball.
fn ball(radius: f64, mass: f64, position: DVec3) -> Body {
    Body::new(Shape::Sphere { radius }, mass, position)
}

/// A box that nothing moves.
fn block(half_extents: DVec3, position: DVec3) -> Body {
    Body::new(Shape::Box { half_extents }, 0.0, position)
}

/// A floor with its top at y = 0.
fn floor(half: f64) -> Body {
    block(DVec3::new(half, 0.5, half), DVec3::new(0.0, -0.5, 0.0))
}

/// Gives all bodies the same e and μ.
fn of_one_stuff(scene: &mut Scene, restitution: f64, friction: f64) {
    for body in &mut scene.bodies {
        body.restitution = restitution;
        body.friction = friction;
    }
}

/// The angle between two attitudes, rad.
fn angle_between(one: DQuat, other: DQuat) -> f64 {
    let turn = one * other.conjugate();
    2.0 * turn.xyz().length().atan2(turn.w.abs())
}

/// How far a number is from the exact one, as a share of it.
fn share(found: f64, exact: f64) -> f64 {
    (found / exact - 1.0).abs()
}
