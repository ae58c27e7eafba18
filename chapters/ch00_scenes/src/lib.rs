//! Scenes as plain data, the [`Engine`] trait that every chapter's engine implements, and
//! the measures that judge a run from scene and state alone.
//!
//! Nothing here steps anything. A scene is what is simulated; an engine is which
//! architecture steps it; a method is which mathematics it uses.

pub mod builtin;
pub mod dump;
mod engine;
pub mod error;
mod io;
pub mod measures;
pub mod orbits;
pub mod random;
mod scene;
mod state;
mod validate;

pub use engine::{
    Added, Column, ColumnData, ContactPoint, Counters, Engine, EngineEntry, EngineInfo, Layer,
    Line, LoadError, Loaded, Method, PassTime, Pull, Settings,
};
pub use error::SceneError;
pub use scene::{Body, EulerLimits, Force, Joint, Orbit, Pole, Scene};
pub use state::State;

pub use ch00_maths::f64::shape::Shape;
