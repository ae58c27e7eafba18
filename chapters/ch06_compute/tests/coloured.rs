//! The method of colours against the exact solutions, the same as own rows in `exact.rs` and with the same
//! bounds.

#[path = "exact/colours.rs"]
mod colours;
#[path = "exact/scenarios.rs"]
mod scenarios;

/// The method that is tested.
const METHOD: &str = "coloured";

/// Its substeps unless a test says otherwise.
const SUBSTEPS_OF_THE_METHOD: u32 = 10;
