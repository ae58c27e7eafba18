//! Where every body is and how it moves, at one moment, in the scene's order.

use glam::{DQuat, DVec3};

use crate::Scene;

/// Positions (m), orientations (body to world) and velocities (m/s, rad/s, world) of all
/// bodies, static ones too. In f64, so that it holds any engine's numbers without loss.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// World positions, m.
    pub position: Vec<DVec3>,
    /// Body to world.
    pub orientation: Vec<DQuat>,
    /// m/s.
    pub linear_velocity: Vec<DVec3>,
    /// rad/s, world frame.
    pub angular_velocity: Vec<DVec3>,
}

impl State {
    /// The state that the scene starts from.
    #[must_use]
    pub fn start_of(scene: &Scene) -> Self {
        let mut state = Self::default();
        for body in &scene.bodies {
            state.push(
                body.position,
                body.orientation,
                body.linear_velocity,
                body.angular_velocity,
            );
        }
        state
    }

    /// How many bodies it describes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether it describes none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Forgets all bodies and keeps the memory.
    pub fn clear(&mut self) {
        self.position.clear();
        self.orientation.clear();
        self.linear_velocity.clear();
        self.angular_velocity.clear();
    }

    /// Adds one body.
    pub fn push(&mut self, position: DVec3, orientation: DQuat, linear: DVec3, angular: DVec3) {
        self.position.push(position);
        self.orientation.push(orientation);
        self.linear_velocity.push(linear);
        self.angular_velocity.push(angular);
    }

    /// How many bodies have a number that is not finite.
    #[must_use]
    pub fn not_finite(&self) -> usize {
        (0..self.len())
            .filter(|&i| {
                !(self.position[i].is_finite()
                    && self.orientation[i].is_finite()
                    && self.linear_velocity[i].is_finite()
                    && self.angular_velocity[i].is_finite())
            })
            .count()
    }

    /// A hash of every bit (64-bit FNV-1a over the numbers in order): equal states have equal
    /// hashes, and one flipped bit changes it.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let numbers = (0..self.len()).flat_map(|i| {
            let (p, q) = (self.position[i], self.orientation[i]);
            let (v, w) = (self.linear_velocity[i], self.angular_velocity[i]);
            [
                p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z,
            ]
        });
        numbers
            .flat_map(f64::to_le_bytes)
            .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
            })
    }
}
