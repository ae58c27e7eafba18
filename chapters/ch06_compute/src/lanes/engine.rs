//! Engine `lanes`: what the window, the tests and the laboratory see of it.

use ch00_scenes::{
    Added, Body, Column, ColumnData, ContactPoint, Counters, Engine, EngineEntry, EngineInfo,
    LoadError, Method, PassTime, Pull, RemoveError, Scene, Settings, State, TableError, TableInfo,
};
use ch03_collision::PassClock;
use glam::Vec3;

use super::Lanes;
use super::forces::Spring;
use super::sleep::KeptPair;
use super::threads::{MOST_THREADS, Threads};
use crate::own_row::contact::{Contact, touching};
use crate::own_row::side::Side;
use crate::rows::{FieldSpec, Impulse, Manifold, WgslType};
use crate::rules::{COLOURED, METHOD, Method as Solver, Rules};
use crate::schema::{RowColumn, RowTable};

/// The entry of engine `lanes` in a list of engines.
pub const ENGINE: EngineEntry = EngineEntry {
    name: "lanes",
    chapter: "ch06_compute",
    methods: METHODS,
    load,
};

/// The method of own rows, which engine `compute` has too.
pub const OWN_ROW: Method = Method {
    name: METHOD,
    about: "every row reads any and writes itself; substeps, impulses kept from step to step",
};

/// Its methods.
pub const METHODS: &[Method] = &[
    OWN_ROW,
    Method {
        name: COLOURED,
        about: "pairs that share no body go together, one colour after another (Gauss-Seidel); fewer substeps",
    },
];

/// What the schema says of an attitude, which is a row by itself.
const ATTITUDE: &[FieldSpec] = &[FieldSpec {
    name: "attitude",
    symbol: "q",
    unit: "",
    about: "Body to world.",
    wgsl: <glam::Quat as WgslType>::WGSL,
    offset: 0,
}];

/// A run and the scene that it was loaded from.
pub struct LanesEngine {
    lanes: Lanes,
    scene: Scene,
    times: Vec<PassTime>,
}

/// Loads any scene; one of orbits alone goes to chapter 1.
fn load(scene: &Scene, settings: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    if !scene.orbits.is_empty() {
        return (ch01_hierarchy::ENGINE.load)(scene, &Settings::defaults());
    }
    Ok(Box::new(LanesEngine::load(scene, settings)?))
}

/// What an engine of this chapter says of a scene that it can't take.
#[must_use]
pub fn unsupported(
    engine: &'static str,
    scene: &Scene,
    (what, index): (String, usize),
) -> LoadError {
    LoadError::Unsupported {
        engine,
        chapter: "ch06_compute",
        scene: scene.name.clone(),
        what,
        index: Some(index),
    }
}

/// As many threads as the user wants, or as the machine has.
fn threads(settings: &Settings) -> Result<Threads, LoadError> {
    let refuse = |count: u32, why: String| LoadError::Setting {
        method: Solver::of(settings).name(),
        setting: "threads",
        value: count.to_string(),
        why,
    };
    let count = match settings.threads {
        None => std::thread::available_parallelism().map_or(1, usize::from),
        Some(count) if count == 0 || count as usize > MOST_THREADS => {
            return Err(refuse(
                count,
                format!("a run has 1 to {MOST_THREADS} of them"),
            ));
        }
        Some(count) => count as usize,
    };
    Threads::of(count).map_err(|why| refuse(count as u32, why.to_string()))
}

impl LanesEngine {
    /// Loads a scene without orbits.
    ///
    /// # Errors
    /// [`LoadError`] for an unknown method, a setting that it lacks, and what it doesn't model.
    pub fn load(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        ENGINE.method(settings)?;
        let rules = Rules::of(scene, settings)?;
        let mut lanes =
            Lanes::of(scene, rules).map_err(|why| unsupported(ENGINE.name, scene, why))?;
        lanes.threads = threads(settings)?;
        Ok(Self {
            lanes,
            scene: scene.clone(),
            times: Vec::new(),
        })
    }

    /// The rows, and what is done with them.
    #[must_use]
    pub fn lanes(&self) -> &Lanes {
        &self.lanes
    }

    /// The tables as the overlay shows them.
    fn row_tables(&self) -> Vec<RowTable<'_>> {
        let (bodies, pairs) = (&self.lanes.bodies, &self.lanes.pairs);
        vec![
            RowTable {
                name: ch00_scenes::BODIES,
                about: "Where bodies are and how they move: 16 bytes a row.",
                rows: bodies.rows(),
                columns: vec![
                    RowColumn::of(&bodies.place),
                    RowColumn::alone(ATTITUDE, &bodies.attitude),
                    RowColumn::of(&bodies.motion),
                    RowColumn::of(&bodies.spin),
                    RowColumn::of(&bodies.solid),
                    RowColumn::of(&bodies.material),
                    RowColumn::of(&bodies.held),
                    RowColumn::of(&bodies.push),
                ],
            },
            RowTable {
                name: "pairs",
                about: "Pairs of bodies that touch or may touch in the step.",
                rows: pairs.bodies.len(),
                columns: vec![
                    RowColumn::of::<Manifold>(&pairs.manifold),
                    RowColumn::of::<Impulse>(&pairs.impulse),
                ],
            },
            RowTable {
                name: "press",
                about: "What bodies gather: a row a pair, batch by batch; lanes that are left over are empty.",
                rows: pairs.press.len(),
                columns: vec![RowColumn::of(&pairs.press)],
            },
        ]
    }
}

impl Engine for LanesEngine {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: ENGINE.name,
            method: self.lanes.rules.method.name(),
            threads: self.lanes.threads.count() as u32,
            device: "cpu".to_owned(),
            substeps: self.lanes.rules.substeps,
            sweeps: None,
            real_size: 4,
            restitution_threshold: f64::from(self.lanes.rules.restitution_threshold),
        }
    }

    fn step(&mut self, dt: f32) {
        let mut clock = PassClock::start();
        self.lanes.step(dt, |part| clock.note(part));
        self.times = clock.times();
    }

    fn read_state(&self, state: &mut State) {
        self.lanes.bodies.read(state);
    }

    fn write_state(&mut self, state: &State, _dt: f32) {
        self.lanes.write_state(state);
    }

    fn columns(&self) -> Vec<Column> {
        let tables = self.row_tables();
        let Some(bodies) = tables.first() else {
            return Vec::new();
        };
        let rows: Vec<usize> = (0..bodies.rows).collect();
        let columns = bodies.info().columns.into_iter();
        columns
            .filter_map(|column| {
                Some(Column {
                    name: column.symbol,
                    unit: column.unit,
                    about: column.about,
                    data: bodies.cells(column.name, &rows).ok()?,
                })
            })
            .collect()
    }

    fn tables(&self) -> Vec<TableInfo> {
        self.row_tables().iter().map(RowTable::info).collect()
    }

    fn cells(&self, table: &str, column: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        let tables = self.row_tables();
        let found = tables.iter().find(|known| known.name == table);
        let known = || tables.iter().map(|known| known.name);
        found
            .ok_or_else(|| TableError::unknown_table(table, known()))?
            .cells(column, rows)
    }

    fn contacts(&self) -> Vec<ContactPoint> {
        let (pairs, bodies) = (&self.lanes.pairs, &self.lanes.bodies);
        let is_awake = |&pair: &usize| {
            let (a, b) = pairs.bodies[pair];
            !(bodies.is_static(a) && bodies.is_static(b))
        };
        let awake = (0..pairs.bodies.len()).filter(is_awake);
        let awake = awake.map(|pair| KeptPair::of(pairs, pair));
        let asleep = self.lanes.sleep.kept().iter().copied();
        let all = awake.chain(asleep);
        all.flat_map(|pair| self.contacts_of(&pair)).collect()
    }

    fn pairs(&self) -> &[(usize, usize)] {
        &self.lanes.broad.pairs
    }

    fn counters(&self) -> Counters {
        let points = self.lanes.pairs.manifold.iter().map(|m| m.points as usize);
        Counters {
            pairs: self.lanes.broad.pairs.len(),
            contacts: points.sum(),
            overflow: self.lanes.pairs.without_colour(),
            asleep: self.lanes.sleep.asleep(),
        }
    }

    fn pass_times(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn explain(&self) -> String {
        super::explain::explain(&self.scene, &self.lanes)
    }

    fn add_body(&mut self, body: &Body, _dt: f32) -> Added {
        self.lanes.add_body(body);
        self.scene.bodies.push(body.clone());
        Ok(self.scene.bodies.len() - 1)
    }

    fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        self.scene.check_removal(body)?;
        self.lanes.remove_body(body);
        self.scene.remove_body(body).map(|_| ())
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.lanes.pull(pull.map(|pull| Spring {
            body: pull.body,
            anchor: pull.anchor.as_vec3(),
            target: pull.target.as_vec3(),
            mass: self.scene.bodies[pull.body].mass as f32,
        }));
    }
}

impl LanesEngine {
    /// The points of a pair as the overlay draws them.
    fn contacts_of(&self, pair: &KeptPair) -> Vec<ContactPoint> {
        match pair.manifold.points {
            0 => Vec::new(),
            1 => self.points_of::<1>(pair),
            2 => self.points_of::<2>(pair),
            3 => self.points_of::<3>(pair),
            _ => self.points_of::<4>(pair),
        }
    }

    /// Those of a pair that has P.
    fn points_of<const P: usize>(&self, pair: &KeptPair) -> Vec<ContactPoint> {
        let (a, b) = pair.bodies;
        let [one, two] = [a, b].map(|row| Side::<f32>::of(&self.lanes.bodies, &[row as u32]));
        let contact = Contact::<f32, P>::of(|_| &pair.manifold);
        let impulse = &pair.impulse;
        let t = touching(&contact, &one, &two);
        let normal = t.normal.lane(0);
        let friction = impulse.friction / P as f32;
        let point = |k: usize| -> ContactPoint {
            let received: Vec3 = -(impulse.normal[k] * normal + friction);
            ContactPoint {
                a,
                b,
                point: (one.position + t.arm_a[k]).lane(0).as_dvec3(),
                normal: -normal.as_dvec3(),
                depth: f64::from(-t.distance[k]),
                impulse: received.as_dvec3(),
            }
        };
        (0..P).map(point).filter(|c| c.depth >= 0.0).collect()
    }
}
