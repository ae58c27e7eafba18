//! The angle constraint: a child's orientation stays within limits of its rest in its parent. The
//! section that the report left open (9.4).

use ch00_maths::f32::joint::{Lever, turn_response};
use ch02_rigid_bodies::RigidBody;
use ch03_collision::Span;
use glam::{Quat, Vec3};

use super::limits::{AngleLimits, Bound, MOST_ROWS, Row};
use super::pin::PinConstraint;
use super::{LARGEST_TURN, SMALL_ANGLE};

// ANCHOR: angle
/// Limits on how the child has turned away from its rest.
pub struct AngleConstraint {
    /// j: the child's orientation in the parent at rest.
    rest: Quat,
    limits: AngleLimits,
    rows: [LimitedTurn; MOST_ROWS],
}

/// A row while contacts are resolved, and what it keeps from step to step.
#[derive(Clone, Copy)]
struct LimitedTurn {
    row: Row,
    lever: Lever,
    /// Largest rate against the axis, rad/s, at which the limit isn't passed in the next step.
    slack: f32,
    /// The angular impulse by which it has been nudged in this step, kg m².
    nudged: f32,
    /// What held it in the last step, N m s.
    impulse: f32,
    /// How far beyond the limit the last step left it, rad; 0 or less where that is one-sided.
    left: f32,
}
// ANCHOR_END: angle

impl AngleConstraint {
    /// Limits about the rest orientation j.
    #[must_use]
    pub fn new(rest: Quat, limits: AngleLimits) -> Self {
        let turn = LimitedTurn {
            row: Row::FREE,
            lever: Lever::default(),
            slack: 0.0,
            nudged: 0.0,
            impulse: 0.0,
            left: 0.0,
        };
        Self {
            rest,
            limits,
            rows: [turn; MOST_ROWS],
        }
    }

    /// j.
    #[must_use]
    pub fn rest(&self) -> Quat {
        self.rest
    }

    /// How far the child may turn from it.
    #[must_use]
    pub fn limits(&self) -> &AngleLimits {
        &self.limits
    }

    /// The rows where the bodies are now.
    #[must_use]
    pub fn rows(&self, parent: &RigidBody, child: &RigidBody) -> [Row; MOST_ROWS] {
        self.limits
            .rows(parent.orientation(), self.rest, child.orientation())
    }

    // ANCHOR: correct
    /// Turns the two back to their limits where they have passed them since the last step. Says
    /// whether they had.
    pub fn correct(
        &self,
        pin: &PinConstraint,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) -> bool {
        let mut moved = false;
        for (turn, row) in self.rows.iter().zip(self.rows(parent, child)) {
            let beyond = row.missing(row.room - turn.left);
            if beyond.abs() < SMALL_ANGLE {
                continue;
            }
            let lever = pin.lever(parent, child, row.axis);
            pin.displace_turn(&lever, beyond / lever.response, parent, child);
            moved = true;
        }
        moved
    }
    // ANCHOR_END: correct

    /// The same with the report's first-order turn. The report has no formula for this constraint.
    pub fn correct_printed(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        for row in self.rows(parent, child) {
            let beyond = row.missing(row.room);
            if beyond != 0.0 {
                let (mass_1, mass_2) = (*parent.answers(), *child.answers());
                let impulse = row.axis * (beyond / turn_response(&mass_1, &mass_2, row.axis));
                child.displace_printed(Vec3::ZERO, mass_2.moment(impulse));
                parent.displace_printed(Vec3::ZERO, mass_1.moment(-impulse));
            }
        }
    }

    // ANCHOR: prepare
    /// Works out what stays the same while contacts are resolved.
    pub fn prepare(
        &mut self,
        pin: &PinConstraint,
        parent: &RigidBody,
        child: &RigidBody,
        span: Span,
    ) {
        let rows = self.rows(parent, child);
        for (turn, row) in self.rows.iter_mut().zip(rows) {
            turn.impulse *= if turn.row.bound == row.bound {
                span.longer
            } else {
                0.0
            };
            turn.row = row;
            turn.nudged = 0.0;
            if row.bound != Bound::Free {
                turn.lever = pin.lever(parent, child, row.axis);
                turn.slack = row.room.max(0.0) / span.dt;
            }
        }
    }
    // ANCHOR_END: prepare

    // ANCHOR: part
    /// Nudges the two back to their limits, or takes back what others have made superfluous. Gives how
    /// far, as the way of a limb of a decimetre, m.
    pub fn part(
        &mut self,
        pin: &PinConstraint,
        parent: &mut RigidBody,
        child: &mut RigidBody,
    ) -> f32 {
        let (q1, q2) = (parent.nudged_pose().1, child.nudged_pose().1);
        let mut furthest = 0.0_f32;
        for (turn, row) in self
            .rows
            .iter_mut()
            .zip(self.limits.rows(q1, self.rest, q2))
        {
            if row.bound == Bound::Free || row.bound != turn.row.bound {
                continue;
            }
            let lever = pin.lever(parent, child, row.axis);
            let beyond = -row.room.clamp(-LARGEST_TURN, LARGEST_TURN);
            let nudged = row.bound.accumulated(turn.nudged, beyond / lever.response);
            let change = nudged - turn.nudged;
            let turned = (change * lever.response).abs();
            if turned >= SMALL_ANGLE {
                turn.nudged = nudged;
                pin.nudge_turn(&lever, change, parent, child);
                furthest = furthest.max(0.1 * turned);
            }
        }
        furthest
    }
    // ANCHOR_END: part

    /// Begins with what held them in the last step. The pin's own impulse remembers its share.
    pub fn resume(&self, parent: &mut RigidBody, child: &mut RigidBody) {
        for turn in self.rows.iter().filter(|turn| turn.impulse != 0.0) {
            child.twist(turn.impulse * turn.row.axis);
            parent.twist(-turn.impulse * turn.row.axis);
        }
    }

    // ANCHOR: hold
    /// Keeps the two from turning past a limit within the next step. Says whether a rate was off by
    /// more than ten times `still`, rad/s: on a limb of a decimetre that is `still`, m/s.
    pub fn hold(
        &mut self,
        pin: &mut PinConstraint,
        parent: &mut RigidBody,
        child: &mut RigidBody,
        still: f32,
    ) -> bool {
        let mut off = false;
        for turn in self.rows.iter_mut().filter(|turn| turn.is_bounded()) {
            let axis = turn.row.axis;
            let rate = axis.dot(child.moving().omega - parent.moving().omega);
            let bound = turn.row.bound;
            let impulse = bound.held(turn.impulse, rate, turn.slack, turn.lever.response);
            let change = impulse - turn.impulse;
            turn.impulse = impulse;
            if change != 0.0 {
                pin.turn(&turn.lever, change, parent, child);
                off |= (change * turn.lever.response).abs() > 10.0 * still;
            }
        }
        off
    }
    // ANCHOR_END: hold

    /// Forgets the impulses of the last step.
    pub fn forget(&mut self) {
        for turn in &mut self.rows {
            turn.impulse = 0.0;
        }
    }

    /// Notes how far beyond their limits they are left.
    pub fn finish(&mut self, parent: &RigidBody, child: &RigidBody) {
        let rows = self.rows(parent, child);
        for (turn, row) in self.rows.iter_mut().zip(rows) {
            turn.left = -row.missing(row.room);
        }
    }
}

impl LimitedTurn {
    /// Whether there is such a limit.
    fn is_bounded(&self) -> bool {
        self.row.bound != Bound::Free
    }
}
