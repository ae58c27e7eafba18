// ANCHOR: spinning
//! `Spin`: turns the entity.

use super::entity::{Component, Owner};
use crate::styles::formulas;
use crate::styles::items::Item;

// ANCHOR: spin
/// Writes the rotation of the placement.
pub struct Spin {
    turned: f32,
    // ANCHOR: glow
    pub rate: f32,
    // ANCHOR_END: glow
}

impl Component for Spin {
    fn update(&mut self, owner: &mut Owner<'_>, dt: f32) {
        self.turned = formulas::advance(self.turned, self.rate, dt);
        owner.placement.local.rotation = formulas::turn(self.turned);
    }
}
// ANCHOR_END: spin

impl Spin {
    pub fn new(item: &Item) -> Self {
        Self {
            turned: 0.0,
            rate: item.spin,
        }
    }
}
// ANCHOR_END: spinning
