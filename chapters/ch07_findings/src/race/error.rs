//! Why there can be no race, in one paragraph.

use ch00_scenes::LoadError;
use ch00_shell::ShellError;
use thiserror::Error;

use super::gallery;

/// Everything that is wrong with contenders.
#[derive(Debug, Error)]
pub enum RaceError {
    /// Too few or too many.
    #[error(
        "a race has 2 to 4 contenders, separated by commas, and `{text}` names {count}; for example `--race lanes,properties:corrected`, or one of the gallery's: {}",
        gallery::names()
    )]
    Count {
        /// What was asked for.
        text: String,
        /// How many that are.
        count: usize,
    },
    /// A contender without an engine.
    #[error(
        "`{0}` names no engine: a contender is ENGINE[:METHOD][@SUBSTEPS], such as lanes:own-row@16"
    )]
    Empty(String),
    /// A number of substeps that is none.
    #[error("`{text}`: after `@` stands a whole number of substeps from 1, not `{substeps}`")]
    Substeps {
        /// The contender.
        text: String,
        /// What stands there.
        substeps: String,
    },
    /// No such engine.
    #[error("`{text}`: {source}")]
    Engine {
        /// The contender.
        text: String,
        /// Which there are.
        source: Box<ShellError>,
    },
    /// No such method, or a setting that it hasn't.
    #[error("`{text}`: {source}")]
    Method {
        /// The contender.
        text: String,
        /// Which there are.
        source: Box<LoadError>,
    },
    /// A set-up of the gallery has a scene.
    #[error(
        "`--race {name}` is of the gallery and has its scene, so `--scene {scene}` can't be: name the contenders instead"
    )]
    GalleryScene {
        /// Name of the set-up.
        name: &'static str,
        /// What was asked for.
        scene: String,
    },
    /// No engine takes the scene.
    #[error("none of the contenders can run `{scene}`: {why}")]
    NobodyRuns {
        /// Name of the scene.
        scene: String,
        /// What each says.
        why: String,
    },
}
