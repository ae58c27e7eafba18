//! The bodies of a scene as rows, for both engines of this chapter.

use std::ops::Range;

use ch00_maths::f32::{rotation, spin};
use ch00_scenes::{Body, Scene, Shape, State};
use ch05_properties::data::shape_columns;
use glam::{DQuat, DVec3, Quat, Vec3};

use crate::footing::{Block, founded};
use crate::rows::{Held, Material, Motion, Place, Push, Seen, Solid, Spin};
use crate::simd::MOST_LANES;

/// The kind of a box.
const BOX: u32 = 1;

/// All rows of all bodies: a column a kind of row, in the order of the scene.
#[derive(Clone, Debug, Default)]
pub struct Bodies {
    /// Where they are.
    pub place: Vec<Place>,
    /// Body to world.
    pub attitude: Vec<Quat>,
    /// How they move.
    pub motion: Vec<Motion>,
    /// How they turn.
    pub spin: Vec<Spin>,
    /// What they are made of.
    pub solid: Vec<Solid>,
    /// Their surfaces.
    pub material: Vec<Material>,
    /// What holds them.
    pub held: Vec<Held>,
    /// What pushes them out of others.
    pub push: Vec<Push>,
    /// World angular momentum, kg m²/s. A ball has none here: it doesn't need it to turn.
    pub momentum: Vec<Vec3>,
    /// How they moved before the last kick.
    pub before: Vec<Seen>,
    /// What they are to who looks: of a static box `place` and `solid` hold what [`founded`] makes of it.
    looks: Vec<Looks>,
    /// What they would weigh if they were awake, by row; none where they are.
    asleep: Vec<Option<Weight>>,
    /// The rows that passes over bodies go through, in order: all but those of whole blocks of
    /// [`MOST_LANES`] that sleep.
    runs: Vec<Range<usize>>,
}

/// How hard a body is to move.
#[derive(Clone, Copy, Debug)]
struct Weight {
    inverse_mass: f32,
    inverse_inertia: Vec3,
}

/// A body as the scene has it.
#[derive(Clone, Copy, Debug)]
struct Looks {
    /// World position, if it is static.
    position: Vec3,
    size: Vec3,
    /// Whether nothing is fixed to it: then it may be made longer.
    is_plain: bool,
}

impl Bodies {
    /// The bodies of a scene at its start.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let mut bodies = Self::default();
        for body in &scene.bodies {
            bodies.push(body);
        }
        for joint in &scene.joints {
            let (a, b) = joint.bodies();
            bodies.looks[a].is_plain = false;
            bodies.looks[b].is_plain = false;
        }
        bodies.found();
        bodies
    }

    /// How many there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.place.len()
    }

    /// Whether an impulse changes how a body moves: it has a mass, or turns about a fixed point.
    #[must_use]
    pub fn moves(&self, row: usize) -> bool {
        self.spin[row].inverse_mass > 0.0 || self.solid[row].inverse_inertia != Vec3::ZERO
    }

    /// Makes static boxes longer where they stand on others.
    pub fn found(&mut self) {
        let is_block = |row: &usize| {
            self.is_fixed(*row) && self.solid[*row].kind == BOX && self.looks[*row].is_plain
        };
        let rows: Vec<usize> = (0..self.rows()).filter(is_block).collect();
        let block = |&row: &usize| Block {
            position: self.looks[row].position,
            attitude: self.attitude[row],
            half: self.looks[row].size,
        };
        let blocks: Vec<Block> = rows.iter().map(block).collect();
        for (row, block) in rows.into_iter().zip(founded(&blocks)) {
            self.place[row].position = block.position;
            self.place[row].reach = block.half.length();
            self.solid[row].size = block.half;
        }
    }

    /// World position of a body as the scene has it, m.
    #[must_use]
    pub fn position(&self, row: usize) -> Vec3 {
        if self.is_fixed(row) {
            self.looks[row].position
        } else {
            self.place[row].position
        }
    }

    /// Adds a body. Who adds a static one calls [`Self::found`].
    pub fn push(&mut self, body: &Body) {
        let id = self.rows() as u32;
        let solid = solid_of(body, id);
        self.place.push(Place {
            position: body.position.as_vec3(),
            reach: body.shape.single().bounding_radius(),
        });
        self.attitude.push(body.orientation.as_quat().normalize());
        self.motion.push(Motion {
            velocity: body.linear_velocity.as_vec3(),
            shares: 1.0,
        });
        self.spin.push(Spin {
            angular_velocity: body.angular_velocity.as_vec3(),
            inverse_mass: if body.is_static() {
                0.0
            } else {
                (1.0 / body.mass) as f32
            },
        });
        self.solid.push(solid);
        self.material.push(Material {
            restitution: body.restitution as f32,
            friction: body.friction as f32,
            static_friction: body.static_friction() as f32,
            spare: 0.0,
        });
        self.held.push(Held::default());
        self.push.push(Push::default());
        self.before.push(Seen::default());
        self.looks.push(Looks {
            position: body.position.as_vec3(),
            size: solid.size,
            is_plain: true,
        });
        self.momentum.push(Vec3::ZERO);
        self.read_momentum(id as usize);
        self.asleep.push(None);
        let row = id as usize;
        match self.runs.last_mut() {
            Some(run) if run.end == row => run.end += 1,
            _ => self.runs.push(row - row % MOST_LANES..row + 1),
        }
    }

    /// Removes a body; those after it move up.
    pub fn remove(&mut self, row: usize) {
        self.place.remove(row);
        self.attitude.remove(row);
        self.motion.remove(row);
        self.spin.remove(row);
        self.solid.remove(row);
        self.material.remove(row);
        self.held.remove(row);
        self.push.remove(row);
        self.before.remove(row);
        self.looks.remove(row);
        self.momentum.remove(row);
        self.asleep.remove(row);
        self.find_runs();
        for (id, solid) in self.solid.iter_mut().enumerate() {
            solid.id = id as u32;
        }
    }

    /// Where they are and how they move, in f64.
    pub fn read(&self, state: &mut State) {
        state.clear();
        for row in 0..self.rows() {
            state.push(
                self.position(row).as_dvec3(),
                self.attitude[row].as_dquat().normalize(),
                self.motion[row].velocity.as_dvec3(),
                self.spin[row].angular_velocity.as_dvec3(),
            );
        }
    }

    /// Takes over where they are and how they move; what held them is forgotten.
    pub fn write(&mut self, state: &State) {
        for row in 0..self.rows().min(state.len()) {
            self.set_pose(row, state.position[row], state.orientation[row]);
            self.motion[row].velocity = state.linear_velocity[row].as_vec3();
            self.spin[row].angular_velocity = state.angular_velocity[row].as_vec3();
            self.held[row] = Held::default();
            self.read_momentum(row);
        }
        self.found();
    }

    /// Reads a body's angular momentum from its angular velocity.
    pub fn read_momentum(&mut self, row: usize) {
        let inverse_inertia = self.solid[row].inverse_inertia;
        self.momentum[row] = if inverse_inertia == Vec3::ZERO || spin::is_round(inverse_inertia) {
            Vec3::ZERO
        } else {
            let omega = self.spin[row].angular_velocity;
            rotation::moment(self.attitude[row], inverse_inertia.recip(), omega)
        };
    }

    fn set_pose(&mut self, row: usize, position: DVec3, orientation: DQuat) {
        self.place[row].position = position.as_vec3();
        self.looks[row].position = position.as_vec3();
        self.attitude[row] = orientation.as_quat().normalize();
    }

    /// Whether nothing moves this body: it is fixed, or sleeps.
    #[must_use]
    pub fn is_static(&self, row: usize) -> bool {
        self.spin[row].inverse_mass == 0.0 && self.solid[row].inverse_inertia == Vec3::ZERO
    }

    /// Whether nothing ever moves it.
    #[must_use]
    pub fn is_fixed(&self, row: usize) -> bool {
        self.is_static(row) && !self.is_asleep(row)
    }

    /// Whether it is a box that nothing moves.
    #[must_use]
    pub fn is_block(&self, row: usize) -> bool {
        self.solid[row].kind == BOX && self.is_static(row)
    }

    /// Whether it sleeps.
    #[must_use]
    pub fn is_asleep(&self, row: usize) -> bool {
        self.asleep[row].is_some()
    }

    /// World velocity of a point of a body, m/s.
    #[must_use]
    pub fn velocity_at(&self, row: usize, arm: Vec3) -> Vec3 {
        self.motion[row].velocity + self.spin[row].angular_velocity.cross(arm)
    }

    /// I⁻¹ T in world axes.
    #[must_use]
    pub fn turned_by(&self, row: usize, turning: Vec3) -> Vec3 {
        rotation::moment(self.attitude[row], self.solid[row].inverse_inertia, turning)
    }
}

impl Bodies {
    // ANCHOR: lay_down
    /// A body falls asleep: it stands still, and as long as it sleeps nothing moves it. Who lays bodies down
    /// or wakes them calls [`Self::find_runs`] after them.
    pub fn lay_down(&mut self, row: usize) {
        let (solid, spin) = (&mut self.solid[row], &mut self.spin[row]);
        self.asleep[row] = Some(Weight {
            inverse_mass: std::mem::take(&mut spin.inverse_mass),
            inverse_inertia: std::mem::take(&mut solid.inverse_inertia),
        });
        self.stop(row);
    }

    /// It wakes, and weighs again what it did.
    pub fn wake(&mut self, row: usize) {
        if let Some(weight) = self.asleep[row].take() {
            self.spin[row].inverse_mass = weight.inverse_mass;
            self.solid[row].inverse_inertia = weight.inverse_inertia;
            self.stop(row);
        }
    }
    // ANCHOR_END: lay_down

    /// It neither moves nor turns, and nothing pushes it.
    fn stop(&mut self, row: usize) {
        self.motion[row].velocity = Vec3::ZERO;
        self.spin[row].angular_velocity = Vec3::ZERO;
        self.momentum[row] = Vec3::ZERO;
        self.before[row] = Seen::default();
        self.push[row] = Push::default();
    }

    /// Looks which blocks of rows passes must go through.
    pub fn find_runs(&mut self) {
        self.runs.clear();
        for first in (0..self.rows()).step_by(MOST_LANES) {
            let end = self.rows().min(first + MOST_LANES);
            if (first..end).all(|row| self.is_asleep(row)) {
                continue;
            }
            match self.runs.last_mut() {
                Some(run) if run.end == first => run.end = end,
                _ => self.runs.push(first..end),
            }
        }
    }

    /// The rows that passes go through, in order.
    #[must_use]
    pub fn runs(&self) -> &[Range<usize>] {
        &self.runs
    }

    /// How many they are.
    #[must_use]
    pub fn awake(&self) -> usize {
        self.runs.iter().map(Range::len).sum()
    }
}

/// What a body is made of.
fn solid_of(body: &Body, id: u32) -> Solid {
    let shape = body.shape.single();
    let (kind, size) = shape_columns(&shape);
    let inverse_inertia = if body.is_static() {
        Vec3::ZERO
    } else {
        body.shape.inertia(body.mass).recip().as_vec3()
    };
    Solid {
        inverse_inertia,
        kind,
        size,
        id,
    }
}

/// Whether a shape is a ball.
#[must_use]
pub fn is_ball(shape: &Shape) -> bool {
    matches!(shape, Shape::Sphere { .. })
}
