//! Step 2, plain structs: the same balls without handles, one after the other.

use crate::ball::{Ball, above_floor, fly};
use crate::world::{Span, World};

/// All balls.
pub struct Balls {
    balls: Vec<Ball>,
}

impl Balls {
    pub fn new(balls: &[Ball]) -> Self {
        Self {
            balls: balls.to_vec(),
        }
    }
}

impl World for Balls {
    // ANCHOR: integrate
    fn integrate(&mut self, dt: f32) {
        for ball in &mut self.balls {
            (ball.position, ball.last_position) = fly(ball.position, ball.last_position, dt);
        }
    }
    // ANCHOR_END: integrate

    fn bounce(&mut self, dt: f32) {
        for ball in &mut self.balls {
            let (p, p_last, radius) = (ball.position, ball.last_position, ball.radius);
            (ball.position, ball.last_position) =
                above_floor(p, p_last, radius, ball.restitution, dt);
        }
    }

    fn ball(&self, number: usize) -> Ball {
        self.balls[number]
    }

    fn bytes(&self) -> usize {
        size_of::<Ball>()
    }

    fn visits(&self, number: usize) -> Vec<Span> {
        let ball = &self.balls[number];
        Span::of_places(&ball.position, &ball.last_position)
    }
}
