//! From a scene to a world.

use ch00_maths::f32::impulse::Velocity;
use ch00_maths::f32::inertia::about_point;
use ch00_scenes::{Body as SceneBody, Force, Scene};
use ch03_collision::{Rules, Span};
use ch04_ragdolls::{Forest, JointSpec};
use glam::Vec3;

use super::{Counts, Method, Steps, Surroundings, World};
use crate::columns::{AnyTable, Table};
use crate::data::{
    Body, Data, FixedPoint, Joint, Motion, NONE, Pin, Pole, Push, Rod, Tree, Turn, limit_columns,
    shape_columns,
};
use crate::plan::Plan;
use crate::systems::broad_phase::BroadPhase;
use crate::systems::narrow_phase::Carried;

impl World {
    // ANCHOR: load
    /// Fills a world with a scene and brings it to its first step.
    ///
    /// # Errors
    /// What this scene has that the engine doesn't model, and the index of the force that is.
    pub fn load(
        scene: &Scene,
        method: Method,
        rules: Rules,
        plan: Plan,
    ) -> Result<Self, (String, usize)> {
        let mut data = Data::default();
        plan.apply(&mut data);
        for body in &scene.bodies {
            push_body(&mut data, body);
        }
        for (index, force) in scene.forces.iter().enumerate() {
            push_force(&mut data, scene, force, index as u32).map_err(|what| (what, index))?;
        }
        push_joints(&mut data, scene);
        let mut world = Self::around(data, scene, method, rules, plan);
        world.place(scene);
        if method == Method::Corrected {
            world.finish_joints();
        }
        world.begin(scene.dt as f32);
        Ok(world)
    }
    // ANCHOR_END: load

    fn around(data: Data, scene: &Scene, method: Method, rules: Rules, plan: Plan) -> Self {
        let mut ignored: Vec<_> = scene
            .joints
            .iter()
            .map(ch00_scenes::Joint::bodies)
            .map(|(a, b)| (a.min(b), a.max(b)))
            .collect();
        ignored.sort_unstable();
        ignored.dedup();
        let dt = scene.dt as f32;
        Self {
            data,
            plan,
            surroundings: Surroundings {
                method,
                gravity: scene.gravity.as_vec3(),
                drag: scene.drag as f32,
                rules,
            },
            broad: BroadPhase {
                ignored,
                ..BroadPhase::default()
            },
            carried: Carried::default(),
            involved: Vec::new(),
            steps: Steps {
                dt,
                before: dt,
                dt_last: dt,
                resolved: 0.0,
                span: Span { dt, longer: 1.0 },
            },
            counts: Counts::default(),
            running: None,
        }
    }

    /// Gives all bodies their velocities, once all forces are there, since p* depends on them.
    fn place(&mut self, scene: &Scene) {
        self.gather();
        for (row, body) in scene.bodies.iter().enumerate() {
            self.set_velocity(row, velocity_of(body));
        }
    }
}

/// A body's velocities in the engine's precision.
pub(super) fn velocity_of(body: &SceneBody) -> Velocity {
    Velocity {
        v: body.linear_velocity.as_vec3(),
        omega: body.angular_velocity.as_vec3(),
    }
}

// ANCHOR: push_body
/// Adds a body of the scene, at rest, to all tables that have a row a body.
pub(super) fn push_body(data: &mut Data, body: &SceneBody) -> ch00_scenes::RowId {
    data.motions.push(Motion::default());
    data.bodies.push(row_of(body))
}

/// A body of the scene, at rest, as a row.
pub(super) fn row_of(body: &SceneBody) -> Body {
    let shape = body.shape.single();
    let mass = body.mass as f32;
    let is_static = mass == 0.0;
    let inertia = shape.inertia(mass);
    let (kind, size) = shape_columns(&shape);
    let (p, q) = (body.position.as_vec3(), body.orientation.as_quat());
    Body {
        position: p,
        last_position: p,
        orientation: q,
        last_orientation: q,
        shape: kind,
        size,
        inverse_mass: if is_static { 0.0 } else { 1.0 / mass },
        inertia,
        inverse_inertia: if is_static {
            Vec3::ZERO
        } else {
            inertia.recip()
        },
        restitution: body.restitution as f32,
        friction: body.friction as f32,
        static_friction: body.static_friction() as f32,
        ..Body::default()
    }
}
// ANCHOR_END: push_body

/// Adds a force of the scene.
fn push_force(data: &mut Data, scene: &Scene, force: &Force, index: u32) -> Result<(), String> {
    match force {
        Force::Magnets { poles, softening } => {
            for pole in poles {
                data.poles.push(Pole {
                    body: pole.body as u32,
                    force: index,
                    place: pole.position.as_vec3(),
                    strength: pole.strength as f32,
                    softening: *softening as f32,
                });
            }
        }
        Force::Constant { body, force } => {
            data.pushes.push(Push {
                body: *body as u32,
                force: index,
                push: force.as_vec3(),
            });
        }
        Force::FixedPoint { body: row, arm } => {
            let arm = arm.as_vec3();
            let mass = scene.bodies[*row].mass as f32;
            let bodies = &mut data.bodies;
            let Some(moments) = about_point(bodies.inertia[*row], mass, arm) else {
                return Err(format!(
                    "the arm {arm} of a fixed point must lie along one of the body's axes"
                ));
            };
            bodies.inertia[*row] = moments;
            bodies.inverse_inertia[*row] = moments.recip();
            data.fixed_points.push(FixedPoint {
                body: *row as u32,
                force: index,
                point: bodies.position[*row] - bodies.orientation[*row] * arm,
                arm,
                weight: mass * scene.gravity.as_vec3(),
            });
        }
    }
    Ok(())
}

// ANCHOR: push_joints
/// Adds all joints in the order in which a step visits them: tree by tree, then what closes loops.
fn push_joints(data: &mut Data, scene: &Scene) {
    let forest = Forest::of(scene);
    for tree in &forest.trees {
        let first = data.joints.rows() as u32;
        for &joint in tree {
            push_joint(data, scene, joint);
        }
        let end = data.joints.rows() as u32;
        data.trees.push(Tree { first, end });
    }
    for &joint in &forest.loops {
        push_joint(data, scene, joint);
    }
}
// ANCHOR_END: push_joints

/// Adds a joint, and its pin or rod, and its limit.
fn push_joint(data: &mut Data, scene: &Scene, index: usize) {
    let joint = &scene.joints[index];
    let (parent, child) = joint.bodies();
    let spec = JointSpec::of(joint);
    let (kind, part) = match spec.distance {
        None => (0, data.pins.rows()),
        Some(_) => (1, data.rods.rows()),
    };
    match spec.distance {
        None => data.pins.push(Pin::default()),
        Some(length) => data.rods.push(Rod {
            length,
            ..Rod::default()
        }),
    };
    let limit = spec.limits.map(|limits| {
        let rest = spec.rest.unwrap_or_else(|| {
            let [one, two] = [parent, child].map(|row| data.bodies.orientation[row]);
            (one.conjugate() * two).normalize()
        });
        let mut row = limit_columns(&limits);
        row.rest = rest;
        data.limits.push(row);
        for _ in 0..ch04_ragdolls::MOST_ROWS {
            data.turns.push(Turn::default());
        }
        data.limits.rows() as u32 - 1
    });
    data.joints.push(Joint {
        parent: parent as u32,
        child: child as u32,
        scene_joint: index as u32,
        kind,
        part: part as u32,
        limit: limit.unwrap_or(NONE),
        anchor_parent: spec.anchors.parent,
        anchor_child: spec.anchors.child,
        ..Joint::default()
    });
}
