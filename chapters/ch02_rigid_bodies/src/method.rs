//! The two methods of the object engine.

use ch00_scenes::{EngineEntry, LoadError, Settings};

/// Which formulas a body is stepped with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// As the report prints them.
    Printed,
    /// With the errata mended.
    Corrected,
}

/// The methods by name, the default first.
pub const METHODS: &[ch00_scenes::Method] = &[
    ch00_scenes::Method {
        name: "corrected",
        about: "the report's method with its errata mended; sweeps over the contacts",
    },
    ch00_scenes::Method {
        name: "printed",
        about: "the report's formulas as printed, one sweep, no friction",
    },
];

impl Method {
    /// The method that `settings` ask for.
    ///
    /// # Errors
    /// [`LoadError::UnknownMethod`] that lists the known ones.
    pub fn of(entry: &EngineEntry, settings: &Settings) -> Result<Self, LoadError> {
        Ok(match entry.method(settings)?.name {
            "printed" => Method::Printed,
            _ => Method::Corrected,
        })
    }

    /// As `--method` says it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Method::Printed => "printed",
            Method::Corrected => "corrected",
        }
    }
}
