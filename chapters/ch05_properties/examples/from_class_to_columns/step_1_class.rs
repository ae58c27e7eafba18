//! Step 1, a class: each ball is an object behind a shared handle, as in chapters 1 to 4.

use std::cell::RefCell;
use std::rc::Rc;

use ch01_hierarchy::Shared;

use crate::ball::{Ball, above_floor, fly};
use crate::world::{Span, World};

// ANCHOR: class
/// What the level knows of an object.
trait Body {
    fn integrate(&mut self, dt: f32);
    fn bounce(&mut self, dt: f32);
    fn ball(&self) -> &Ball;
}

impl Body for Ball {
    fn integrate(&mut self, dt: f32) {
        (self.position, self.last_position) = fly(self.position, self.last_position, dt);
    }

    fn bounce(&mut self, dt: f32) {
        let (p, p_last, radius) = (self.position, self.last_position, self.radius);
        (self.position, self.last_position) = above_floor(p, p_last, radius, self.restitution, dt);
    }

    fn ball(&self) -> &Ball {
        self
    }
}

/// All objects.
pub struct Level {
    bodies: Vec<Shared<dyn Body>>,
}
// ANCHOR_END: class

impl Level {
    pub fn new(balls: &[Ball]) -> Self {
        let shared = |ball: &Ball| Rc::new(RefCell::new(*ball)) as Shared<dyn Body>;
        Self {
            bodies: balls.iter().map(shared).collect(),
        }
    }
}

impl World for Level {
    // ANCHOR: integrate
    fn integrate(&mut self, dt: f32) {
        for body in &self.bodies {
            body.borrow_mut().integrate(dt);
        }
    }
    // ANCHOR_END: integrate

    fn bounce(&mut self, dt: f32) {
        for body in &self.bodies {
            body.borrow_mut().bounce(dt);
        }
    }

    fn ball(&self, number: usize) -> Ball {
        *self.bodies[number].borrow().ball()
    }

    fn bytes(&self) -> usize {
        // An Rc's box has two counts before the value.
        let counts = 2 * size_of::<usize>();
        size_of::<Shared<dyn Body>>() + counts + size_of::<RefCell<Ball>>()
    }

    fn visits(&self, number: usize) -> Vec<Span> {
        let handle = &self.bodies[number];
        // A RefCell's note of who borrows it stands before the value.
        let note = Span {
            address: Rc::as_ptr(handle).addr(),
            bytes: size_of::<usize>(),
        };
        let body = handle.borrow();
        let ball = body.ball();
        let mut visits = Span::of_places(&ball.position, &ball.last_position);
        visits.extend([Span::of(handle), note]);
        visits
    }
}
