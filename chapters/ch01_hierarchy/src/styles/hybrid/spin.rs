// ANCHOR: spinning
//! `Spin`: the part that turns its owner.

use crate::styles::formulas;
use crate::styles::items::Item;
use crate::{Component, Transform};

/// Writes its owner's rotation.
pub struct Spin {
    turned: f32,
    rate: f32,
    // ANCHOR: glow
    pub glow: f32,
    // ANCHOR_END: glow
}

impl Spin {
    pub fn new(item: &Item) -> Self {
        Self {
            turned: 0.0,
            rate: item.spin,
            // ANCHOR: glow
            glow: 0.0,
            // ANCHOR_END: glow
        }
    }
}

impl Component for Spin {
    fn update(&mut self, local: &mut Transform, dt: f32) {
        self.turned = formulas::advance(self.turned, self.rate, dt);
        local.rotation = formulas::turn(self.turned);
        // ANCHOR: glow
        self.glow = formulas::follow(self.glow, self.rate, dt);
        // ANCHOR_END: glow
    }
}

// ANCHOR: glow
/// A kind of object that shines.
pub trait Glowing {
    fn glow(&self) -> f32;
}
// ANCHOR_END: glow
// ANCHOR_END: spinning
