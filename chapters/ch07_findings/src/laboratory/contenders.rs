//! Who runs: the book's engines with their methods, and the field's usual methods.

use ch00_scenes::{EngineEntry, Settings};

use crate::chart::Style;
use crate::methods::double;

/// A method on an engine, with its usual settings.
#[derive(Clone, Copy)]
pub struct Contender {
    /// As charts call it.
    pub name: &'static str,
    /// As `--method` says it.
    pub method: &'static str,
    /// Parts of a step; the method's own number if None.
    pub substeps: Option<u32>,
    /// Who steps.
    pub engine: EngineEntry,
    /// How its curves look.
    pub style: Style,
    /// Whether it is one of the book's own.
    pub ours: bool,
}

impl Contender {
    /// Its usual settings, on one thread.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let threads = (self.engine.name == "lanes").then_some(1);
        Settings {
            threads,
            substeps: self.substeps,
            ..Settings::defaults().with_method(self.method)
        }
    }
}

const fn ours(name: &'static str, engine: EngineEntry, style: Style) -> Contender {
    Contender {
        name,
        method: name,
        substeps: None,
        engine,
        style,
        ours: true,
    }
}

const fn in_parts(name: &'static str, substeps: u32, of: Contender) -> Contender {
    Contender {
        name,
        substeps: Some(substeps),
        ..of
    }
}

const fn usual(name: &'static str, style: Style) -> Contender {
    Contender {
        name,
        method: name,
        substeps: None,
        engine: double::engine::ENGINE,
        style,
        ours: false,
    }
}

#[cfg(feature = "rapier")]
const fn rapier(name: &'static str, method: &'static str, style: Style) -> Contender {
    Contender {
        name,
        method,
        substeps: None,
        engine: crate::rapier::ENGINE,
        style,
        ours: false,
    }
}

/// Rapier with its continuous collision detection. Where nothing moves far in a step it takes the same steps as
/// without, bit for bit.
pub const WITH_CCD: &str = "rapier with CCD";

/// All of them, in the order of the charts: those that solve contacts and joints, then integrators of bodies
/// that are alone.
pub const CONTENDERS: &[Contender] = &[
    ours("printed", ch05_properties::ENGINE, Style::Printed),
    ours("corrected", ch05_properties::ENGINE, Style::Corrected),
    ours("own-row", ch06_compute::LANES, Style::Other(0)),
    ours("coloured", ch06_compute::LANES, Style::Other(1)),
    in_parts(
        "own-row in 32",
        32,
        ours("own-row", ch06_compute::LANES, Style::Other(11)),
    ),
    in_parts(
        "coloured in 32",
        32,
        ours("coloured", ch06_compute::LANES, Style::Other(12)),
    ),
    usual("sequential-impulses", Style::Other(2)),
    usual("soft-step", Style::Other(3)),
    usual("xpbd", Style::Other(4)),
    usual("direct-joints", Style::Other(15)),
    #[cfg(feature = "rapier")]
    rapier("rapier", "unswept", Style::Other(13)),
    #[cfg(feature = "rapier")]
    rapier(WITH_CCD, "shipped", Style::Other(16)),
    #[cfg(feature = "rapier")]
    rapier("rapier tuned", "tuned", Style::Other(14)),
    usual("constant-spin", Style::Other(5)),
    usual("explicit-gyro", Style::Other(6)),
    usual("implicit-gyro", Style::Other(7)),
    usual("splitting", Style::Other(8)),
    usual("runge-kutta", Style::Other(9)),
];
