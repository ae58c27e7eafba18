//! The streamlining type: columns go up to the GPU, a kernel runs over their rows, columns come down
//! again, and all of it by name.
//!
//! [`Gpu`] is the device. [`Columns`] are its buffers, each with a name. A [`Kernel`] is WGSL, and its
//! bindings have the columns' names, so that none is typed twice. [`Passes`] run many kernels one after
//! the other in one submission; a [`Timer`] says how long they took. A [`Readback`] brings numbers down
//! some frames late, without waiting for them.

mod buffers;
mod columns;
mod error;
mod fetch;
mod gpu;
mod kernel;
mod passes;
mod readback;
mod reflection;
mod source;
mod tables;
mod timer;

pub use columns::{ColumnInfo, Columns};
pub use error::StreamError;
pub use gpu::{Failure, Gpu};
pub use kernel::Kernel;
pub use passes::Passes;
pub use readback::{Late, Readback};
pub use source::{behind_needs, generated, names, source};
pub use tables::{column_name, table_wgsl};
pub use timer::Timer;
