//! Why a chapter's program can't do what it was asked, in one paragraph for its user.

use std::path::PathBuf;

use ch00_scenes::{LoadError, RemoveError, SceneError, TableError};
use thiserror::Error;

/// Everything that ends a chapter's program with exit status 1.
#[derive(Debug, Error)]
pub enum ShellError {
    /// The scene can't be used.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The engine can't take the scene or the settings.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The body can't be removed.
    #[error(transparent)]
    Remove(#[from] RemoveError),
    /// The cell can't be read or changed.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The chapter's program has no such engine.
    #[error("engine `{name}` is not in this chapter's list ({chapter} has: {known}){}", elsewhere.map(|other| format!("; {other} is the chapter that has it")).unwrap_or_default())]
    Engine {
        /// What was asked for.
        name: String,
        /// The chapter that was asked.
        chapter: &'static str,
        /// Its engines, separated by commas.
        known: String,
        /// The chapter that has the engine, if the book has one.
        elsewhere: Option<&'static str>,
    },
    /// A flag that needs another one.
    #[error("`--{flag}` {why}")]
    Flag {
        /// Name of the flag.
        flag: &'static str,
        /// What it needs, and what to do.
        why: &'static str,
    },
    /// The engine doesn't draw this layer.
    #[error("`--layers {layer}`: the engine `{engine}` draws {}", if known.is_empty() { "no layers" } else { known.as_str() })]
    Layer {
        /// What was asked for.
        layer: &'static str,
        /// Name of the engine.
        engine: &'static str,
        /// What it draws, separated by commas.
        known: String,
    },
    /// A pair can't be looked at.
    #[error("`--dissect`: {0}")]
    Pair(String),
    /// A file can't be written.
    #[error("{}: can't write: {source}", file.display())]
    Write {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// No graphics adapter was found, so there can be no picture.
    #[error("no graphics adapter was found, so no picture can be drawn: {0}")]
    NoAdapter(String),
    /// No window can be opened here.
    #[error("no window can be opened: {0}")]
    NoDisplay(String),
    /// The engine failed in mid-run, and no other one could go on.
    #[error("{0}")]
    Stopped(String),
    /// The graphics device failed.
    #[error("the graphics device failed: {0}")]
    Graphics(String),
}
