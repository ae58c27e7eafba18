// ANCHOR: spinning
//! `Spinner`: stays in its place and turns.

use super::scene_object::{Base, SceneObject};
use crate::Transform;
use crate::styles::formulas;
use crate::styles::items::Item;

/// Extends the base class by a spin.
pub struct Spinner {
    base: Base,
    turned: f32,
    spin: f32,
    // ANCHOR: glow
    glow: f32,
    // ANCHOR_END: glow
}

impl Spinner {
    pub fn new(id: usize, item: &Item) -> Self {
        let place = formulas::circle(item.radius, item.phase);
        Self {
            base: Base::new(id, Transform::from_translation(place)),
            turned: 0.0,
            spin: item.spin,
            // ANCHOR: glow
            glow: 0.0,
            // ANCHOR_END: glow
        }
    }
}

impl SceneObject for Spinner {
    fn base(&self) -> &Base {
        &self.base
    }

    fn base_mut(&mut self) -> &mut Base {
        &mut self.base
    }

    fn advance(&mut self, dt: f32) {
        self.turned = formulas::advance(self.turned, self.spin, dt);
        self.base.local.rotation = formulas::turn(self.turned);
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
// ANCHOR_END: spinning
