//! The worst overlap, the worst joint and the most escapes of a run without a window.

use ch00_scenes::measures::{Measures, Penetration, escaped};

use crate::history::larger;
use crate::session::Session;

/// Bodies up to which overlaps are measured after every step; beyond, after every second
/// step for twice as many, and so on. Measured on falling balls, finding their overlaps takes
/// about 1 ms a thousand, less than a step with collisions. The interval follows from the
/// scene and not from time, so that two runs measure the same steps.
pub const BODIES_COMPARED_A_STEP: usize = 5000;

/// What was measured of a run so far, the start included.
pub(crate) struct Worst {
    every: u64,
    /// Of the last state that was measured: at the end, of the last step.
    pub(crate) last: Measures,
    /// Deepest overlap so far, m.
    pub(crate) penetration: Option<f64>,
    /// Widest joint so far, m.
    pub(crate) joint_separation: Option<f64>,
    /// Most bodies that were outside at once, after any step.
    pub(crate) escaped: Option<usize>,
}

impl Worst {
    /// Measures the state before the first step.
    pub(crate) fn at_start(session: &Session) -> Self {
        let bodies = session.scene().bodies.len();
        let start = Measures::of(session.scene(), session.state_now());
        Self {
            every: bodies.div_ceil(BODIES_COMPARED_A_STEP).max(1) as u64,
            last: start,
            penetration: deepest(&start.penetration),
            joint_separation: start.joint_separation,
            escaped: start.escaped,
        }
    }

    /// Measures the state now, if it is its turn or the last; escapes, which cost next to nothing, in
    /// any case.
    pub(crate) fn measure(&mut self, session: &Session, last: u32) {
        let outside = escaped(session.scene(), session.state_now());
        self.escaped = self.escaped.max(outside);
        let step = session.steps();
        if !step.is_multiple_of(self.every) && step != u64::from(last) {
            return;
        }
        self.last = Measures::of(session.scene(), session.state_now());
        self.penetration = match (self.penetration, deepest(&self.last.penetration)) {
            (Some(before), Some(now)) => Some(before.max(now)),
            _ => None,
        };
        self.joint_separation = larger(self.joint_separation, self.last.joint_separation);
    }
}

/// The deepest overlap, m; none if there are pairs of which it isn't known.
pub(crate) fn deepest(penetration: &Penetration) -> Option<f64> {
    (penetration.pairs_not_measured == 0).then_some(penetration.deepest)
}
