//! Every engine of the book with its methods, the field's usual ones, and rapier: as charts of time call them.

use ch00_scenes::{EngineEntry, Settings};

use crate::chart::Style;
use crate::methods::double;

/// An engine with a method.
#[derive(Clone, Copy)]
pub struct Kind {
    /// As charts call it.
    pub name: &'static str,
    /// Who steps.
    pub engine: EngineEntry,
    /// As `--method` says it.
    pub method: &'static str,
    /// How its curve looks.
    pub style: Style,
}

const fn kind(name: &'static str, engine: EngineEntry, method: &'static str, style: Style) -> Kind {
    Kind {
        name,
        engine,
        method,
        style,
    }
}

/// All of them, the book's first. `direct-joints` isn't among them: its matrix is dense, and it is there to show
/// what that costs.
pub const KINDS: &[Kind] = &[
    kind(
        "printed on objects",
        ch04_ragdolls::ENGINE,
        "printed",
        Style::Printed,
    ),
    kind(
        "corrected on objects",
        ch04_ragdolls::ENGINE,
        "corrected",
        Style::Other(2),
    ),
    kind(
        "corrected on properties",
        ch05_properties::ENGINE,
        "corrected",
        Style::Corrected,
    ),
    kind(
        "own-row on lanes",
        ch06_compute::LANES,
        "own-row",
        Style::Other(0),
    ),
    kind(
        "coloured on lanes",
        ch06_compute::LANES,
        "coloured",
        Style::Other(1),
    ),
    kind(
        "own-row on compute",
        ch06_compute::COMPUTE,
        "own-row",
        Style::Other(11),
    ),
    kind(
        "sequential-impulses",
        double::engine::ENGINE,
        "sequential-impulses",
        Style::Other(7),
    ),
    kind(
        "soft-step",
        double::engine::ENGINE,
        "soft-step",
        Style::Other(3),
    ),
    kind("xpbd", double::engine::ENGINE, "xpbd", Style::Other(4)),
    #[cfg(feature = "rapier")]
    kind("rapier", crate::rapier::ENGINE, "unswept", Style::Other(13)),
    #[cfg(feature = "rapier")]
    kind(
        "rapier tuned",
        crate::rapier::ENGINE,
        "tuned",
        Style::Other(14),
    ),
];

/// Whether what is called so is an engine of the book's: others are called by their method alone.
#[must_use]
pub fn is_ours(name: &str) -> bool {
    name.contains(" on ")
}

impl Kind {
    /// Its usual settings, on one thread.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let on_threads = self.engine.name == ch06_compute::LANES.name;
        Settings {
            threads: on_threads.then_some(1),
            ..Settings::defaults().with_method(self.method)
        }
    }

    /// Whether it is an engine of the book's.
    #[must_use]
    pub fn is_ours(&self) -> bool {
        is_ours(self.name)
    }

    /// Whether it runs on the graphics device.
    #[must_use]
    pub fn is_compute(&self) -> bool {
        self.engine.name == ch06_compute::COMPUTE.name
    }
}
