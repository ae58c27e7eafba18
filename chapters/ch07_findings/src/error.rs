//! Why the top binary can't do what it was asked, in one paragraph for its user.

use std::path::PathBuf;

use ch00_scenes::{LoadError, SceneError};
use ch00_shell::ShellError;
use thiserror::Error;

use crate::race::RaceError;

/// Everything that ends the program with exit status 1.
#[derive(Debug, Error)]
pub enum FindingsError {
    /// What every chapter's program can fail at.
    #[error(transparent)]
    Shell(#[from] ShellError),
    /// A scene of a chart can't be had.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An engine can't take a scene of a chart.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The contenders of a race can't be had.
    #[error(transparent)]
    Race(#[from] RaceError),
    /// No such chart.
    #[error("there is no chart `{name}`; there are: {known}")]
    UnknownChart {
        /// What was asked for.
        name: String,
        /// What there is, separated by commas.
        known: String,
    },
    /// Charts can't be written there.
    #[error("{}: charts can't be written there: {source}; choose another folder with `--out DIR`", path.display())]
    Write {
        /// The folder or file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Two runs that are compared went different ways.
    #[error("chart `{chart}`, scene `{scene}`: {run} doesn't have the same bits: {what}")]
    Differs {
        /// Name of the chart.
        chart: &'static str,
        /// Name of the scene.
        scene: String,
        /// Which run differs from the first.
        run: String,
        /// In what.
        what: String,
    },
    /// The drawing library gave up.
    #[error("chart `{chart}` can't be drawn: {why}")]
    Draw {
        /// Name of the chart.
        chart: String,
        /// What the library says.
        why: String,
    },
    /// A table that is kept in the book can't be read.
    #[error("{}: {why}; the table is written by `{command}`", path.display())]
    Kept {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
        /// What writes it.
        command: &'static str,
    },
    /// The laboratory's table holds something else.
    #[error("{}, line {line}: this is no line of the laboratory's table; move the file away to begin a new one", path.display())]
    Store {
        /// The file.
        path: PathBuf,
        /// Number of the line, from 1.
        line: usize,
    },
    /// The report's table can't be read.
    #[error("report_tables.csv, line {line}: `{text}` is no row of the report's tables")]
    Report {
        /// Number of the line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
}
