//! All scenarios, by the method that the test names: `METHOD` and `SUBSTEPS_OF_THE_METHOD`.

mod bouncing;
mod falling;
mod fast;
mod free_space;
mod friction;
mod hanging;
pub mod helpers;
mod piles;
mod ragdolls;
mod standing;
mod turning;

use super::{METHOD, SUBSTEPS_OF_THE_METHOD};
use helpers::*;
