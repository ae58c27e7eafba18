//! Chapter 5's engine: what the window, the tests and the laboratory see of a world.

use ch00_scenes::{
    Added, Body, Cell, Column, ColumnData, ColumnInfo, ContactPoint, Counters, Dissection, Drawing,
    Edit, Engine, EngineEntry, EngineInfo, Layer, LoadError, Method as MethodInfo, PassTime, Pull,
    RemoveError, RowId, Scene, Settings, State, TableError, TableInfo,
};
use ch03_collision::{PassClock, Rules, check_settings, default_sweeps};
use glam::Vec3;

use crate::columns::{AnyTable, ColumnSpec};
use crate::layers;
use crate::plan::{self, Part, Plan};
use crate::systems::or_zero;
use crate::world::{ChangeError, Method, World};

/// Chapter 5's entry in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "properties",
    chapter: "ch05_properties",
    methods: METHODS,
    load,
};

/// The methods by name, the default first: those of chapters 2 to 4.
pub const METHODS: &[MethodInfo] = &[
    MethodInfo {
        name: "corrected",
        about: "the report's method with its errata mended; sweeps over the contacts",
    },
    MethodInfo {
        name: "printed",
        about: "the report's formulas as printed, one sweep, no friction",
    },
];

/// A world and the scene that it was loaded from.
pub struct PropertiesEngine {
    world: World,
    scene: Scene,
    times: Vec<PassTime>,
}

/// Loads any scene; one of orbits alone goes to chapter 1.
fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    if !scene.orbits.is_empty() {
        return (ch01_hierarchy::ENGINE.load)(scene, &Settings::defaults());
    }
    Ok(Box::new(PropertiesEngine::load(scene, settings)?))
}

impl PropertiesEngine {
    /// Loads a scene without orbits, with no more than it needs.
    ///
    /// # Errors
    /// [`LoadError`] for an unknown method, a setting that it lacks, and a fixed point that isn't on one
    /// of its body's axes.
    pub fn load(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        Self::load_with(scene, settings, Plan::of)
    }

    /// The same with another plan, such as [`Plan::full`].
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_with(
        scene: &Scene,
        settings: &Settings,
        plan: impl FnOnce(&Scene, Method) -> Plan,
    ) -> Result<Self, LoadError> {
        let name = ENGINE.method(settings)?.name;
        check_settings(name, settings)?;
        let method = match name {
            "printed" => Method::Printed,
            _ => Method::Corrected,
        };
        let rules = rules_for(scene, settings);
        let plan = plan(scene, method);
        let world = World::load(scene, method, rules, plan).map_err(|(what, index)| {
            LoadError::Unsupported {
                engine: ENGINE.name,
                chapter: ENGINE.chapter,
                scene: scene.name.clone(),
                what,
                index: Some(index),
            }
        })?;
        Ok(Self {
            world,
            scene: scene.clone(),
            times: Vec::new(),
        })
    }

    /// The scene as it is by now: its bodies are the world's, in order of row.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The columns, and what is done with them.
    #[must_use]
    pub fn world(&self) -> &World {
        &self.world
    }

    /// The same, to be changed.
    pub fn world_mut(&mut self) -> &mut World {
        &mut self.world
    }
}

/// What the scene and the user say about the resolution.
fn rules_for(scene: &Scene, settings: &Settings) -> Rules {
    let rules = Rules::default();
    Rules {
        sweeps: settings.sweeps.unwrap_or_else(|| default_sweeps(scene)),
        restitution_threshold: scene
            .restitution_threshold
            .map_or(rules.restitution_threshold, |threshold| threshold as f32),
        ..rules
    }
}

impl Engine for PropertiesEngine {
    fn info(&self) -> EngineInfo {
        let surroundings = &self.world.surroundings;
        let corrected = surroundings.method == Method::Corrected;
        EngineInfo {
            engine: ENGINE.name,
            method: surroundings.method.name(),
            threads: 1,
            device: "cpu".to_owned(),
            substeps: 1,
            sweeps: corrected.then_some(surroundings.rules.sweeps),
            real_size: 4,
            restitution_threshold: if corrected {
                f64::from(surroundings.rules.restitution_threshold)
            } else {
                0.0
            },
        }
    }

    // ANCHOR: step
    fn step(&mut self, dt: f32) {
        let mut clock = PassClock::start();
        self.world.step(dt, |system, _| clock.note(system));
        self.times = clock.times();
    }
    // ANCHOR_END: step

    fn read_state(&self, state: &mut State) {
        self.world.read_state(state);
    }

    fn write_state(&mut self, state: &State, dt: f32) {
        self.world.write_state(state, dt);
    }

    fn columns(&self) -> Vec<Column> {
        let bodies = &self.world.data.bodies;
        let rows: Vec<usize> = (0..bodies.rows()).collect();
        let kept = bodies.specs().iter().enumerate();
        kept.filter(|(place, _)| bodies.column(*place).is_kept())
            .map(|(place, spec)| Column {
                name: spec.symbol,
                unit: spec.unit,
                about: spec.about,
                data: bodies.column(place).cells(&rows),
            })
            .collect()
    }

    fn tables(&self) -> Vec<TableInfo> {
        let tables = self.world.data.tables().into_iter();
        let info = |table: &dyn AnyTable| TableInfo {
            name: table.name(),
            about: table.about(),
            rows: table.rows(),
            columns: table
                .specs()
                .iter()
                .map(|spec| self.column_info(table.name(), spec))
                .collect(),
        };
        tables.map(info).collect()
    }

    fn cells(&self, table: &str, column: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        Ok(self.world.column(table, column)?.cells(rows))
    }

    fn row_ids(&self, table: &str, rows: &[usize]) -> Vec<RowId> {
        let found = self.world.data.table(table);
        found.map_or_else(
            |_| Vec::new(),
            |table| rows.iter().filter_map(|&row| table.ids().id(row)).collect(),
        )
    }

    fn row_of(&self, table: &str, id: RowId) -> Option<usize> {
        self.world.data.table(table).ok()?.ids().row(id)
    }

    fn edit(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        self.world.edit(edit)
    }

    fn contacts(&self) -> Vec<ContactPoint> {
        let contacts = &self.world.data.contacts;
        let impulse = |c: usize| {
            or_zero::<Vec3>(&contacts.impact, c)
                + or_zero(&contacts.support, c) * contacts.normal[c]
                + or_zero(&contacts.rub, c)
        };
        (0..contacts.rows())
            .map(|c| ContactPoint {
                a: contacts.a[c] as usize,
                b: contacts.b[c] as usize,
                point: contacts.point[c].as_dvec3(),
                normal: contacts.normal[c].as_dvec3(),
                depth: f64::from(contacts.depth[c]),
                impulse: impulse(c).as_dvec3(),
            })
            .collect()
    }

    fn pairs(&self) -> &[(usize, usize)] {
        &self.world.broad.pairs
    }

    fn counters(&self) -> Counters {
        let counts = &self.world.counts;
        Counters {
            pairs: self.world.broad.pairs.len(),
            contacts: self.world.data.contacts.rows(),
            overflow: counts.unread_turns + counts.impacts_left + counts.unsure_touches,
            ..Counters::default()
        }
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn explain(&self) -> String {
        plan::explain(&self.scene, &self.world)
    }

    fn layer(&self, layer: Layer) -> Drawing {
        layers::draw(self, layer)
    }

    fn layers(&self) -> &'static [Layer] {
        layers::of(self)
    }

    fn dissect(&self, a: usize, b: usize, step: usize) -> Option<Dissection> {
        layers::dissect(self, a, b, step)
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        let added = self.world.add(&self.scene, body);
        added.map_err(|error| LoadError::Unsupported {
            engine: ENGINE.name,
            chapter: ENGINE.chapter,
            scene: self.scene.name.clone(),
            what: error.to_string(),
            index: None,
        })?;
        self.scene.bodies.push(body.clone());
        Ok(self.scene.bodies.len() - 1)
    }

    fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        self.scene.check_removal(body)?;
        let id = self.world.data.bodies.ids().id(body);
        let id = id.expect("the scene has the world's bodies");
        match self.world.remove(id) {
            Ok(()) => {}
            Err(ChangeError::Held(error)) => return Err(error),
            Err(error) => unreachable!("between steps, and the body is there: {error}"),
        }
        self.scene.remove_body(body).map(|_| ())
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.world.pull(&self.scene, pull);
    }
}

impl PropertiesEngine {
    /// What the schema and the plan say of a column.
    fn column_info(&self, table: &'static str, spec: &ColumnSpec) -> ColumnInfo {
        let why = self.world.plan.why_left_out(table, spec.name);
        ColumnInfo {
            name: spec.name,
            symbol: spec.symbol,
            unit: spec.unit,
            about: spec.about,
            kind: spec.kind,
            editable: spec.editable,
            left_out: why.map(str::to_owned),
        }
    }

    /// Whether the plan has a part.
    #[must_use]
    pub fn has(&self, part: Part) -> bool {
        self.world.plan.has(part)
    }
}
