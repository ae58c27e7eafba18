//! The systems with their columns handed over: what the list in `plan/systems.rs` calls. This file alone
//! knows both the container and the functions.

use ch03_collision::Span;

use super::World;
use crate::plan::Part;
use crate::systems::joints::{Assembly, Jointed, NoJoints, Poses};
use crate::systems::resolving::{gliding, rolling, turning};
use crate::systems::{
    Pull, advance, broad_phase, contacts, narrow_phase, printed, resolving, visits,
};

/// The joints' tables out of the container.
macro_rules! assembly {
    ($data:expr) => {
        Assembly {
            joints: &mut $data.joints,
            pins: &mut $data.pins,
            rods: &mut $data.rods,
            limits: &$data.limits,
            turns: &mut $data.turns,
        }
    };
}

// ANCHOR: with_movers
/// Does the same with the columns that this plan's bodies move in: with turns about any axes, and then
/// with the joints, if there are any; with turns of balls; or without turns.
macro_rules! with_movers {
    ($world:expr, |$movers:ident, $joints:ident| $work:expr) => {{
        let (bodies, motions) = (&$world.data.bodies, &mut $world.data.motions);
        if $world.plan.has(Part::Axes) {
            let $movers = &mut turning(bodies, motions);
            let $joints = &mut Jointed {
                assembly: assembly!($world.data),
                position: &bodies.position,
                orientation: &bodies.orientation,
            };
            $work
        } else if $world.plan.has(Part::Round) {
            let ($movers, $joints) = (&mut rolling(bodies, motions), &mut NoJoints);
            $work
        } else {
            let ($movers, $joints) = (&mut gliding(bodies, motions), &mut NoJoints);
            $work
        }
    }};
    ($world:expr, |$movers:ident| $work:expr) => {{
        let (bodies, motions) = (&$world.data.bodies, &mut $world.data.motions);
        if $world.plan.has(Part::Axes) {
            let $movers = &mut turning(bodies, motions);
            $work
        } else if $world.plan.has(Part::Round) {
            let $movers = &mut rolling(bodies, motions);
            $work
        } else {
            let $movers = &mut gliding(bodies, motions);
            $work
        }
    }};
}
// ANCHOR_END: with_movers

impl World {
    // ANCHOR: advance
    pub(crate) fn advance_positions(&mut self) {
        for &row in &self.involved {
            resolving::let_go(&mut self.data.bodies, row as usize);
        }
        let (step, gravity) = (self.step_now(), self.gravity());
        let system = if self.plan.has(Part::Printed) {
            advance::positions_printed
        } else {
            advance::positions
        };
        let bodies = &mut self.data.bodies;
        let pull = Pull::of(gravity, &bodies.acceleration);
        system(
            &mut bodies.position,
            &mut bodies.last_position,
            &bodies.inverse_mass,
            pull,
            step,
        );
    }
    // ANCHOR_END: advance

    pub(crate) fn advance_orientations(&mut self) {
        let step = self.step_now();
        let bodies = &mut self.data.bodies;
        if self.plan.has(Part::Printed) {
            advance::orientations_printed(
                &mut bodies.orientation,
                &mut bodies.last_orientation,
                &bodies.inverse_inertia,
                &bodies.torque,
                &bodies.inverse_mass,
                step,
            );
        } else {
            self.counts.unread_turns += advance::orientations(
                &mut bodies.orientation,
                &mut bodies.last_orientation,
                &bodies.inertia,
                &bodies.inverse_inertia,
                &bodies.torque,
                &bodies.inverse_mass,
                step,
            );
        }
    }

    pub(crate) fn correct_joints(&mut self) {
        let sweeps = self.surroundings.rules.sweeps;
        let as_printed = self.plan.has(Part::Printed);
        let every = self.plan.has(Part::IdleVisits);
        let data = &mut self.data;
        let bodies = &mut data.bodies;
        let mut poses = Poses {
            position: &mut bodies.position,
            orientation: &mut bodies.orientation,
            inverse_mass: &bodies.inverse_mass,
            inverse_moments: &bodies.inverse_inertia,
            inverse_inertia: &mut data.motions.inverse_inertia,
            changed: &mut data.motions.changed,
        };
        if as_printed {
            assembly!(data).correct_printed(&mut poses);
        } else {
            assembly!(data).correct(&data.trees, &mut poses, sweeps, every);
        }
    }

    // ANCHOR: phases
    pub(crate) fn broad_phase(&mut self) {
        let margins = self.margins();
        let (bodies, fixed) = (&self.data.bodies, &self.data.fixed_points.body);
        let each_step = self.plan.has(Part::Obstacles);
        broad_phase::boxes(bodies, fixed, margins, each_step, &mut self.broad);
        broad_phase::pairs(&bodies.inverse_mass, &mut self.broad);
    }

    pub(crate) fn narrow_phase(&mut self) {
        let margins = self.margins();
        let (bodies, contacts) = (&self.data.bodies, &mut self.data.contacts);
        let carries = self.plan.has(Part::Corrected);
        if carries {
            narrow_phase::carry(contacts, &mut self.carried);
        }
        let unsure = narrow_phase::find(bodies, &self.broad.pairs, margins, contacts);
        if carries {
            narrow_phase::remember(contacts, &self.carried);
        }
        self.counts.unsure_touches += unsure;
    }
    // ANCHOR_END: phases

    pub(crate) fn list_touches(&mut self) {
        visits::list(&self.data.contacts, &mut self.data.touches);
    }

    pub(crate) fn resolve_printed(&mut self) {
        let dt_last = self.steps.dt_last;
        printed::resolve(&mut self.data.bodies, &mut self.data.contacts, dt_last);
    }

    pub(crate) fn read_velocities(&mut self) {
        self.steps.span = self.next_span();
        let data = &mut self.data;
        resolving::involved(
            data.bodies.position.len(),
            &data.contacts,
            &data.joints,
            &mut self.involved,
        );
        let involved = std::mem::take(&mut self.involved);
        for row in involved.iter().map(|&row| row as usize) {
            let velocity = self.velocity(row);
            self.data.motions.velocity[row] = velocity.v;
            if let Some(spin) = self.data.motions.spin.get_mut(row) {
                *spin = velocity.omega;
            }
        }
        resolving::weigh(&involved, &self.data.bodies, &mut self.data.motions);
        self.involved = involved;
    }

    /// The step that runs now, beside the last one.
    fn next_span(&mut self) -> Span {
        let dt = self.steps.dt;
        let longer = if self.steps.resolved > 0.0 {
            dt / self.steps.resolved
        } else {
            1.0
        };
        self.steps.resolved = dt;
        Span { dt, longer }
    }

    pub(crate) fn prepare_contacts(&mut self) {
        let (rules, span) = (self.surroundings.rules, self.steps.span);
        let gravity = self.gravity();
        with_movers!(self, |movers| {
            let (bodies, contacts) = (&self.data.bodies, &mut self.data.contacts);
            let pull = Pull::of(gravity, &bodies.acceleration);
            contacts::prepare(contacts, bodies, movers, pull, rules, span);
        });
    }

    pub(crate) fn prepare_joints(&mut self) {
        let (span, dt_last) = (self.steps.span, self.steps.dt_last);
        let data = &mut self.data;
        let movers = turning(&data.bodies, &mut data.motions);
        assembly!(data).prepare(&data.bodies, &movers, dt_last, span);
    }

    // ANCHOR: push_apart
    pub(crate) fn push_apart(&mut self) {
        let (rules, every) = (self.surroundings.rules, self.plan.has(Part::IdleVisits));
        with_movers!(self, |movers, joints| {
            let (contacts, touches) = (&mut self.data.contacts, &mut self.data.touches);
            let involved = &self.involved;
            resolving::push_apart(contacts, touches, movers, joints, involved, rules, every);
        });
    }
    // ANCHOR_END: push_apart

    pub(crate) fn pay_for_lifts(&mut self) {
        with_movers!(self, |movers| {
            resolving::pay_for_lifts(&self.data.contacts, &self.data.touches, movers);
        });
    }

    pub(crate) fn bounce(&mut self) {
        let (rules, every) = (self.surroundings.rules, self.plan.has(Part::IdleVisits));
        with_movers!(self, |movers| {
            let (contacts, touches) = (&mut self.data.contacts, &mut self.data.touches);
            self.counts.impacts_left +=
                resolving::bounce(contacts, touches, movers, &self.involved, rules, every);
        });
    }

    // ANCHOR: rest
    pub(crate) fn rest(&mut self) {
        let (rules, every) = (self.surroundings.rules, self.plan.has(Part::IdleVisits));
        let (gravity, dt_last) = (self.gravity(), self.steps.dt_last);
        let (bodies, motions) = (&mut self.data.bodies, &mut self.data.motions);
        resolving::begin_resting(&self.involved, bodies, motions, gravity, dt_last);
        with_movers!(self, |movers, joints| {
            let (contacts, touches) = (&mut self.data.contacts, &mut self.data.touches);
            let involved = &self.involved;
            resolving::rest(contacts, touches, movers, joints, involved, rules, every);
        });
    }
    // ANCHOR_END: rest

    /// Notes how far joints are from where they belong.
    pub(crate) fn finish_joints(&mut self) {
        let data = &mut self.data;
        assembly!(data).finish(&data.bodies);
    }

    /// Forgets what joints carried in the last step, and notes how far they are off.
    pub(crate) fn begin_joints_anew(&mut self) {
        let data = &mut self.data;
        assembly!(data).forget();
        self.finish_joints();
    }

    pub(crate) fn place_bodies(&mut self) {
        let (gravity, dt_last) = (self.gravity(), self.steps.dt_last);
        let involved = std::mem::take(&mut self.involved);
        let (bodies, motions) = (&mut self.data.bodies, &mut self.data.motions);
        resolving::displace(&involved, bodies, motions, gravity, dt_last);
        for row in involved.iter().map(|&row| row as usize) {
            let velocity = resolving::resolved(&self.data.motions, row);
            self.set_velocity(row, velocity);
        }
        self.involved = involved;
    }
}
