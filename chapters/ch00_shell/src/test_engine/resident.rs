//! The test engine with its points on the device, as far as a window can tell: rows to be drawn are
//! written after each step, states come back some glances late, and the device may be lost.

use std::any::Any;
use std::rc::Rc;

use ch00_scenes::{
    Added, Body, Cell, Column, ColumnData, Edit, Engine, EngineEntry, EngineInfo, Loaded, Pull,
    RemoveError, RowId, Scene, Settings, State, TableError, TableInfo,
};

use super::FALLING;
use crate::gpu::Gpu;
use crate::resident::{Drawn, Resident};

/// Falls on the device.
pub(crate) const RESIDENT: EngineEntry = EngineEntry {
    name: "resident",
    load,
    ..FALLING
};

/// A state is there at this glance after the one that asks for it.
pub(crate) const GLANCES: u32 = 3;

/// More bodies than this are never added.
const ROOM: u64 = 16;

struct OnDevice {
    falling: Box<dyn Engine>,
    gpu: Rc<Gpu>,
    resident: Resident,
    last: State,
    steps: u64,
    /// The step whose state was asked for, that state, and how often it was looked for.
    asked: Option<(u64, State, u32)>,
}

fn load(scene: &Scene, settings: &Settings) -> Loaded {
    let falling = (FALLING.load)(scene, settings)?;
    let gpu = Gpu::shared().expect("a Vulkan device, such as that of mesa-vulkan-drivers");
    let rows = scene.bodies.len() as u64 + ROOM;
    let bodies = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("drawn"),
        size: rows * size_of::<Drawn>() as u64,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut engine = OnDevice {
        resident: Resident {
            gpu: Rc::clone(&gpu),
            bodies,
        },
        last: state_of(falling.as_ref()),
        falling,
        gpu,
        steps: 0,
        asked: None,
    };
    engine.place();
    Ok(Box::new(engine))
}

fn state_of(engine: &dyn Engine) -> State {
    let mut state = State::default();
    engine.read_state(&mut state);
    state
}

impl OnDevice {
    /// Writes the rows; the last step's start is what was written last.
    fn write(&mut self) {
        let now = state_of(self.falling.as_ref());
        let last = &self.last;
        let row = |i: usize| Drawn {
            position: now.position[i].as_vec3().to_array(),
            orientation: now.orientation[i].as_quat().to_array(),
            position_last: last.position[i].as_vec3().to_array(),
            orientation_last: last.orientation[i].as_quat().to_array(),
            ..Drawn::default()
        };
        let rows: Vec<Drawn> = (0..now.len()).map(row).collect();
        let bytes = bytemuck::cast_slice(&rows);
        self.gpu.queue.write_buffer(&self.resident.bodies, 0, bytes);
        self.last = now;
    }

    /// The same where there is nothing to interpolate; what was asked for before is dropped.
    fn place(&mut self) {
        self.asked = None;
        self.last = state_of(self.falling.as_ref());
        self.write();
    }
}

impl Engine for OnDevice {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: RESIDENT.name,
            device: self.gpu.name.clone(),
            ..self.falling.info()
        }
    }

    fn step(&mut self, dt: f32) {
        if self.failure().is_none() {
            self.falling.step(dt);
            self.steps += 1;
            self.write();
        }
    }

    fn read_state(&self, state: &mut State) {
        self.falling.read_state(state);
    }

    fn glance(&mut self, state: &mut State) -> Option<u64> {
        let (step, asked, looks) = self
            .asked
            .get_or_insert_with(|| (self.steps, self.last.clone(), 0));
        if *looks < GLANCES {
            *looks += 1;
            return None;
        }
        state.clone_from(asked);
        let age = self.steps - *step;
        self.asked = None;
        Some(age)
    }

    fn resident(&self) -> Option<&dyn Any> {
        Some(&self.resident)
    }

    fn failure(&self) -> Option<String> {
        self.gpu.failure()
    }

    fn write_state(&mut self, state: &State, dt: f32) {
        self.falling.write_state(state, dt);
        self.place();
    }

    fn columns(&self) -> Vec<Column> {
        self.falling.columns()
    }

    fn tables(&self) -> Vec<TableInfo> {
        self.falling.tables()
    }

    fn cells(&self, table: &str, column: &str, rows: &[usize]) -> Result<ColumnData, TableError> {
        self.falling.cells(table, column, rows)
    }

    fn row_ids(&self, table: &str, rows: &[usize]) -> Vec<RowId> {
        self.falling.row_ids(table, rows)
    }

    fn row_of(&self, table: &str, id: RowId) -> Option<usize> {
        self.falling.row_of(table, id)
    }

    fn edit(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        let old = self.falling.edit(edit)?;
        self.place();
        Ok(old)
    }

    fn explain(&self) -> String {
        self.falling.explain()
    }

    fn add_body(&mut self, body: &Body, dt: f32) -> Added {
        let index = self.falling.add_body(body, dt)?;
        self.place();
        Ok(index)
    }

    fn remove_body(&mut self, body: usize) -> Result<(), RemoveError> {
        self.falling.remove_body(body)?;
        self.place();
        Ok(())
    }

    fn pull(&mut self, pull: Option<Pull>) {
        self.falling.pull(pull);
    }
}
