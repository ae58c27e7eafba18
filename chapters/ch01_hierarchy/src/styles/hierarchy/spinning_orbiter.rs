// ANCHOR: spinning
//! `SpinningOrbiter`: circles and spins. It can extend one class only; the other one's
//! fields and lines are written again.

use super::orbiter::Orbiter;
use super::scene_object::{Base, SceneObject};
use crate::styles::formulas;
use crate::styles::items::Item;

// ANCHOR: diamond
/// Extends `Orbiter`, and repeats what `Spinner` says.
pub struct SpinningOrbiter {
    orbiter: Orbiter,
    turned: f32,
    spin: f32,
    // ANCHOR: glow
    glow: f32,
    // ANCHOR_END: glow
}

impl SceneObject for SpinningOrbiter {
    fn base(&self) -> &Base {
        self.orbiter.base()
    }

    fn base_mut(&mut self) -> &mut Base {
        self.orbiter.base_mut()
    }

    fn advance(&mut self, dt: f32) {
        self.orbiter.advance(dt);
        self.turned = formulas::advance(self.turned, self.spin, dt);
        self.base_mut().local.rotation = formulas::turn(self.turned);
        // ANCHOR: glow
        self.glow = formulas::follow(self.glow, self.spin, dt);
        // ANCHOR_END: glow
    }

    // ANCHOR: glow
    fn glow(&self) -> f32 {
        self.glow
    }
    // ANCHOR_END: glow
}
// ANCHOR_END: diamond

impl SpinningOrbiter {
    pub fn new(id: usize, item: &Item) -> Self {
        Self {
            orbiter: Orbiter::new(id, item),
            turned: 0.0,
            spin: item.spin,
            // ANCHOR: glow
            glow: 0.0,
            // ANCHOR_END: glow
        }
    }
}
// ANCHOR_END: spinning
