//! `Circle`: moves the entity round its parent.

use super::entity::{Component, Owner};
use crate::styles::formulas;
use crate::styles::items::Item;

/// Writes the translation of the placement.
pub struct Circle {
    radius: f32,
    angle: f32,
    rate: f32,
}

impl Circle {
    pub fn new(item: &Item) -> Self {
        Self {
            radius: item.radius,
            angle: item.phase,
            rate: item.rate,
        }
    }
}

impl Component for Circle {
    fn update(&mut self, owner: &mut Owner<'_>, dt: f32) {
        self.angle = formulas::advance(self.angle, self.rate, dt);
        owner.placement.local.translation = formulas::circle(self.radius, self.angle);
    }
}
