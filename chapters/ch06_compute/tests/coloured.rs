//! The method of colours against the exact solutions, the same as own rows in `exact.rs` and with the same
//! bounds.

#[path = "exact/bouncing.rs"]
mod bouncing;
#[path = "exact/colours.rs"]
mod colours;
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
const METHOD: &str = "coloured";

/// Its substeps unless a test says otherwise.
const SUBSTEPS_OF_THE_METHOD: u32 = 10;
