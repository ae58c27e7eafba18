//! The rigid bodies of chapter 2 as an [`Engine`]: they fly, spin and pull each other, and pass
//! through each other, since collisions are chapter 3.

use ch00_maths::f32::impulse::Velocity;
use ch00_scenes::{
    Added, Body, Column, ColumnData, Counters, Engine, EngineEntry, EngineInfo, LoadError, Pull,
    Scene, Settings, State,
};
use glam::{Quat, Vec3};

use crate::load::unsupported;
use crate::{Loaded, METHODS, Method, RigidBody, Spring, load_bodies};

/// Chapter 2's entry in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "objects",
    chapter: "ch02_rigid_bodies",
    methods: METHODS,
    load,
};

/// A level of rigid bodies that don't collide.
pub struct RigidBodyEngine {
    method: Method,
    scene: Scene,
    world: Loaded,
}

/// Loads a scene without joints; one of orbits alone goes to chapter 1.
fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    if !scene.orbits.is_empty() {
        return (ch01_hierarchy::ENGINE.load)(scene, &Settings::defaults());
    }
    if !scene.joints.is_empty() {
        let what = "joints are not modelled yet".to_owned();
        return Err(unsupported(&ENGINE, scene, what, None));
    }
    refuse_unused(settings)?;
    let method = Method::of(&ENGINE, settings)?;
    Ok(Box::new(RigidBodyEngine {
        method,
        world: load_bodies(&ENGINE, scene, method)?,
        scene: scene.clone(),
    }))
}

/// Sweeps, substeps and threads mean nothing here.
fn refuse_unused(settings: &Settings) -> Result<(), LoadError> {
    let flags = [
        (
            "sweeps",
            settings.sweeps,
            "bodies don't collide in this chapter",
        ),
        (
            "substeps",
            settings.substeps,
            "this method makes whole steps",
        ),
        (
            "threads",
            settings.threads.filter(|&n| n != 1),
            "this engine has one thread",
        ),
    ];
    for (setting, value, why) in flags {
        if let Some(value) = value {
            return Err(LoadError::Setting {
                method: "corrected, printed",
                setting,
                value: value.to_string(),
                why: why.to_owned(),
            });
        }
    }
    settings.refuse_sleeping("corrected, printed")
}

impl Engine for RigidBodyEngine {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: ENGINE.name,
            method: self.method.name(),
            threads: 1,
            device: "cpu".to_owned(),
            substeps: 1,
            sweeps: None,
            real_size: 4,
            restitution_threshold: 0.0,
        }
    }

    // ANCHOR: step
    fn step(&mut self, dt: f32) {
        self.world.level.update_objects(dt);
        self.world.level.gather_objects();
        self.world.level.graph.update_world();
    }
    // ANCHOR_END: step

    fn read_state(&self, state: &mut State) {
        self.world.read_state(state);
    }

    fn write_state(&mut self, state: &State, dt: f32) {
        self.world.write_state(state, dt);
    }

    fn columns(&self) -> Vec<Column> {
        self.world.columns()
    }

    fn counters(&self) -> Counters {
        Counters {
            overflow: self.world.unread_turns(),
            ..Counters::default()
        }
    }

    fn explain(&self) -> String {
        format!(
            "scene `{}` as rigid bodies, method {}:\n\
             1. objects update: p, q by velocity-less Verlet from p*, q* ({} bodies, {} of them static)\n\
             2. objects gather: {} forces of the scene as callbacks, gravity as an acceleration\n\
             3. world transforms\n\
             Left out: collisions (chapter 3) and joints (chapter 4).\n",
            self.scene.name,
            self.method.name(),
            self.scene.bodies.len(),
            self.scene.bodies.len() - self.scene.dynamic_count(),
            self.scene.forces.len(),
        )
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        Ok(self.world.add(&self.scene, body, self.method))
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.world.pull(pull);
    }
}

impl Loaded {
    /// Where every body is, in the scene's order.
    pub fn read_state(&self, state: &mut State) {
        state.clear();
        for body in &self.bodies {
            let body = body.borrow();
            let velocity = body.velocity();
            state.push(
                body.position().as_dvec3(),
                body.orientation().as_dquat(),
                velocity.v.as_dvec3(),
                velocity.omega.as_dvec3(),
            );
        }
    }

    /// Puts every body where `state` says; callbacks are asked once all are there.
    pub fn write_state(&mut self, state: &State, dt: f32) {
        for _ in 0..2 {
            for (i, body) in self.bodies.iter().enumerate() {
                body.borrow_mut().place(
                    state.position[i].as_vec3(),
                    state.orientation[i].as_quat(),
                    Velocity {
                        v: state.linear_velocity[i].as_vec3(),
                        omega: state.angular_velocity[i].as_vec3(),
                    },
                    dt,
                );
            }
        }
    }

    /// Ties a body to the mouse, and lets go of all others.
    pub fn pull(&mut self, pull: Option<Pull>) {
        for (i, body) in self.bodies.iter().enumerate() {
            let spring = pull.filter(|pull| pull.body == i).map(|pull| Spring {
                anchor: pull.anchor.as_vec3(),
                target: pull.target.as_vec3(),
            });
            body.borrow_mut().set_spring(spring);
        }
    }

    /// Turns that were too fast to be read, of all bodies since loading.
    #[must_use]
    pub fn unread_turns(&self) -> usize {
        let count = |body: &ch01_hierarchy::Shared<RigidBody>| body.borrow().unread_turns();
        self.bodies.iter().map(count).sum()
    }

    /// The properties of a rigid body, each gathered from all objects.
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        vec![
            self.vectors("p", "m", "position", RigidBody::position),
            self.vectors("p*", "m", "position one step ago", RigidBody::last_position),
            self.quaternions("q", "orientation", RigidBody::orientation),
            self.quaternions(
                "q*",
                "orientation one step ago",
                RigidBody::last_orientation,
            ),
            self.vectors("v", "m/s", "linear velocity", |b| b.velocity().v),
            self.vectors("ω", "rad/s", "angular velocity, world axes", |b| {
                b.velocity().omega
            }),
            self.vectors("a", "m/s²", "acceleration", RigidBody::acceleration),
            self.scalars(
                "m",
                "kg",
                "mass; infinite for static bodies",
                RigidBody::mass,
            ),
            self.vectors(
                "I",
                "kg m²",
                "principal moments of inertia",
                RigidBody::inertia,
            ),
        ]
    }

    fn vectors(
        &self,
        name: &'static str,
        unit: &'static str,
        about: &'static str,
        get: impl Fn(&RigidBody) -> Vec3,
    ) -> Column {
        let values = self.bodies.iter().map(|b| get(&b.borrow()).to_array());
        let data = ColumnData::Vector(values.collect());
        Column {
            name,
            unit,
            about,
            data,
        }
    }

    fn quaternions(
        &self,
        name: &'static str,
        about: &'static str,
        get: impl Fn(&RigidBody) -> Quat,
    ) -> Column {
        let values = self.bodies.iter().map(|b| get(&b.borrow()).to_array());
        Column {
            name,
            unit: "",
            about,
            data: ColumnData::Quaternion(values.collect()),
        }
    }

    fn scalars(
        &self,
        name: &'static str,
        unit: &'static str,
        about: &'static str,
        get: impl Fn(&RigidBody) -> f32,
    ) -> Column {
        let values = self.bodies.iter().map(|b| get(&b.borrow()));
        Column {
            name,
            unit,
            about,
            data: ColumnData::Scalar(values.collect()),
        }
    }
}
