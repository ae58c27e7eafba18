//! Who has come to rest: who stays where he is for some time.

use glam::{Quat, Vec3};

use crate::bodies::Bodies;
use crate::norm::Norm;
use crate::rules::MARGIN;

/// Who rests comes no farther than this, m, …
pub const DISTANCE: f32 = 5.0 * MARGIN;

/// … for so long, s.
pub const TIME: f32 = 0.5;

/// A ball may spin in place, but its surface no faster than this, m/s: where a ball touches, it touches in a
/// point, and nothing slows a spin about the line through it.
pub const FASTEST_SPIN: f32 = 1.0;

/// The kind of a ball.
const BALL: u32 = 0;

/// Where a body was, and for how long it has been near.
#[derive(Clone, Copy, Debug, Default)]
pub struct Calm {
    position: Vec3,
    attitude: Quat,
    /// s.
    pub time: f32,
}

impl Calm {
    /// Looks at a body after a step of `dt` seconds.
    pub fn look(&mut self, bodies: &Bodies, row: usize, dt: f32) {
        if self.is_near(bodies, row) {
            self.time += dt;
        } else {
            *self = Self {
                position: bodies.place[row].position,
                attitude: bodies.attitude[row],
                time: 0.0,
            };
        }
    }

    // ANCHOR: calm
    /// Whether no point of the body has come far from where it was. A body that is nowhere isn't near.
    fn is_near(&self, bodies: &Bodies, row: usize) -> bool {
        let (place, attitude) = (&bodies.place[row], bodies.attitude[row]);
        let way = (place.position - self.position).norm();
        if bodies.solid[row].kind == BALL {
            let rim = bodies.spin[row].angular_velocity.norm() * place.reach;
            return way <= DISTANCE && rim <= FASTEST_SPIN;
        }
        // The chord of the turn, 2 sin of half its angle.
        let turn = 2.0 * (attitude * self.attitude.conjugate()).xyz().norm();
        way + turn * place.reach <= DISTANCE
    }
    // ANCHOR_END: calm
}
