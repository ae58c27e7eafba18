//! What an engine tells about itself and its last step.

use std::time::Duration;

use glam::DVec3;

/// Who steps, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct EngineInfo {
    /// `objects`, `properties`, `lanes` or `compute`.
    pub engine: &'static str,
    /// The method in use.
    pub method: &'static str,
    /// Threads in use.
    pub threads: u32,
    /// Name of the device; `cpu` for the CPU.
    pub device: String,
    /// Parts of a step.
    pub substeps: u32,
    /// Solver sweeps over the contacts of a step, where the method has them.
    pub sweeps: Option<u32>,
    /// Bytes of a real number in the engine's state: 4 or 8.
    pub real_size: u32,
    /// Below this approach speed a contact doesn't bounce, m/s.
    pub restitution_threshold: f64,
}

/// One property of all bodies, for the overlay's tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The property's name.
    pub name: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// A value a body, in the scene's order.
    pub data: ColumnData,
}

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnData {
    /// One number a row.
    Scalar(Vec<f32>),
    /// Three numbers a row.
    Vector(Vec<[f32; 3]>),
    /// Four numbers a row: x, y, z, w.
    Quaternion(Vec<[f32; 4]>),
    /// Nine numbers a row, column by column.
    Matrix(Vec<[f32; 9]>),
    /// A whole number a row.
    Index(Vec<u32>),
}

/// A contact of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Index of the first body.
    pub a: usize,
    /// Index of the second body.
    pub b: usize,
    /// World position, m.
    pub point: DVec3,
    /// Unit vector from b to a.
    pub normal: DVec3,
    /// How deep the two overlapped when found, m.
    pub depth: f64,
    /// Impulse that a received, N s.
    pub impulse: DVec3,
}

/// What the last step counted. Nothing is skipped in silence: what a step could not do
/// stands in `overflow`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Pairs of bodies that the broad phase found.
    pub pairs: usize,
    /// Contacts that the narrow phase found.
    pub contacts: usize,
    /// Things that a capacity or an iteration limit left undone since loading.
    pub overflow: usize,
    /// Bodies that sleep.
    pub asleep: usize,
}

/// Time that a part of the last step took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassTime {
    /// The part's name, as in the step function.
    pub name: &'static str,
    /// Wall time.
    pub time: Duration,
}
