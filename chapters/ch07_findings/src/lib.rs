//! The laboratory: what the charts measure, and how they are drawn.

pub mod chart;
pub mod errata;
