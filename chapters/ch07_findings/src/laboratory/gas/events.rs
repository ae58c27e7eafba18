//! A gas without steps: hard balls fly straight until two of them meet or one meets a wall, and nothing is looked
//! at in between. It is exact but for the rounding of double precision, and knows nothing of the engines; so it
//! can say how often balls collide between walls, for which theory has no closed form.
//!
//! Source: Alder and Wainwright 1959, *Studies in Molecular Dynamics. I. General Method*.

use glam::DVec3;

/// What bounds the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Walls that balls bounce off.
    Walls,
    /// Who goes out on one side comes in on the other.
    Periodic,
}

/// What happens to a ball next.
#[derive(Clone, Copy, Debug, PartialEq)]
enum With {
    Nothing,
    Ball { other: usize, image: DVec3 },
    Wall(usize),
}

/// The next event of a ball.
#[derive(Clone, Copy, Debug)]
struct Event {
    /// From now, s.
    after: f64,
    with: With,
}

/// Balls of equal mass in a cube about the origin.
#[derive(Clone, Debug)]
pub struct Gas {
    /// m.
    pub position: Vec<DVec3>,
    /// m/s.
    pub velocity: Vec<DVec3>,
    /// Collisions of two balls so far.
    pub collisions: u64,
    diameter: f64,
    /// Half an edge of the cube, m.
    half: f64,
    sides: Sides,
    next: Vec<Event>,
}

impl Gas {
    /// Balls that don't overlap; half an edge of the cube, and the diameter, m.
    #[must_use]
    pub fn new(
        position: Vec<DVec3>,
        velocity: Vec<DVec3>,
        diameter: f64,
        half: f64,
        sides: Sides,
    ) -> Self {
        let mut gas = Self {
            next: Vec::new(),
            collisions: 0,
            position,
            velocity,
            diameter,
            half,
            sides,
        };
        gas.next = (0..gas.position.len()).map(|ball| gas.find(ball)).collect();
        gas
    }

    // ANCHOR: run
    /// Lets so much time pass, s: from event to event.
    pub fn run(&mut self, mut seconds: f64) {
        while let Some(first) = self
            .first()
            .filter(|&ball| self.next[ball].after <= seconds)
        {
            let Event { after, with } = self.next[first];
            self.fly(after);
            seconds -= after;
            match with {
                With::Ball { other, image } => self.collide(first, other, image),
                With::Wall(axis) => {
                    self.velocity[first][axis] *= -1.0;
                    self.renew(&[first]);
                }
                With::Nothing => break,
            }
        }
        self.fly(seconds);
    }
    // ANCHOR_END: run

    /// The ball whose event is the next of all.
    fn first(&self) -> Option<usize> {
        (0..self.next.len()).min_by(|&a, &b| self.next[a].after.total_cmp(&self.next[b].after))
    }

    /// All fly on straight.
    fn fly(&mut self, seconds: f64) {
        for (ball, event) in self.next.iter_mut().enumerate() {
            self.position[ball] += self.velocity[ball] * seconds;
            event.after -= seconds;
        }
    }

    /// Two balls of equal mass exchange their velocities along the line between them.
    fn collide(&mut self, a: usize, b: usize, image: DVec3) {
        let normal = (self.position[b] + image - self.position[a]).normalize();
        let exchanged = normal * (self.velocity[b] - self.velocity[a]).dot(normal);
        self.velocity[a] += exchanged;
        self.velocity[b] -= exchanged;
        self.collisions += 1;
        self.renew(&[a, b]);
    }

    /// Looks anew for what happens to balls that have changed, and to those who were to meet them.
    fn renew(&mut self, changed: &[usize]) {
        for ball in 0..self.next.len() {
            let meant = matches!(self.next[ball].with, With::Ball { other, .. } if changed.contains(&other));
            if meant || changed.contains(&ball) {
                self.next[ball] = self.find(ball);
            }
        }
    }

    /// The next event of a ball, if nothing happens before.
    fn find(&self, ball: usize) -> Event {
        let mut next = Event {
            after: f64::INFINITY,
            with: With::Nothing,
        };
        if self.sides == Sides::Walls {
            for axis in 0..3 {
                let (x, v) = (self.position[ball][axis], self.velocity[ball][axis]);
                let room = self.half - 0.5 * self.diameter;
                let after = (room.copysign(v) - x) / v;
                if v != 0.0 && after < next.after {
                    next = Event {
                        after: after.max(0.0),
                        with: With::Wall(axis),
                    };
                }
            }
        }
        for other in (0..self.position.len()).filter(|&other| other != ball) {
            for image in self.images(ball, other) {
                let way = self.position[other] + image - self.position[ball];
                let speed = self.velocity[other] - self.velocity[ball];
                if let Some(after) = meeting(way, speed, self.diameter)
                    && after < next.after
                {
                    let with = With::Ball { other, image };
                    next = Event { after, with };
                }
            }
        }
        next
    }

    /// Where another ball stands for a ball: itself, or the images that may be met before a turn around the room.
    fn images(&self, ball: usize, other: usize) -> impl Iterator<Item = DVec3> + use<> {
        let edge = 2.0 * self.half;
        let (nearest, reach) = match self.sides {
            Sides::Walls => (DVec3::ZERO, 0),
            Sides::Periodic => {
                let way = self.position[other] - self.position[ball];
                (-(way / edge).round(), 1)
            }
        };
        let around = -reach..=reach;
        let shifts = around.clone().flat_map(move |x| {
            let around = around.clone();
            around
                .clone()
                .flat_map(move |y| around.clone().map(move |z| [x, y, z]))
        });
        shifts.map(move |shift: [i32; 3]| edge * (nearest + DVec3::from(shift.map(f64::from))))
    }
}

/// When two balls meet whose centres are `way` apart, m, and change it by `speed`, m/s.
fn meeting(way: DVec3, speed: DVec3, diameter: f64) -> Option<f64> {
    let closing = way.dot(speed);
    if closing >= 0.0 {
        return None;
    }
    let gap = way.length_squared() - diameter * diameter;
    let inside = closing * closing - speed.length_squared() * gap;
    // Where they touch already, rounding may have put them a little too near.
    (inside >= 0.0).then(|| (gap / (-closing + inside.sqrt())).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::super::start;
    use super::*;

    #[test]
    fn two_balls_meet_where_and_when_they_should() {
        let position = vec![DVec3::X * -1.0, DVec3::X];
        let velocity = vec![DVec3::X * 3.0, DVec3::X * -1.0];
        let mut gas = Gas::new(position, velocity, 0.4, 2.0, Sides::Walls);
        gas.run(0.4 + 0.1);
        assert_eq!(gas.collisions, 1);
        // They met after 0.4 s, 1.6 m nearer, at 0.2 and 0.6 m, and have flown a tenth of a second since.
        assert!((gas.position[0].x - 0.1).abs() < 1e-12 && (gas.velocity[0].x + 1.0).abs() < 1e-12);
        assert!((gas.position[1].x - 0.9).abs() < 1e-12 && (gas.velocity[1].x - 3.0).abs() < 1e-12);
    }

    /// Of scenario 18: Γ of a ball of an infinite gas, 1/s. With 125 balls, 124 others are there to be met.
    const GAMMA: f64 = 21.004_729_60 * 124.0 / 125.0;

    #[test]
    fn without_walls_balls_collide_as_often_as_theory_says() {
        let (position, velocity, diameter, half) = start();
        let mut gas = Gas::new(position, velocity, diameter, half, Sides::Periodic);
        gas.run(2.0);
        let (before, seconds) = (gas.collisions, 20.0);
        gas.run(seconds);
        let rate = 2.0 * (gas.collisions - before) as f64 / (125.0 * seconds);
        // Some 26,000 collisions: 0.6 % by chance, and Enskog's χ is good to a few thousandths.
        assert!((rate / GAMMA - 1.0).abs() < 0.02, "{rate} for {GAMMA} 1/s");
    }

    #[test]
    fn energy_stays_and_nobody_leaves_or_overlaps() {
        let (position, velocity, diameter, half) = start();
        let mut gas = Gas::new(position, velocity, diameter, half, Sides::Walls);
        gas.run(5.0);
        let energy: f64 = gas.velocity.iter().map(|v| v.length_squared()).sum();
        assert!((energy / 375.0 - 1.0).abs() < 1e-10, "{energy}");
        let room = half - 0.5 * diameter + 1e-9;
        assert!(gas.position.iter().all(|x| x.abs().max_element() <= room));
        for (k, a) in gas.position.iter().enumerate() {
            for b in &gas.position[..k] {
                assert!(a.distance(*b) > diameter - 1e-9);
            }
        }
    }
}
