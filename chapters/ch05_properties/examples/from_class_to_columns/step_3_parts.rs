//! Step 3, parts: the struct is cut into what is used together, a list of each.

use glam::{Quat, Vec3};

use crate::ball::{Ball, above_floor, fly};
use crate::world::{Span, World};

// ANCHOR: parts
/// All balls.
#[derive(Default)]
pub struct Parts {
    motions: Vec<Motion>,
    turnings: Vec<Turning>,
    matters: Vec<Matter>,
    looks: Vec<Look>,
}

struct Motion {
    position: Vec3,
    last_position: Vec3,
}

struct Turning {
    orientation: Quat,
    last_orientation: Quat,
}

struct Matter {
    mass: f32,
    inertia: Vec3,
    restitution: f32,
    static_friction: f32,
    friction: f32,
}

struct Look {
    radius: f32,
    colour: Vec3,
}
// ANCHOR_END: parts

impl Parts {
    pub fn new(balls: &[Ball]) -> Self {
        let mut parts = Self::default();
        for &ball in balls {
            parts.push(ball);
        }
        parts
    }

    fn push(&mut self, ball: Ball) {
        self.motions.push(Motion {
            position: ball.position,
            last_position: ball.last_position,
        });
        self.turnings.push(Turning {
            orientation: ball.orientation,
            last_orientation: ball.last_orientation,
        });
        self.matters.push(Matter {
            mass: ball.mass,
            inertia: ball.inertia,
            restitution: ball.restitution,
            static_friction: ball.static_friction,
            friction: ball.friction,
        });
        self.looks.push(Look {
            radius: ball.radius,
            colour: ball.colour,
        });
    }
}

impl World for Parts {
    fn integrate(&mut self, dt: f32) {
        for motion in &mut self.motions {
            (motion.position, motion.last_position) =
                fly(motion.position, motion.last_position, dt);
        }
    }

    // ANCHOR: bounce
    fn bounce(&mut self, dt: f32) {
        let others = self.matters.iter().zip(&self.looks);
        for (motion, (matter, look)) in self.motions.iter_mut().zip(others) {
            let (p, p_last) = (motion.position, motion.last_position);
            (motion.position, motion.last_position) =
                above_floor(p, p_last, look.radius, matter.restitution, dt);
        }
    }
    // ANCHOR_END: bounce

    fn ball(&self, number: usize) -> Ball {
        let (motion, turning) = (&self.motions[number], &self.turnings[number]);
        let (matter, look) = (&self.matters[number], &self.looks[number]);
        Ball {
            position: motion.position,
            last_position: motion.last_position,
            orientation: turning.orientation,
            last_orientation: turning.last_orientation,
            mass: matter.mass,
            inertia: matter.inertia,
            radius: look.radius,
            restitution: matter.restitution,
            static_friction: matter.static_friction,
            friction: matter.friction,
            colour: look.colour,
        }
    }

    fn bytes(&self) -> usize {
        size_of::<Motion>() + size_of::<Turning>() + size_of::<Matter>() + size_of::<Look>()
    }

    fn visits(&self, number: usize) -> Vec<Span> {
        let motion = &self.motions[number];
        Span::of_places(&motion.position, &motion.last_position)
    }
}
