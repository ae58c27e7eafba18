//! From a scene to a level full of rigid bodies, with the forces that the scene names.

use ch00_maths::f32::impulse::Velocity;
use ch00_scenes::{Body, EngineEntry, Force, LoadError, Scene};
use ch01_hierarchy::{Level, Shared, Transform};

use crate::{FixedPoint, Material, Method, RigidBody, add_magnets};

/// A level, and the bodies in it in the scene's order.
pub struct Loaded {
    /// Owns the graph and the objects.
    pub level: Level,
    /// The same objects, by the scene's index.
    pub bodies: Vec<Shared<RigidBody>>,
}

// ANCHOR: load
/// Makes a level of `scene`.
///
/// # Errors
/// [`LoadError::Unsupported`] for a fixed point that isn't on one of its body's axes.
pub fn load_bodies(
    entry: &EngineEntry,
    scene: &Scene,
    method: Method,
) -> Result<Loaded, LoadError> {
    let mut loaded = Loaded {
        level: Level::new(),
        bodies: Vec::new(),
    };
    for body in &scene.bodies {
        loaded.add(scene, body, method);
    }
    for (index, force) in scene.forces.iter().enumerate() {
        loaded
            .add_force(force)
            .map_err(|what| unsupported(entry, scene, what, Some(index)))?;
    }
    loaded.place(scene);
    Ok(loaded)
}
// ANCHOR_END: load

impl Loaded {
    /// Adds one body of the scene; gives its index.
    pub fn add(&mut self, scene: &Scene, body: &Body, method: Method) -> usize {
        let index = self.bodies.len();
        let pose = Transform::new(body.position.as_vec3(), body.orientation.as_quat());
        let node = self.level.graph.add(format!("body {index}"), None, pose);
        let mut object = RigidBody::new(
            node,
            method,
            body.shape.single(),
            body.mass as f32,
            Material {
                restitution: body.restitution as f32,
                friction: body.friction as f32,
                static_friction: body.static_friction() as f32,
            },
        );
        object.set_surroundings(scene.gravity.as_vec3(), scene.drag as f32);
        self.bodies.push(self.level.add(object));
        self.place_body(index, body, scene.dt as f32);
        index
    }

    /// Puts one body where the scene has it, with its velocities.
    fn place_body(&self, index: usize, body: &Body, dt: f32) {
        self.bodies[index].borrow_mut().place(
            body.position.as_vec3(),
            body.orientation.as_quat(),
            Velocity {
                v: body.linear_velocity.as_vec3(),
                omega: body.angular_velocity.as_vec3(),
            },
            dt,
        );
    }

    /// Puts all bodies in place once all forces are there, since p* depends on them.
    fn place(&mut self, scene: &Scene) {
        for (index, body) in scene.bodies.iter().enumerate() {
            self.place_body(index, body, scene.dt as f32);
        }
        self.level.graph.update_world();
    }

    /// Turns a force of the scene into callbacks.
    fn add_force(&mut self, force: &Force) -> Result<(), String> {
        match force {
            Force::Magnets { poles, softening } => {
                let poles: Vec<_> = poles
                    .iter()
                    .map(|pole| {
                        let body = self.bodies[pole.body].clone();
                        (body, pole.position.as_vec3(), pole.strength as f32)
                    })
                    .collect();
                add_magnets(&poles, *softening as f32);
            }
            Force::Constant { body, force } => {
                let force = force.as_vec3();
                let mut object = self.bodies[*body].borrow_mut();
                object.add_force(Box::new(move |_| force));
            }
            Force::FixedPoint { body, arm } => {
                let mut object = self.bodies[*body].borrow_mut();
                let arm = arm.as_vec3();
                let point = object.position() - object.orientation() * arm;
                if !object.hold(FixedPoint { point, arm }) {
                    return Err(format!(
                        "the arm {arm} of a fixed point must lie along one of the body's axes"
                    ));
                }
            }
        }
        Ok(())
    }
}

/// The error for something that an engine doesn't model.
pub(crate) fn unsupported(
    entry: &EngineEntry,
    scene: &Scene,
    what: String,
    index: Option<usize>,
) -> LoadError {
    LoadError::Unsupported {
        engine: entry.name,
        chapter: entry.chapter,
        scene: scene.name.clone(),
        what,
        index,
    }
}
