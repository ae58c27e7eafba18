//! `Circle`: the part that moves its owner round its parent.

use crate::styles::formulas;
use crate::styles::items::Item;
use crate::{Component, Transform};

/// Writes its owner's translation.
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
    fn update(&mut self, local: &mut Transform, dt: f32) {
        self.angle = formulas::advance(self.angle, self.rate, dt);
        local.translation = formulas::circle(self.radius, self.angle);
    }
}
