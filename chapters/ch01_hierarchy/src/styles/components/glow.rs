// ANCHOR: glow
//! `Glow`: shines the brighter, the faster its entity spins.

use super::entity::{Component, Owner};
use super::spin::Spin;
use crate::styles::formulas;

// ANCHOR: part
/// Reads the rate of [`Spin`], if its entity has one.
#[derive(Default)]
pub struct Glow {
    pub value: f32,
}

impl Component for Glow {
    fn update(&mut self, owner: &mut Owner<'_>, dt: f32) {
        if let Some(spin) = owner.sibling::<Spin>() {
            self.value = formulas::follow(self.value, spin.rate, dt);
        }
    }
}
// ANCHOR_END: part
// ANCHOR_END: glow
