//! Chapter 3's engine: a level of rigid bodies and a collision tree.

use ch00_scenes::{
    Added, Body, Column, ContactPoint, Counters, Dissection, Drawing, Engine, EngineEntry,
    EngineInfo, Layer, LoadError, PassTime, Pull, Scene, Settings, State,
};
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::{Loaded, METHODS, Method, RigidBody, load_bodies};

use crate::checks::{check_settings, unsupported};
use crate::layers::{self, BodyView};
use crate::{
    CollisionTree, Contact, Links, Margins, NoLinks, PassClock, Rules, Span, default_sweeps,
    dissect, placed, resolve_corrected, resolve_printed,
};

/// Chapter 3's entry in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "objects",
    chapter: "ch03_collision",
    methods: METHODS,
    load,
};

/// A level of rigid bodies that collide.
pub struct CollisionEngine {
    method: Method,
    rules: Rules,
    scene: Scene,
    world: Loaded,
    tree: CollisionTree,
    contacts: Vec<Contact>,
    /// The last step, s; 0 before it.
    last_dt: f32,
    /// Impacts that the sweeps did not get to, since loading.
    impacts_left: usize,
    times: Vec<PassTime>,
}

/// Loads a scene of balls and boxes without joints; one of orbits alone goes to chapter 1.
fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    if !scene.orbits.is_empty() {
        return (ch01_hierarchy::ENGINE.load)(scene, &Settings::defaults());
    }
    Ok(Box::new(CollisionEngine::load(scene, settings)?))
}

impl CollisionEngine {
    /// Loads a scene of balls and boxes without joints.
    ///
    /// # Errors
    /// [`LoadError`] for an unknown method, a setting that it lacks, joints, and shapes whose
    /// contacts aren't modelled.
    pub fn load(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        if !scene.joints.is_empty() {
            let what = "joints are not modelled yet; chapter 4 (ch04_ragdolls) runs it".to_owned();
            return Err(unsupported(scene, what, Some(0)));
        }
        let mut engine = Self::load_bodies(&ENGINE, scene, settings)?;
        engine.begin(&mut NoLinks, scene.dt as f32);
        Ok(engine)
    }

    /// The same for another engine that is built on this one: joints are its business.
    ///
    /// # Errors
    /// [`LoadError`] for an unknown method and a setting that it lacks.
    pub fn load_bodies(
        entry: &EngineEntry,
        scene: &Scene,
        settings: &Settings,
    ) -> Result<Self, LoadError> {
        let method = Method::of(entry, settings)?;
        check_settings(method.name(), settings)?;
        let world = load_bodies(entry, scene, method)?;
        Ok(Self {
            method,
            rules: rules_for(scene, settings),
            scene: scene.clone(),
            world,
            tree: CollisionTree::default(),
            contacts: Vec::new(),
            last_dt: 0.0,
            impacts_left: 0,
            times: Vec::new(),
        })
    }

    // ANCHOR: begin
    /// Resolves what touches at the start, before the first step of `dt` seconds. Bodies that begin on a
    /// floor would else fall for a step before it holds them.
    pub fn begin(&mut self, links: &mut impl Links, dt: f32) {
        if self.method == Method::Printed {
            return;
        }
        self.find_pairs(dt);
        self.find_contacts(dt);
        self.resolve(links, dt);
        for body in &self.world.bodies {
            body.borrow_mut().begin_now();
        }
    }
    // ANCHOR_END: begin

    /// Puts every body where `state` says, and forgets what touched.
    pub fn place_bodies(&mut self, state: &State, dt: f32) {
        self.contacts.clear();
        self.world.write_state(state, dt);
    }

    /// The method in use.
    #[must_use]
    pub fn method(&self) -> Method {
        self.method
    }

    /// What the corrected method may choose.
    #[must_use]
    pub fn rules(&self) -> Rules {
        self.rules
    }

    /// The bodies, by the scene's index.
    #[must_use]
    pub fn bodies(&self) -> &[Shared<RigidBody>] {
        &self.world.bodies
    }

    /// Pairs of bodies that pass through each other, since a joint connects them.
    pub fn ignore_pairs(&mut self, pairs: impl IntoIterator<Item = (usize, usize)>) {
        self.tree.ignore_pairs(pairs);
    }

    /// Every body advances by `dt` seconds.
    pub fn update_objects(&mut self, dt: f32) {
        self.world.level.update_objects(dt);
    }

    /// Every body asks its forces.
    pub fn gather_objects(&mut self) {
        self.world.level.gather_objects();
    }

    /// The pairs that may touch.
    pub fn find_pairs(&mut self, dt: f32) {
        let margins = self.margins(dt);
        self.tree.find_pairs(&self.world.bodies, margins);
    }

    /// Where they do.
    pub fn find_contacts(&mut self, dt: f32) {
        let margins = self.margins(dt);
        self.tree
            .find_contacts(&self.world.bodies, margins, &mut self.contacts);
    }

    /// The report's method looks at what overlaps, and at nothing else.
    fn margins(&self, dt: f32) -> Margins {
        match self.method {
            Method::Printed => Margins::default(),
            Method::Corrected => self.rules.margins(dt),
        }
    }

    // ANCHOR: resolve
    /// Parts what overlaps, as the method says. The printed one knows of no links.
    pub fn resolve(&mut self, links: &mut impl Links, dt: f32) {
        let span = self.next_span(dt);
        let bodies = &self.world.bodies;
        match self.method {
            Method::Printed => resolve_printed(bodies, &mut self.contacts),
            Method::Corrected => {
                self.impacts_left +=
                    resolve_corrected(bodies, &mut self.contacts, links, self.rules, span);
            }
        }
    }
    // ANCHOR_END: resolve

    /// A step of `dt` seconds, beside the last one.
    fn next_span(&mut self, dt: f32) -> Span {
        let longer = if self.last_dt > 0.0 {
            dt / self.last_dt
        } else {
            1.0
        };
        self.last_dt = dt;
        Span { dt, longer }
    }

    /// What it does with the scene and why, and what becomes of joints.
    #[must_use]
    pub fn explain_with(&self, joints: &str) -> String {
        let resolution = match self.method {
            Method::Printed => "every contact once, as printed, no friction".to_owned(),
            Method::Corrected => format!(
                "at most {} sweeps each for pushing apart (three times as many where bodies are far off), \
                 impacts and resting contact with Coulomb friction; \
                 impacts under {} m/s don't bounce; depths under {} mm are left alone",
                self.rules.sweeps,
                self.rules.restitution_threshold,
                self.rules.slop * 1000.0
            ),
        };
        format!(
            "scene `{}` as rigid bodies that collide, method {}:\n\
             1. objects update: p, q by velocity-less Verlet from p*, q* ({} bodies, {} of them static)\n\
             2. objects gather: {} forces of the scene as callbacks, gravity as an acceleration\n\
             3. broad phase: bounding boxes in a KD-tree, built anew each step\n\
             4. narrow phase: balls and capsules against each other, and balls against boxes and cylinders, in \
             closed form; all other pairs by GJK and EPA, with up to four contact points\n\
             5. resolve: {resolution}\n\
             6. scene graph: world transforms\n\
             {joints} Held bodies don't collide.\n",
            self.scene.name,
            self.method.name(),
            self.scene.bodies.len(),
            self.scene.bodies.len() - self.scene.dynamic_count(),
            self.scene.forces.len(),
        )
    }

    /// The bodies as drawings see them.
    fn views(&self) -> Vec<BodyView> {
        let bodies = self.world.bodies.iter();
        bodies.map(|body| BodyView::from(&*body.borrow())).collect()
    }

    /// Writes the bodies' places into the scene graph.
    pub fn place_nodes(&mut self) {
        let graph = &mut self.world.level.graph;
        for body in &self.world.bodies {
            body.borrow().place_node(graph);
        }
        graph.update_world();
    }
}

/// The method's own rules, with what the scene and the user say instead.
fn rules_for(scene: &Scene, settings: &Settings) -> Rules {
    let defaults = Rules::default();
    Rules {
        sweeps: settings.sweeps.unwrap_or_else(|| default_sweeps(scene)),
        restitution_threshold: scene
            .restitution_threshold
            .map_or(defaults.restitution_threshold, |speed| speed as f32),
        ..defaults
    }
}

impl From<&RigidBody> for BodyView {
    fn from(body: &RigidBody) -> Self {
        Self {
            shape: *body.collider(),
            position: body.position(),
            orientation: body.orientation(),
            mass: (!body.is_static()).then(|| body.mass()),
        }
    }
}

impl Engine for CollisionEngine {
    fn info(&self) -> EngineInfo {
        let corrected = self.method == Method::Corrected;
        EngineInfo {
            engine: ENGINE.name,
            method: self.method.name(),
            threads: 1,
            device: "cpu".to_owned(),
            substeps: 1,
            sweeps: Some(if corrected { self.rules.sweeps } else { 1 }),
            real_size: 4,
            restitution_threshold: if corrected {
                f64::from(self.rules.restitution_threshold)
            } else {
                0.0
            },
        }
    }

    // ANCHOR: step
    fn step(&mut self, dt: f32) {
        let mut clock = PassClock::start();
        self.update_objects(dt);
        clock.note("objects update");
        self.gather_objects();
        clock.note("objects gather");
        self.find_pairs(dt);
        clock.note("broad phase");
        self.find_contacts(dt);
        clock.note("narrow phase");
        self.resolve(&mut NoLinks, dt);
        clock.note("resolve");
        self.place_nodes();
        clock.note("scene graph");
        self.times = clock.times();
    }
    // ANCHOR_END: step

    fn read_state(&self, state: &mut State) {
        self.world.read_state(state);
    }

    fn write_state(&mut self, state: &State, dt: f32) {
        self.place_bodies(state, dt);
        self.begin(&mut NoLinks, dt);
    }

    fn columns(&self) -> Vec<Column> {
        self.world.columns()
    }

    fn contacts(&self) -> Vec<ContactPoint> {
        self.contacts
            .iter()
            .map(|contact| ContactPoint {
                a: contact.a,
                b: contact.b,
                point: contact.point.as_dvec3(),
                normal: contact.normal.as_dvec3(),
                depth: f64::from(contact.depth),
                impulse: contact.impulse.as_dvec3(),
            })
            .collect()
    }

    fn counters(&self) -> Counters {
        Counters {
            pairs: self.tree.pair_count(),
            contacts: self.contacts.len(),
            overflow: self.impacts_left + self.world.unread_turns() + self.tree.unsure_touches(),
            ..Counters::default()
        }
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn explain(&self) -> String {
        self.explain_with("Joints are chapter 4.")
    }

    fn layer(&self, layer: Layer) -> Drawing {
        let tree = &self.tree;
        match layer {
            Layer::Aabbs => layers::boxes(tree.boxes(), tree.pairs(), &self.views()),
            Layer::Cells => layers::cells(&tree.cells()),
            Layer::Contacts => layers::contacts(&self.contacts(), &self.views()),
            Layer::Frames => layers::frames(&self.views()),
            Layer::JointFrames | Layer::Limits => Drawing::default(),
        }
    }

    fn layers(&self) -> &'static [Layer] {
        &[Layer::Aabbs, Layer::Cells, Layer::Contacts, Layer::Frames]
    }

    fn dissect(&self, a: usize, b: usize, step: usize) -> Option<Dissection> {
        let (a, b) = (self.world.bodies.get(a)?, self.world.bodies.get(b)?);
        Some(dissect(&placed(&a.borrow()), &placed(&b.borrow()), step))
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        let index = self.world.add(&self.scene, body, self.method);
        Ok(index)
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.world.pull(pull);
    }
}
