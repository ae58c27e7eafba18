//! The table of bodies: a column a property, a row a body. The last row is the world itself, which nothing
//! moves.

use ch00_maths::f32::shape::Shape;
use ch00_scenes::{Body, Scene, State};

use super::real::{Quat, Real, Vec3, quaternion, real, rotation, vector, wide, wide_turn};

/// Columns of all bodies; SI units, world frame unless said otherwise.
#[derive(Clone, Debug, Default)]
pub struct Bodies {
    /// Of the centres, m.
    pub position: Vec<Vec3>,
    /// Body to world.
    pub attitude: Vec<Quat>,
    /// m/s.
    pub velocity: Vec<Vec3>,
    /// rad/s.
    pub angular_velocity: Vec<Vec3>,
    /// 1/kg; 0 of what doesn't move.
    pub inverse_mass: Vec<Real>,
    /// About the body's axes, kg m²; 0 of what doesn't move.
    pub inertia: Vec<Vec3>,
    /// 1/(kg m²); 0 of what doesn't move.
    pub inverse_inertia: Vec<Vec3>,
    /// e.
    pub restitution: Vec<Real>,
    /// Kinetic μ.
    pub friction: Vec<Real>,
    /// Static μ.
    pub static_friction: Vec<Real>,
    /// What touches.
    pub shape: Vec<Shape>,
}

impl Bodies {
    /// The scene's bodies, and the world.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let mut bodies = Self::default();
        for body in &scene.bodies {
            bodies.push(body);
        }
        let radius = 0.0;
        let world = ch00_scenes::Shape::Sphere { radius };
        bodies.push(&Body::new(world, 0.0, glam::DVec3::ZERO));
        bodies
    }

    fn push(&mut self, body: &Body) {
        let still = body.is_static();
        let inertia = if still {
            Vec3::ZERO
        } else {
            vector(body.shape.inertia(body.mass))
        };
        let inverse = |x: Real| if x > 0.0 { 1.0 / x } else { 0.0 };
        self.position.push(vector(body.position));
        self.attitude.push(quaternion(body.orientation).normalize());
        self.velocity.push(vector(body.linear_velocity));
        self.angular_velocity.push(vector(body.angular_velocity));
        self.inverse_mass.push(inverse(real(body.mass)));
        self.inertia.push(inertia);
        self.inverse_inertia.push(Vec3::new(
            inverse(inertia.x),
            inverse(inertia.y),
            inverse(inertia.z),
        ));
        self.restitution.push(real(body.restitution));
        self.friction.push(real(body.friction));
        let holds = body.static_friction.unwrap_or(body.friction);
        self.static_friction.push(real(holds));
        self.shape.push(body.shape.single());
    }

    /// How many there are, without the world.
    #[must_use]
    pub fn count(&self) -> usize {
        self.position.len() - 1
    }

    /// The row of the world.
    #[must_use]
    pub fn world(&self) -> usize {
        self.count()
    }

    /// Whether impulses change how a body moves.
    #[must_use]
    pub fn moves(&self, row: usize) -> bool {
        self.inverse_mass[row] > 0.0
    }

    /// I⁻¹ a in the world.
    #[must_use]
    pub fn turned_by(&self, row: usize, a: Vec3) -> Vec3 {
        rotation::moment(self.attitude[row], self.inverse_inertia[row], a)
    }

    /// I ω in the world, kg m²/s.
    #[must_use]
    pub fn angular_momentum(&self, row: usize) -> Vec3 {
        rotation::moment(
            self.attitude[row],
            self.inertia[row],
            self.angular_velocity[row],
        )
    }

    /// How fast the point `arm` away from the centre moves, m/s.
    #[must_use]
    pub fn velocity_at(&self, row: usize, arm: Vec3) -> Vec3 {
        self.velocity[row] + self.angular_velocity[row].cross(arm)
    }

    /// Writes where they are.
    pub fn read(&self, state: &mut State) {
        state.clear();
        for row in 0..self.count() {
            state.push(
                wide(self.position[row]),
                wide_turn(self.attitude[row]),
                wide(self.velocity[row]),
                wide(self.angular_velocity[row]),
            );
        }
    }

    /// Takes over a state.
    pub fn write(&mut self, state: &State) {
        for row in 0..state.len().min(self.count()) {
            self.position[row] = vector(state.position[row]);
            self.attitude[row] = quaternion(state.orientation[row]);
            self.velocity[row] = vector(state.linear_velocity[row]);
            self.angular_velocity[row] = vector(state.angular_velocity[row]);
        }
    }
}
