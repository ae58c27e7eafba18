//! Chapter 4's engine: chapter 3's level of bodies that collide, and the joints between them.

use ch00_scenes::{
    Added, Body, Column, ContactPoint, Counters, Dissection, Drawing, Engine, EngineEntry,
    EngineInfo, Layer, LoadError, PassTime, Pull, Scene, Settings, State,
};
use ch02_rigid_bodies::{METHODS, Method};
use ch03_collision::layers::BodyView;
use ch03_collision::{CollisionEngine, PassClock};

use crate::layers::{self, AngleView, JointView};
use crate::{Assembly, RigidJoint};

/// Chapter 4's entry in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "objects",
    chapter: "ch04_ragdolls",
    methods: METHODS,
    load,
};

/// A level of rigid bodies with joints.
pub struct RagdollEngine {
    level: CollisionEngine,
    joints: Assembly,
    times: Vec<PassTime>,
}

/// Loads any scene; one of orbits alone goes to chapter 1.
fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    if !scene.orbits.is_empty() {
        return (ch01_hierarchy::ENGINE.load)(scene, &Settings::defaults());
    }
    Ok(Box::new(RagdollEngine::load(scene, settings)?))
}

impl RagdollEngine {
    /// Loads a scene without orbits.
    ///
    /// # Errors
    /// [`LoadError`] for an unknown method and a setting that it lacks.
    pub fn load(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        let mut level = CollisionEngine::load_bodies(&ENGINE, scene, settings)?;
        level.ignore_pairs(scene.joints.iter().map(ch00_scenes::Joint::bodies));
        let mut joints = Assembly::of(scene, level.bodies());
        level.begin(&mut joints, scene.dt as f32);
        Ok(Self {
            level,
            joints,
            times: Vec::new(),
        })
    }

    /// The joints.
    #[must_use]
    pub fn joints(&self) -> &Assembly {
        &self.joints
    }

    // ANCHOR: constraints
    /// The report's `constraintUpdate` of every ragdoll.
    fn constraint_update(&mut self) {
        match self.level.method() {
            Method::Printed => self.joints.constraint_update_printed(),
            Method::Corrected => self.joints.constraint_update(self.level.rules().sweeps),
        }
    }
    // ANCHOR_END: constraints
}

impl From<&RigidJoint> for JointView {
    fn from(joint: &RigidJoint) -> Self {
        let (parent, child) = joint.bodies();
        Self {
            parent: BodyView::from(&*parent.borrow()),
            child: BodyView::from(&*child.borrow()),
            points: joint.points(),
            angle: joint.angle().map(|angle| AngleView {
                rest: angle.rest(),
                limits: *angle.limits(),
            }),
        }
    }
}

impl Engine for RagdollEngine {
    fn info(&self) -> EngineInfo {
        self.level.info()
    }

    // ANCHOR: step
    fn step(&mut self, dt: f32) {
        let mut clock = PassClock::start();
        self.level.update_objects(dt);
        clock.note("objects update");
        self.constraint_update();
        clock.note("constraint update");
        self.level.gather_objects();
        clock.note("objects gather");
        self.level.find_pairs(dt);
        clock.note("broad phase");
        self.level.find_contacts(dt);
        clock.note("narrow phase");
        self.level.resolve(&mut self.joints, dt);
        clock.note("resolve");
        self.level.place_nodes();
        clock.note("scene graph");
        self.times = clock.times();
    }
    // ANCHOR_END: step

    fn read_state(&self, state: &mut State) {
        self.level.read_state(state);
    }

    fn write_state(&mut self, state: &State, dt: f32) {
        self.level.place_bodies(state, dt);
        self.joints.forget();
        self.level.begin(&mut self.joints, dt);
    }

    fn columns(&self) -> Vec<Column> {
        self.level.columns()
    }

    fn contacts(&self) -> Vec<ContactPoint> {
        self.level.contacts()
    }

    fn counters(&self) -> Counters {
        self.level.counters()
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn explain(&self) -> String {
        let sweeps = match self.level.method() {
            Method::Printed => "one walk, as printed".to_owned(),
            Method::Corrected => format!(
                "at most {} sweeps; with the contacts again as impulses and as nudges",
                self.level.rules().sweeps
            ),
        };
        self.level.explain_with(&format!(
            "Joints, after the objects' update: {} trees with {} joints, and {} joints that close loops; \
             {sweeps}. Bodies that a joint connects don't collide.",
            self.joints.ragdolls.len(),
            self.joints.joints().count() - self.joints.loops.len(),
            self.joints.loops.len(),
        ))
    }

    fn layer(&self, layer: Layer) -> Drawing {
        match layer {
            Layer::JointFrames => layers::frames(self.joints.joints().map(JointView::from)),
            Layer::Limits => layers::limits(self.joints.joints().map(JointView::from)),
            _ => self.level.layer(layer),
        }
    }

    fn layers(&self) -> &'static [Layer] {
        if self.joints.joints().next().is_some() {
            &Layer::ALL
        } else {
            self.level.layers()
        }
    }

    fn pairs(&self) -> &[(usize, usize)] {
        self.level.pairs()
    }

    fn dissect(&self, a: usize, b: usize, step: usize) -> Option<Dissection> {
        self.level.dissect(a, b, step)
    }

    fn add_body(&mut self, body: &Body, dt: f32) -> Added {
        self.level.add_body(body, dt)
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.level.pull(pull);
    }
}
