//! The engine `objects` as far as chapter 1 has it: a level whose game objects follow
//! prescribed orbits. Nothing falls, nothing touches.

use std::time::Duration;

use ch00_scenes::{
    Added, Body, Column, ColumnData, Drawing, Engine, EngineEntry, EngineInfo, Layer, LoadError,
    Method, PassTime, Pull, Scene, Settings, State,
};
use glam::{DVec3, Vec3};
use web_time::Instant;

use crate::picture::{frames, write_tree};
use crate::{Level, NodeId, Orrery, SceneGraph, Transform};

const METHOD: Method = Method {
    name: "hierarchy",
    about: "Prescribed orbits as nested nodes of a scene graph; no forces, no collisions.",
};

/// Chapter 1 in the lists of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "objects",
    chapter: "ch01_hierarchy",
    methods: &[METHOD],
    load,
};

/// Chapter 1's engine with a scene in it.
struct Objects {
    level: Level,
    orrery: Orrery,
    scene: String,
    /// A body's node and how long its axes are drawn, m.
    bodies: Vec<(NodeId, f32)>,
    pass_times: [PassTime; 3],
}

fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    let method = ENGINE.method(settings)?;
    check_settings(method, settings)?;
    check_scene(scene)?;
    Ok(Box::new(Objects::new(scene)))
}

fn unsupported(scene: &str, what: &str, index: Option<usize>) -> LoadError {
    LoadError::Unsupported {
        engine: ENGINE.name,
        chapter: ENGINE.chapter,
        scene: scene.to_owned(),
        what: what.to_owned(),
        index,
    }
}

fn check_settings(method: &Method, settings: &Settings) -> Result<(), LoadError> {
    let absent = [
        ("sweeps", settings.sweeps, "there are no contacts to solve"),
        (
            "substeps",
            settings.substeps,
            "orbits are exact at any step",
        ),
        (
            "threads",
            settings.threads.filter(|threads| *threads != 1),
            "game objects share one level, and one thread",
        ),
    ];
    for (setting, value, why) in absent {
        if let Some(value) = value {
            return Err(LoadError::Setting {
                method: method.name,
                setting,
                value: value.to_string(),
                why: why.to_owned(),
            });
        }
    }
    settings.refuse_sleeping(method.name)
}

/// By body: whether an orbit moves it.
fn on_orbit(scene: &Scene) -> Vec<bool> {
    let mut on_orbit = vec![false; scene.bodies.len()];
    for orbit in &scene.orbits {
        on_orbit[orbit.body] = true;
    }
    on_orbit
}

fn check_scene(scene: &Scene) -> Result<(), LoadError> {
    let on_orbit = on_orbit(scene);
    let first_free =
        (0..scene.bodies.len()).find(|&i| !scene.bodies[i].is_static() && !on_orbit[i]);
    if first_free.is_some() {
        let what = "a body that no orbit moves needs chapter 2 (ch02_rigid_bodies)";
        return Err(unsupported(&scene.name, what, first_free));
    }
    if !scene.forces.is_empty() {
        let what = "forces need chapter 2 (ch02_rigid_bodies)";
        return Err(unsupported(&scene.name, what, Some(0)));
    }
    if !scene.joints.is_empty() {
        let what = "joints need chapter 4 (ch04_ragdolls)";
        return Err(unsupported(&scene.name, what, Some(0)));
    }
    Ok(())
}

impl Objects {
    fn new(scene: &Scene) -> Self {
        let mut level = Level::new();
        let mut nodes = vec![None; scene.bodies.len()];
        let on_orbit = on_orbit(scene);
        for (index, body) in scene.bodies.iter().enumerate() {
            if !on_orbit[index] {
                nodes[index] = Some(add_static(&mut level.graph, index, body));
            }
        }
        let orrery = Orrery::add_to(&mut level, scene, &mut nodes);
        level.graph.update_world();
        let axes = scene.bodies.iter().map(axis_length);
        Self {
            level,
            orrery,
            scene: scene.name.clone(),
            // Every body has a node by now: a static one its own, another that of its orbit.
            bodies: nodes.into_iter().flatten().zip(axes).collect(),
            pass_times: PASSES.map(|name| PassTime {
                name,
                time: Duration::ZERO,
            }),
        }
    }

    /// Where a body is in the body that it circles, through its carrier.
    fn local(&self, body: usize) -> Transform {
        let (node, _) = self.bodies[body];
        let graph = &self.level.graph;
        let carrier = graph.parent(node);
        carrier.map_or(graph.local(node), |carrier| {
            graph.local(carrier) * graph.local(node)
        })
    }

    /// How many nodes are above a body's own.
    fn depth(&self, body: usize) -> usize {
        let graph = &self.level.graph;
        let parent_of = |id: &NodeId| graph.parent(*id);
        std::iter::successors(Some(self.bodies[body].0), parent_of).count() - 1
    }

    fn vectors(&self, get: impl Fn(usize) -> Vec3) -> ColumnData {
        ColumnData::Vector(
            (0..self.bodies.len())
                .map(|body| get(body).into())
                .collect(),
        )
    }

    fn quaternions(&self, get: impl Fn(usize) -> Transform) -> ColumnData {
        let all = (0..self.bodies.len()).map(|body| get(body).rotation.to_array());
        ColumnData::Quaternion(all.collect())
    }

    fn world(&self, body: usize) -> Transform {
        self.level.graph.world(self.bodies[body].0)
    }
}

const PASSES: [&str; 3] = [
    "gather objects",
    "update objects",
    "update world transforms",
];

fn add_static(graph: &mut SceneGraph, index: usize, body: &Body) -> NodeId {
    let place = Transform::new(body.position.as_vec3(), body.orientation.as_quat());
    graph.add(format!("body {index}"), None, place)
}

/// Axes stand out of the body by half its size.
fn axis_length(body: &Body) -> f32 {
    1.5 * body.shape.bounding_radius() as f32
}

impl Engine for Objects {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: ENGINE.name,
            method: METHOD.name,
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
        let level = &mut self.level;
        let start = Instant::now();
        level.gather_objects();
        let gathered = Instant::now();
        level.update_objects(dt);
        let updated = Instant::now();
        level.graph.update_world();
        let times = [gathered - start, updated - gathered, updated.elapsed()];
        for (pass, time) in self.pass_times.iter_mut().zip(times) {
            pass.time = time;
        }
    }
    // ANCHOR_END: step

    // ANCHOR: read_state
    fn read_state(&self, state: &mut State) {
        state.clear();
        for body in 0..self.bodies.len() {
            let world = self.world(body);
            let (position, orientation) = (world.translation, world.rotation);
            let (position, orientation) = (position.as_dvec3(), orientation.as_dquat());
            state.push(position, orientation, DVec3::ZERO, DVec3::ZERO);
        }
        self.orrery.read_into(&self.level.graph, state);
    }
    // ANCHOR_END: read_state

    fn write_state(&mut self, state: &State, _dt: f32) {
        self.orrery.take_over(&mut self.level, state);
    }

    fn columns(&self) -> Vec<Column> {
        let column = |name, unit, about, data| Column {
            name,
            unit,
            about,
            data,
        };
        let depths = (0..self.bodies.len()).map(|body| self.depth(body) as f32);
        vec![
            column(
                "local translation",
                "m",
                "Where the body is in the frame of what it circles.",
                self.vectors(|body| self.local(body).translation),
            ),
            column(
                "local rotation",
                "",
                "How it is turned in that frame.",
                self.quaternions(|body| self.local(body)),
            ),
            column(
                "world translation",
                "m",
                "Where the body is.",
                self.vectors(|body| self.world(body).translation),
            ),
            column(
                "world rotation",
                "",
                "Body axes to world axes.",
                self.quaternions(|body| self.world(body)),
            ),
            column(
                "depth",
                "",
                "Nodes above the body's own; two a level, as carriers are nodes.",
                ColumnData::Scalar(depths.collect()),
            ),
        ]
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.pass_times.to_vec()
    }

    fn explain(&self) -> String {
        let (bodies, orbits) = (self.bodies.len(), self.orrery.members().len());
        let mut text = format!(
            "{orbits} of {bodies} bodies are on orbits; the others stand still.\n\
             An orbit is a game object with two nodes: a carrier that travels, and below it the body \
             that spins.\n\
             A step: game objects gather, game objects update their local transforms, then world \
             transforms follow from the root to the leaves.\n\
             Angles come from the time in f64, so an orbit is exact at any step size and never drifts.\n",
        );
        for (id, node) in self.level.graph.iter() {
            if node.parent().is_none() {
                write_tree(&mut text, &self.level.graph, id, 0);
            }
        }
        text
    }

    fn layer(&self, layer: Layer) -> Drawing {
        match layer {
            Layer::Frames => frames(&self.level.graph, &self.bodies),
            _ => Drawing::default(),
        }
    }

    fn layers(&self) -> &'static [Layer] {
        &[Layer::Frames]
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        let index = self.bodies.len();
        if !body.is_static() {
            let what = "a free body needs chapter 2 (ch02_rigid_bodies)";
            return Err(unsupported(&self.scene, what, Some(index)));
        }
        let node = add_static(&mut self.level.graph, index, body);
        self.bodies.push((node, axis_length(body)));
        Ok(index)
    }

    /// Does nothing: an orbit can't be pulled away from.
    fn pull(&mut self, _pull: Option<Pull>) {}
}
