//! The own-row method against exact solutions, and against the figures that a prototype of it was measured
//! with. `tests/reference` has the exact numbers and says what each scenario is.
//!
//! The engine runs in f32, with 10 substeps unless a test says otherwise. Every tolerance says what it
//! comes from.

#[path = "exact/scenarios.rs"]
mod scenarios;

/// The method that is tested.
const METHOD: &str = "own-row";

/// Its substeps unless a test says otherwise.
const SUBSTEPS_OF_THE_METHOD: u32 = 10;
