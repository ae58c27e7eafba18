//! What a chapter offers: its engines and scenes, stated once in its `main.rs`.

use ch00_scenes::EngineEntry;

use crate::error::ShellError;

/// A chapter's own program: what it is called and what it can run.
#[derive(Clone, Copy)]
pub struct Chapter {
    /// Name of the crate, such as `ch03_collision`.
    pub name: &'static str,
    /// The book's title of the chapter, also the window's.
    pub title: &'static str,
    /// One or two sentences for `--help`.
    pub about: &'static str,
    /// The engines that it can run, the default first. At least one.
    pub engines: &'static [EngineEntry],
    /// The scene that it starts with.
    pub default_scene: &'static str,
    /// The built-in scenes that its lists offer.
    pub scenes: &'static [&'static str],
}

impl Chapter {
    /// The engine of this name.
    ///
    /// # Errors
    /// [`ShellError::Engine`] that lists the chapter's engines and names the chapter which
    /// has this one.
    pub fn engine(&self, name: &str) -> Result<EngineEntry, ShellError> {
        let names = || self.engines.iter().map(|engine| engine.name);
        let found = self.engines.iter().find(|engine| engine.name == name);
        found.copied().ok_or_else(|| ShellError::Engine {
            name: name.to_owned(),
            chapter: self.name,
            known: names().collect::<Vec<_>>().join(", "),
            elsewhere: ENGINES_ELSEWHERE
                .iter()
                .find_map(|&(engine, chapter)| (engine == name).then_some(chapter)),
        })
    }
}

/// Which chapter to turn to for an engine that a chapter's own program doesn't have. A
/// chapter that brings an engine adds its line.
const ENGINES_ELSEWHERE: &[(&str, &str)] = &[
    ("objects", "ch04_ragdolls"),
    ("properties", "ch05_properties"),
    ("lanes", "ch06_compute"),
    ("compute", "ch06_compute"),
];
