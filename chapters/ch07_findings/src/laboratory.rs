//! The laboratory: every scenario with an exact answer, by every method, at many steps a second; each run is a
//! row with its error and its cost, or with how it failed. Charts are drawn from the rows.

pub mod cell;
pub mod charts;
pub mod contenders;
mod costs;
pub mod drift;
pub mod floor;
pub mod gas;
pub mod maps;
pub mod published;
pub mod runs;
pub mod scenario;
pub mod scenarios;
pub mod store;
mod tables;

pub use cell::{Cell, End};
pub use contenders::{CONTENDERS, Contender};
pub use scenario::{Scenario, Verdict, Watch};
pub use scenarios::SCENARIOS;
