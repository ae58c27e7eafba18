//! `Orbiter`: circles its parent.

use super::scene_object::{Base, SceneObject};
use crate::Transform;
use crate::styles::formulas;
use crate::styles::items::Item;

// ANCHOR: orbiter
/// Extends the base class by a circle.
pub struct Orbiter {
    base: Base,
    radius: f32,
    angle: f32,
    rate: f32,
}

impl Orbiter {
    pub fn new(id: usize, item: &Item) -> Self {
        let place = formulas::circle(item.radius, item.phase);
        Self {
            base: Base::new(id, Transform::from_translation(place)),
            radius: item.radius,
            angle: item.phase,
            rate: item.rate,
        }
    }
}

impl SceneObject for Orbiter {
    fn base(&self) -> &Base {
        &self.base
    }

    fn base_mut(&mut self) -> &mut Base {
        &mut self.base
    }

    fn advance(&mut self, dt: f32) {
        self.angle = formulas::advance(self.angle, self.rate, dt);
        self.base.local.translation = formulas::circle(self.radius, self.angle);
    }
}
// ANCHOR_END: orbiter
