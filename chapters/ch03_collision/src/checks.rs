//! What this chapter models so far: which scenes it takes and which it must refuse.

use ch00_scenes::{LoadError, Scene, Settings};

use crate::ENGINE;

/// The error for something that this engine doesn't model.
pub fn unsupported(scene: &Scene, what: String, index: Option<usize>) -> LoadError {
    LoadError::Unsupported {
        engine: ENGINE.name,
        chapter: ENGINE.chapter,
        scene: scene.name.clone(),
        what,
        index,
    }
}

/// Refuses settings that mean nothing to this engine.
///
/// # Errors
/// [`LoadError::Setting`] that says why.
pub fn check_settings(method: &'static str, settings: &Settings) -> Result<(), LoadError> {
    let sweeps = match (method, settings.sweeps) {
        ("printed", Some(n)) if n != 1 => Some((n, "the report resolves every contact once")),
        (_, Some(0)) => Some((0, "at least one sweep is needed")),
        (_, Some(n)) if n > 10_000 => Some((n, "more than 10000 sweeps is surely a slip")),
        _ => None,
    };
    let refused = [
        ("sweeps", sweeps),
        (
            "substeps",
            settings
                .substeps
                .filter(|&n| n != 1)
                .map(|n| (n, "this method makes whole steps")),
        ),
        (
            "threads",
            settings
                .threads
                .filter(|&n| n != 1)
                .map(|n| (n, "this engine has one thread")),
        ),
    ];
    for (setting, refused) in refused {
        if let Some((value, why)) = refused {
            return Err(LoadError::Setting {
                method,
                setting,
                value: value.to_string(),
                why: why.to_owned(),
            });
        }
    }
    settings.refuse_sleeping(method)
}
