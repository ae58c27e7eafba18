//! The own-row method against exact solutions, and against the figures that a prototype of it was measured
//! with. `tests/reference` has the exact numbers and says what each scenario is.
//!
//! The engine runs in f32, with 10 substeps unless a test says otherwise. Every tolerance says what it
//! comes from.

#[path = "exact/bouncing.rs"]
mod bouncing;
#[path = "exact/falling.rs"]
mod falling;
#[path = "exact/fast.rs"]
mod fast;
#[path = "exact/free_space.rs"]
mod free_space;
#[path = "exact/friction.rs"]
mod friction;
#[path = "exact/hanging.rs"]
mod hanging;
#[path = "exact/helpers.rs"]
mod helpers;
#[path = "exact/piles.rs"]
mod piles;
#[path = "exact/ragdolls.rs"]
mod ragdolls;
#[path = "exact/standing.rs"]
mod standing;
#[path = "exact/turning.rs"]
mod turning;

use helpers::*;

/// The method that is tested.
const METHOD: &str = "own-row";

/// Its substeps unless a test says otherwise.
const SUBSTEPS_OF_THE_METHOD: u32 = 10;
