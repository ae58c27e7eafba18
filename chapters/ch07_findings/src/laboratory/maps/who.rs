//! Who is shown on a map: methods with one knob at most, and what theory says of each.

use ch00_scenes::{EngineEntry, Scene, Settings};

use crate::chart::Class;
use crate::laboratory::contenders::CONTENDERS;
use crate::laboratory::scenario::Watch;
use crate::methods::{double, single};

/// Makes one who looks at a scene.
pub type Watcher = fn(&Scene) -> Box<dyn Watch>;

/// A panel.
pub struct Who {
    /// Stands above it.
    pub name: &'static str,
    /// Who steps.
    pub engine: EngineEntry,
    /// With which settings, but for the knob.
    pub base: Settings,
    /// What the map's vertical axis is for this method.
    pub knob: Knob,
    /// What theory says.
    pub laws: Vec<Law>,
    /// So many steps in place of the scene's, and another one who looks.
    pub instead: Option<(u32, Watcher)>,
}

/// What is turned along the vertical axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// Nothing of the method: the axis belongs to the scene.
    Scene,
    /// Sweeps of a step.
    Sweeps,
    /// Substeps, or what the method calls so.
    Substeps,
}

/// A line among the cells.
pub struct Law {
    /// y over x; where it isn't finite there is no line.
    pub y: Box<dyn Fn(f64) -> f64>,
    /// The worst class on its good side; None of a line that is drawn for comparison.
    pub until: Option<Class>,
}

impl Who {
    /// One of the laboratory's, as it comes, on one thread.
    ///
    /// # Panics
    /// Where the laboratory has none of that name.
    #[must_use]
    pub fn usual(name: &'static str) -> Self {
        let found = CONTENDERS.iter().find(|contender| contender.name == name);
        let contender = found.expect("the laboratory's list has it");
        Self {
            name,
            engine: contender.engine,
            base: contender.settings(),
            knob: Knob::Scene,
            laws: Vec::new(),
            instead: None,
        }
    }

    /// Several of them; those that this build lacks are left out.
    pub fn all<const N: usize>(names: [&'static str; N]) -> impl Iterator<Item = Self> {
        let known = |name: &&str| CONTENDERS.iter().any(|one| one.name == *name);
        names.into_iter().filter(known).map(Self::usual)
    }

    /// One of the field's usual methods in single precision.
    #[must_use]
    pub fn in_single(name: &'static str, method: &'static str) -> Self {
        Self {
            name,
            engine: single::engine::ENGINE,
            base: Settings::defaults().with_method(method),
            ..Self::usual(method)
        }
    }

    /// One of the field's usual methods, with a number of substeps.
    #[must_use]
    pub fn in_parts(name: &'static str, method: &'static str, substeps: u32) -> Self {
        let base = Settings {
            substeps: Some(substeps),
            ..Settings::defaults().with_method(method)
        };
        Self {
            name,
            engine: double::engine::ENGINE,
            base,
            ..Self::usual(method)
        }
    }

    /// The same under another name.
    #[must_use]
    pub fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// The same with a knob.
    #[must_use]
    pub fn with(self, knob: Knob) -> Self {
        Self { knob, ..self }
    }

    /// The same with one more law.
    #[must_use]
    pub fn law(mut self, until: Class, y: impl Fn(f64) -> f64 + 'static) -> Self {
        let y = Box::new(y);
        let until = Some(until);
        self.laws.push(Law { y, until });
        self
    }

    /// The same with one more line, which its edge need not follow.
    #[must_use]
    pub fn line(mut self, y: impl Fn(f64) -> f64 + 'static) -> Self {
        let y = Box::new(y);
        self.laws.push(Law { y, until: None });
        self
    }

    /// The settings of a cell at this height of the map.
    #[must_use]
    pub fn settings(&self, y: f64) -> Settings {
        let turned = Some(y.round() as u32);
        let base = self.base.clone();
        match self.knob {
            Knob::Scene => base,
            Knob::Sweeps => Settings {
                sweeps: turned,
                ..base
            },
            Knob::Substeps => Settings {
                substeps: turned,
                ..base
            },
        }
    }
}
