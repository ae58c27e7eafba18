//! The narrow phase of the own-row step: the functions of `own_row::narrow`, and the shaders
//! `common/narrow*.wgsl` that have them by the same names.

mod bodies;
mod degenerate;
mod device;
mod judged;
mod points;
