//! What all chapters share around an engine: the command line, a session that steps a
//! scene, the headless runner with its summary, and the window with renderer and overlay.
//!
//! A chapter says what it offers in a [`Chapter`] and its `main.rs` calls [`main`].

mod app;
mod camera;
mod chapter;
pub mod cli;
pub mod clock;
mod edits;
mod error;
pub mod frame_rate;
pub mod gpu;
mod guides;
pub mod headless;
pub mod history;
mod input;
mod overlay;
mod picking;
mod render;
mod resident;
pub mod screenshot;
pub mod session;
pub mod show;
pub mod side_by_side;
mod stage;
mod state_file;
pub mod summary;
mod surface;
mod tables;
#[cfg(test)]
mod test_engine;
mod throw;
mod window_loop;
mod worst;

pub use chapter::Chapter;
pub use cli::{Args, main, open, report, run, run_with};
pub use error::ShellError;
pub use gpu::Gpu;
pub use resident::{Drawn, Resident};
pub use session::Session;
pub use side_by_side::{Extras, Menu, Opening, SideBySide, Sight, View};
