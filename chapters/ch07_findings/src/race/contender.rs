//! Who takes part: an engine, a method, substeps; as the command line says it.

use std::fmt;

use ch00_scenes::{EngineEntry, Settings};

use super::RaceError;
use crate::CHAPTER;

/// As many take part at least.
pub const FEWEST: usize = 2;

/// As many take part at most: more views would be too small.
pub const MOST: usize = 4;

/// An engine with what was chosen for it.
#[derive(Clone)]
pub struct Contender {
    /// Who steps.
    pub entry: EngineEntry,
    /// How.
    pub settings: Settings,
}

impl Contender {
    /// An engine as it comes.
    #[must_use]
    pub fn of(entry: EngineEntry) -> Self {
        Self {
            entry,
            settings: Settings::defaults(),
        }
    }

    /// Reads `ENGINE[:METHOD][@SUBSTEPS]`.
    ///
    /// # Errors
    /// [`RaceError`] that lists the engines or the methods that there are.
    pub fn parse(text: &str) -> Result<Self, RaceError> {
        let text = text.trim();
        let (who, substeps) = match text.split_once('@') {
            Some((who, substeps)) => (who, Some(substeps_of(text, substeps)?)),
            None => (text, None),
        };
        let (engine, method) = match who.split_once(':') {
            Some((engine, method)) => (engine, Some(method)),
            None => (who, None),
        };
        if engine.is_empty() {
            return Err(RaceError::Empty(text.to_owned()));
        }
        let entry = CHAPTER.engine(engine).map_err(|source| RaceError::Engine {
            text: text.to_owned(),
            source: source.into(),
        })?;
        let settings = Settings {
            method: method.map(str::to_owned),
            substeps,
            ..Settings::defaults()
        };
        entry
            .method(&settings)
            .map_err(|source| RaceError::Method {
                text: text.to_owned(),
                source: source.into(),
            })?;
        Ok(Self { entry, settings })
    }

    /// Reads two to four of them, separated by commas.
    ///
    /// # Errors
    /// [`RaceError`] for fewer and more, and for each that can't be read.
    pub fn all(text: &str) -> Result<Vec<Self>, RaceError> {
        let count = text.split(',').count();
        if !(FEWEST..=MOST).contains(&count) {
            return Err(RaceError::Count {
                text: text.to_owned(),
                count,
            });
        }
        text.split(',').map(Self::parse).collect()
    }
}

/// As the command line says it.
impl fmt::Display for Contender {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Settings {
            method, substeps, ..
        } = &self.settings;
        let method = method.as_deref().unwrap_or(self.entry.methods[0].name);
        write!(f, "{}:{method}", self.entry.name)?;
        substeps.map_or(Ok(()), |substeps| write!(f, "@{substeps}"))
    }
}

fn substeps_of(text: &str, substeps: &str) -> Result<u32, RaceError> {
    let number = substeps.parse().ok().filter(|&substeps| substeps > 0);
    number.ok_or_else(|| RaceError::Substeps {
        text: text.to_owned(),
        substeps: substeps.to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        match Contender::all(text) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("`{text}` is taken"),
        }
    }

    #[test]
    fn a_contender_is_an_engine_a_method_and_substeps() {
        let all = Contender::all("lanes:own-row@16, properties:printed,objects").expect("they are");
        let names: Vec<String> = all.iter().map(ToString::to_string).collect();
        let expected = [
            "lanes:own-row@16",
            "properties:printed",
            "objects:corrected",
        ];
        assert_eq!(names, expected);
    }

    #[test]
    fn what_is_no_contender_is_answered_with_what_there_is() {
        for (text, words) in [
            ("lanes", &["2 to 4", "names 1", "cradle"][..]),
            ("lanes,lanes,lanes,lanes,lanes", &["2 to 4", "names 5"]),
            ("lanes,gears", &["`gears`", "objects", "compute"]),
            ("lanes,objects:magic", &["`magic`", "corrected, printed"]),
            ("lanes@0,objects", &["`lanes@0`", "from 1"]),
            ("lanes@many,objects", &["`many`"]),
            ("lanes,", &["no engine", "ENGINE[:METHOD]"]),
            (",", &["no engine"]),
            ("cradel", &["2 to 4", "names 1", "cradle"]),
        ] {
            let error = refused(text);
            assert_eq!(error.lines().count(), 1, "{error}");
            for word in words {
                assert!(error.contains(word), "`{word}` isn't in: {error}");
            }
        }
    }
}
