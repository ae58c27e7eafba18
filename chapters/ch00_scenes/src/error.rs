//! Errors of scenes: each names the file, the index and the field.

use std::path::PathBuf;

use thiserror::Error;

/// Why a scene can't be used.
#[derive(Debug, Error)]
pub enum SceneError {
    /// No built-in has this name and no file ends in `.json`.
    #[error("no scene is called `{name}`; there are: {known}; or give the path of a .json file")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The built-in scenes, separated by commas.
        known: String,
    },
    /// The file can't be read.
    #[error("{}: can't read: {source}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The file is not JSON, or not a scene.
    #[error("{}: at `{path}`, line {}, column {}: {}", file.display(), source.line(), source.column(), without_position(source))]
    Parse {
        /// The file.
        file: PathBuf,
        /// Where in the scene, such as `bodies[3].shape`.
        path: String,
        /// What is wrong there.
        source: serde_json::Error,
    },
    /// A value that no engine can simulate.
    #[error("{origin}: {table}[{index}].{field} = {value}: {why}")]
    Value {
        /// The file, or the name of the scene.
        origin: String,
        /// `bodies`, `joints`, `forces` or `orbits`.
        table: &'static str,
        /// Index in that table.
        index: usize,
        /// Name of the field.
        field: String,
        /// What stands there.
        value: String,
        /// What should.
        why: &'static str,
    },
    /// A value of the scene itself.
    #[error("{origin}: {field} = {value}: {why}")]
    SceneValue {
        /// The file, or the name of the scene.
        origin: String,
        /// Name of the field.
        field: &'static str,
        /// What stands there.
        value: String,
        /// What should.
        why: &'static str,
    },
    /// More or fewer of something than a built-in scene makes.
    #[error("scene `{scene}`: --count {count}: it can have {least} to {most} {counts}")]
    Count {
        /// Name of the scene.
        scene: &'static str,
        /// What was asked for.
        count: u64,
        /// The fewest.
        least: u64,
        /// The most.
        most: u64,
        /// What is counted, in the plural.
        counts: &'static str,
    },
    /// A flag that this scene has no use for.
    #[error("scene `{scene}` has no `--{flag}`: {why}")]
    Flag {
        /// Name of the scene.
        scene: String,
        /// The flag.
        flag: &'static str,
        /// What to do instead.
        why: String,
    },
    /// The scene can't be written.
    #[error("{}: can't write: {source}", file.display())]
    Write {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
}

/// The message of a JSON error without the line and column, which stand before it.
fn without_position(error: &serde_json::Error) -> String {
    let text = error.to_string();
    match text.rfind(" at line ") {
        Some(end) => text[..end].to_owned(),
        None => text,
    }
}
