//! What the lanes were measured at: tables that are kept in the book, drawn and told.

pub mod beside_rapier;
pub mod broad_phase;
pub mod growth;
pub mod long_run;
pub mod rows_and_colours;
pub mod sleeping;
