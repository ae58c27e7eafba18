//! What pairs of bodies that sleep pressed when they fell asleep.

use crate::lanes::pairs::Pairs;
use crate::rows::{Impulse, Manifold};
use crate::simd::Real;

/// A pair that nobody looks at while its bodies sleep.
#[derive(Clone, Copy, Debug)]
pub struct KeptPair {
    /// Rows of the two bodies, the smaller first.
    pub bodies: (usize, usize),
    /// Where they touch.
    pub manifold: Manifold,
    /// What they press and rub.
    pub impulse: Impulse,
}

impl KeptPair {
    /// Of a pair of the step.
    #[must_use]
    pub fn of<R: Real>(pairs: &Pairs<R>, pair: usize) -> Self {
        Self {
            bodies: pairs.bodies[pair],
            manifold: pairs.manifold[pair],
            impulse: pairs.impulse[pair],
        }
    }

    /// Whether a body is one of the two.
    #[must_use]
    pub fn has(&self, row: usize) -> bool {
        self.bodies.0 == row || self.bodies.1 == row
    }
}

/// A body is gone, its pairs with it, and those after it have moved up.
pub fn remove_body(kept: &mut Vec<KeptPair>, row: usize) {
    kept.retain(|pair| !pair.has(row));
    let moved = |other: usize| if other > row { other - 1 } else { other };
    for pair in kept {
        pair.bodies = (moved(pair.bodies.0), moved(pair.bodies.1));
    }
}
