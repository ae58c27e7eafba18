//! The methods as an engine: what the window, the tests and the laboratory see of them.

use std::time::Instant;

use ch00_scenes::{
    Added, Body, Column, ColumnData, ContactPoint, Counters, Engine, EngineEntry, EngineInfo,
    Force, Joint as SceneJoint, LoadError, Loaded, PassTime, Pull, RemoveError, Scene, Settings,
    State,
};

use super::alone::{OFF_AXIS, has_axes};
use super::list::{LIST, Listed, METHODS};
use super::real::{ENGINE_NAME, Real, force, impulse, real, single, vector, wide};
use super::world::{Knobs, World};

/// The entry in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: ENGINE_NAME,
    chapter: CHAPTER,
    methods: &METHODS,
    load,
};

const CHAPTER: &str = "ch07_findings";

/// The most substeps and sweeps that one may ask for.
const MOST: u32 = 10_000;

/// A run of a method.
struct Run {
    scene: Scene,
    world: World,
    listed: Listed,
    knobs: Knobs,
    pull: Option<Pull>,
    times: Vec<PassTime>,
}

fn load(scene: &Scene, settings: &Settings) -> Loaded {
    let method = ENGINE.method(settings)?;
    let Some(listed) = LIST.iter().find(|listed| listed.method.name == method.name) else {
        unreachable!("the list of methods is made from this one");
    };
    let world = World::of(scene);
    if let Some((what, index)) = not_modelled(scene, &world, listed) {
        return Err(LoadError::Unsupported {
            engine: ENGINE.name,
            chapter: CHAPTER,
            scene: scene.name.clone(),
            what: format!("method `{}` has no {what}", method.name),
            index,
        });
    }
    Ok(Box::new(Run {
        knobs: knobs(listed, settings)?,
        scene: scene.clone(),
        world,
        listed: *listed,
        pull: None,
        times: Vec::new(),
    }))
}

fn knobs(listed: &Listed, settings: &Settings) -> Result<Knobs, LoadError> {
    let refuse = |setting, value: u32, why: String| LoadError::Setting {
        method: listed.method.name,
        setting,
        value: value.to_string(),
        why,
    };
    let within = |setting, value: u32| match value {
        1..=MOST => Ok(value),
        _ => Err(refuse(setting, value, format!("1 to {MOST} make sense"))),
    };
    if let Some(threads) = settings.threads.filter(|&threads| threads != 1) {
        let why = "the methods run on one thread".to_owned();
        return Err(refuse("threads", threads, why));
    }
    settings.refuse_sleeping(listed.method.name)?;
    let sweeps = match (settings.sweeps, listed.sweeps) {
        (Some(sweeps), None) => {
            let why = "it makes no sweeps".to_owned();
            return Err(refuse("sweeps", sweeps, why));
        }
        (sweeps, usual) => sweeps.or(usual).unwrap_or(1),
    };
    Ok(Knobs {
        substeps: within("substeps", settings.substeps.unwrap_or(listed.substeps))?,
        sweeps: within("sweeps", sweeps)?,
    })
}

/// What a scene has that a method doesn't, and where.
fn not_modelled(scene: &Scene, world: &World, listed: &Listed) -> Option<(String, Option<usize>)> {
    let say = |what: &str, index| Some((what.to_owned(), index));
    let magnets = |force: &Force| matches!(force, Force::Magnets { .. });
    if !scene.orbits.is_empty() {
        return say("prescribed motions (chapter 1 has)", None);
    }
    if let Some(index) = scene.forces.iter().position(magnets) {
        return say("magnets (chapter 2 has)", Some(index));
    }
    let printed =
        |joint: &SceneJoint| matches!(joint, SceneJoint::Ball { limits, .. } if limits.is_some());
    if let Some(index) = scene.joints.iter().position(printed) {
        return say("limits by Euler's angles (chapter 4 has)", Some(index));
    }
    if listed.touches {
        return None;
    }
    if !scene.joints.is_empty() {
        return say("joints: it moves every body alone", Some(0));
    }
    let bodies = &world.bodies;
    for pivot in &world.pivots {
        let mass = 1.0 / bodies.inverse_mass[pivot.body];
        if !has_axes(bodies.inertia[pivot.body], mass, pivot.arm) {
            return say(OFF_AXIS, Some(pivot.body));
        }
    }
    let held = |row: &usize| world.pivots.iter().any(|pivot| pivot.body == *row);
    let can_touch = (0..bodies.count()).filter(|row| !held(row));
    let moves = can_touch.clone().any(|row| bodies.moves(row));
    match can_touch.clone().count() {
        2.. if moves => say("contacts: it moves every body alone", None),
        _ => None,
    }
}

impl Run {
    /// Lets the mouse pull.
    fn tug(&mut self, dt: Real) {
        let Some(pull) = self.pull else { return };
        let (bodies, row) = (&mut self.world.bodies, pull.body);
        if row >= bodies.count() || !bodies.moves(row) {
            return;
        }
        let arm = bodies.attitude[row] * vector(pull.anchor);
        let stretch = vector(pull.target) - bodies.position[row] - arm;
        let velocity = impulse::Velocity {
            v: bodies.velocity[row],
            omega: bodies.angular_velocity[row],
        };
        let mass = 1.0 / bodies.inverse_mass[row];
        let (force, torque) = force::spring(mass, arm, stretch, velocity);
        let turned = bodies.turned_by(row, torque);
        bodies.velocity[row] += force * (dt / mass);
        bodies.angular_velocity[row] += turned * dt;
    }

    /// Builds everything anew after bodies came or went; what was pressed is forgotten.
    fn rebuild(&mut self, state: &State) {
        self.world = World::of(&self.scene);
        self.world.bodies.write(state);
    }

    fn state(&self) -> State {
        let mut state = State::default();
        self.world.bodies.read(&mut state);
        state
    }
}

impl Engine for Run {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: ENGINE.name,
            method: self.listed.method.name,
            threads: 1,
            device: "cpu".to_owned(),
            substeps: self.knobs.substeps,
            sweeps: self.listed.sweeps.map(|_| self.knobs.sweeps),
            real_size: size_of::<Real>() as u32,
            restitution_threshold: wide_number(self.world.restitution_threshold),
        }
    }

    fn step(&mut self, dt: f32) {
        let start = Instant::now();
        // The scene's own step, where it is that one: a single number would put the clock wrong.
        let exact = self.scene.dt;
        let dt = if dt == exact as f32 {
            exact
        } else {
            f64::from(dt)
        };
        self.tug(real(dt));
        (self.listed.step)(&mut self.world, real(dt), self.knobs);
        let time = start.elapsed();
        self.times = vec![PassTime { name: "step", time }];
    }

    fn read_state(&self, state: &mut State) {
        self.world.bodies.read(state);
    }

    fn write_state(&mut self, state: &State, _dt: f32) {
        self.rebuild(state);
    }

    fn columns(&self) -> Vec<Column> {
        let bodies = &self.world.bodies;
        let vectors = |name, unit, about, of: &[super::real::Vec3]| Column {
            name,
            unit,
            about,
            data: ColumnData::Vector(
                of[..bodies.count()]
                    .iter()
                    .map(|&v| single(v).to_array())
                    .collect(),
            ),
        };
        vec![
            vectors("position", "m", "Of the centre.", &bodies.position),
            vectors("velocity", "m/s", "Of the centre.", &bodies.velocity),
            vectors(
                "angular_velocity",
                "rad/s",
                "In the world.",
                &bodies.angular_velocity,
            ),
        ]
    }

    fn contacts(&self) -> Vec<ContactPoint> {
        let bodies = &self.world.bodies;
        let points = self.world.contacts.points.iter();
        let shown = points.map(|contact| {
            let touch = contact.touch(bodies);
            ContactPoint {
                a: contact.a,
                b: contact.b,
                point: wide(bodies.position[contact.a] + touch.arm_a),
                normal: -wide(touch.normal),
                depth: -wide_number(touch.gap),
                impulse: -wide(touch.normal * contact.impulse + contact.friction),
            }
        });
        shown.collect()
    }

    fn counters(&self) -> Counters {
        Counters {
            pairs: self.world.contacts.pairs,
            contacts: self.world.contacts.points.len(),
            ..Counters::default()
        }
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn explain(&self) -> String {
        let Listed { method, .. } = self.listed;
        format!(
            "{}: {}\n{} bodies, {} rows of joints, {} substeps, {} sweeps, numbers of {} bytes\n",
            method.name,
            method.about,
            self.world.bodies.count(),
            self.world.joints.len(),
            self.knobs.substeps,
            self.knobs.sweeps,
            size_of::<Real>(),
        )
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        if !self.listed.touches {
            return Err(LoadError::Unsupported {
                engine: ENGINE.name,
                chapter: CHAPTER,
                scene: self.scene.name.clone(),
                what: format!("method `{}` has no contacts", self.listed.method.name),
                index: None,
            });
        }
        let mut state = self.state();
        self.scene.bodies.push(body.clone());
        state.push(
            body.position,
            body.orientation,
            body.linear_velocity,
            body.angular_velocity,
        );
        self.rebuild(&state);
        Ok(self.scene.bodies.len() - 1)
    }

    fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        let mut state = self.state();
        self.scene.remove_body(body)?;
        state.position.remove(body);
        state.orientation.remove(body);
        state.linear_velocity.remove(body);
        state.angular_velocity.remove(body);
        self.rebuild(&state);
        Ok(())
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.pull = pull;
    }
}

fn wide_number(x: Real) -> f64 {
    wide(super::real::Vec3::splat(x)).x
}
