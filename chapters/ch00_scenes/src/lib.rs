//! Scenes as plain data, the [`Engine`] trait that every chapter's engine implements, and
//! the measures that judge a run from scene and state alone.
//!
//! Nothing here steps anything. A scene is what is simulated; an engine is which
//! architecture steps it; a method is which mathematics it uses.

pub mod builtin;
mod dissection;
mod drawing;
pub mod dump;
mod engine;
pub mod error;
mod io;
mod layer;
pub mod measures;
pub mod orbits;
pub mod random;
mod remove;
mod scene;
mod state;
mod table;
mod validate;

pub use dissection::{Dissection, Phase, SurfacePoint};
pub use drawing::{Drawing, Face, Key, Line, Mark, Rgb, palette};
pub use engine::{
    Added, BODIES, Column, ColumnData, ContactPoint, Counters, Engine, EngineEntry, EngineInfo,
    LoadError, Loaded, Method, PassTime, Pull, Settings,
};
pub use error::SceneError;
pub use layer::Layer;
pub use remove::RemoveError;
pub use scene::{Body, EulerLimits, Force, Joint, Orbit, Pole, Scene};
pub use state::State;
pub use table::{Cell, ColumnInfo, Edit, Kind, RowId, TableError, TableInfo};

pub use ch00_maths::f64::shape::Shape;
