//! Step 4, columns: a list of each property, and a ball is a number.

use glam::{Quat, Vec3};

use crate::ball::{Ball, above_floor, fly};
use crate::world::{Span, World};

// ANCHOR: columns
/// All balls.
#[derive(Default)]
pub struct Columns {
    position: Vec<Vec3>,
    last_position: Vec<Vec3>,
    orientation: Vec<Quat>,
    last_orientation: Vec<Quat>,
    mass: Vec<f32>,
    inertia: Vec<Vec3>,
    radius: Vec<f32>,
    restitution: Vec<f32>,
    static_friction: Vec<f32>,
    friction: Vec<f32>,
    colour: Vec<Vec3>,
}
// ANCHOR_END: columns

impl Columns {
    pub fn new(balls: &[Ball]) -> Self {
        let mut columns = Self::default();
        for &ball in balls {
            columns.push(ball);
        }
        columns
    }

    // ANCHOR: push
    fn push(&mut self, ball: Ball) {
        self.position.push(ball.position);
        self.last_position.push(ball.last_position);
        self.orientation.push(ball.orientation);
        self.last_orientation.push(ball.last_orientation);
        self.mass.push(ball.mass);
        self.inertia.push(ball.inertia);
        self.radius.push(ball.radius);
        self.restitution.push(ball.restitution);
        self.static_friction.push(ball.static_friction);
        self.friction.push(ball.friction);
        self.colour.push(ball.colour);
    }
    // ANCHOR_END: push
}

impl World for Columns {
    // ANCHOR: integrate
    fn integrate(&mut self, dt: f32) {
        for (p, p_last) in self.position.iter_mut().zip(&mut self.last_position) {
            (*p, *p_last) = fly(*p, *p_last, dt);
        }
    }
    // ANCHOR_END: integrate

    fn bounce(&mut self, dt: f32) {
        let places = self.position.iter_mut().zip(&mut self.last_position);
        let surfaces = self.radius.iter().zip(&self.restitution);
        for ((p, p_last), (radius, restitution)) in places.zip(surfaces) {
            (*p, *p_last) = above_floor(*p, *p_last, *radius, *restitution, dt);
        }
    }

    fn ball(&self, number: usize) -> Ball {
        Ball {
            position: self.position[number],
            last_position: self.last_position[number],
            orientation: self.orientation[number],
            last_orientation: self.last_orientation[number],
            mass: self.mass[number],
            inertia: self.inertia[number],
            radius: self.radius[number],
            restitution: self.restitution[number],
            static_friction: self.static_friction[number],
            friction: self.friction[number],
            colour: self.colour[number],
        }
    }

    fn bytes(&self) -> usize {
        4 * size_of::<Vec3>() + 2 * size_of::<Quat>() + 5 * size_of::<f32>()
    }

    fn visits(&self, number: usize) -> Vec<Span> {
        Span::of_places(&self.position[number], &self.last_position[number])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DT;
    use crate::ball::balls;

    #[test]
    fn a_column_that_a_push_forgets_is_no_error_but_a_ball_that_hangs_in_the_air() {
        let balls = balls(3, DT);
        let mut columns = Columns::new(&balls);
        columns.last_position.pop();
        columns.integrate(DT);
        assert_ne!(columns.position[1], balls[1].position);
        assert_eq!(columns.position[2], balls[2].position);
    }
}
