//! The methods by name.

use ch00_scenes::Method;

use super::world::Step;
use super::{
    constant_spin, direct_joints, explicit_gyro, implicit_gyro, runge_kutta, sequential_impulses,
    soft_step, splitting, xpbd,
};

/// A method, as the list has it.
#[derive(Clone, Copy, Debug)]
pub struct Listed {
    /// Name and sentence.
    pub method: Method,
    /// What it does.
    pub step: Step,
    /// Parts of a step, unless one says otherwise.
    pub substeps: u32,
    /// Sweeps of a substep; None where there are none to choose.
    pub sweeps: Option<u32>,
    /// Whether it knows contacts and joints.
    pub touches: bool,
}

/// All of them.
pub const LIST: [Listed; 9] = [
    solver(
        "sequential-impulses",
        "sequential impulses with warm starting and Baumgarte's stabilisation, ten sweeps a step",
        sequential_impulses::step,
        1,
        10,
    ),
    solver(
        "soft-step",
        "substeps with soft rows, then a sweep that relaxes them (Catto 2024)",
        soft_step::step,
        4,
        1,
    ),
    solver(
        "xpbd",
        "extended position-based dynamics in small steps (Müller 2020)",
        xpbd::step,
        20,
        1,
    ),
    solver(
        "direct-joints",
        "all joints at once by Cholesky's factors, contacts by sweeps in between",
        direct_joints::step,
        8,
        2,
    ),
    alone(
        "constant-spin",
        "semi-implicit Euler without a gyroscopic torque",
        constant_spin::step,
    ),
    alone(
        "explicit-gyro",
        "semi-implicit Euler with the gyroscopic torque of the present",
        explicit_gyro::step,
    ),
    alone(
        "implicit-gyro",
        "semi-implicit Euler with one Newton step for the gyroscopic torque to come",
        implicit_gyro::step,
    ),
    alone(
        "splitting",
        "half a kick, free rotation by splitting, half a kick",
        splitting::step,
    ),
    alone(
        "runge-kutta",
        "the classic fourth-order method in attitude and angular momentum",
        runge_kutta::step,
    ),
];

/// Their names and sentences, the default first.
pub const METHODS: [Method; 9] = {
    let mut methods = [LIST[0].method; 9];
    let mut k = 0;
    while k < LIST.len() {
        methods[k] = LIST[k].method;
        k += 1;
    }
    methods
};

const fn solver(
    name: &'static str,
    about: &'static str,
    step: Step,
    substeps: u32,
    sweeps: u32,
) -> Listed {
    Listed {
        method: Method { name, about },
        step,
        substeps,
        sweeps: Some(sweeps),
        touches: true,
    }
}

const fn alone(name: &'static str, about: &'static str, step: Step) -> Listed {
    Listed {
        method: Method { name, about },
        step,
        substeps: 1,
        sweeps: None,
        touches: false,
    }
}
