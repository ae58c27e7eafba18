//! What the command line says.

use std::str::FromStr;

use ch00_scenes::{EngineEntry, Settings};

use crate::Problem;
use ch06_compute::peer::Cone;

/// What `--engines` can name besides `rapier`, the default first.
const ENGINES: &[EngineEntry] = &[
    ch06_compute::LANES,
    ch05_properties::ENGINE,
    ch04_ragdolls::ENGINE,
];

/// What is compared, how, and on what.
pub struct Options {
    /// Names, and counts where it isn't the scene's own.
    pub scenes: Vec<(String, Option<u64>)>,
    pub engines: Vec<(EngineEntry, Settings)>,
    pub threads: Vec<u32>,
    /// Substeps of rapier.
    pub iterations: u32,
    /// Ways to tell rapier of a cone.
    pub cones: Vec<Cone>,
    pub settle: u32,
    pub steps: u32,
    pub blocks: u32,
    pub csv: Option<String>,
}

impl Options {
    pub fn of(mut words: impl Iterator<Item = String>) -> Result<Self, Problem> {
        let mut options = Self {
            scenes: Vec::new(),
            engines: Vec::new(),
            threads: vec![1, 2],
            iterations: 4,
            cones: vec![Cone::Coupled],
            settle: 300,
            steps: 300,
            blocks: 10,
            csv: None,
        };
        let (mut scenes, mut counts) = ("balls".to_owned(), vec![None]);
        let mut engines = ENGINES[0].name.to_owned();
        let mut settings = Settings::defaults();
        let mut substeps = vec![None];
        while let Some(flag) = words.next() {
            let Some(value) = words.next() else {
                return Err(format!("`{flag}` has no value").into());
            };
            match flag.as_str() {
                "--scene" => scenes = value,
                "--count" => counts = list(&value)?.into_iter().map(Some).collect(),
                "--engines" => engines = value,
                "--method" => settings.method = Some(value),
                "--substeps" => substeps = list(&value)?.into_iter().map(Some).collect(),
                _ => options
                    .set(&flag, &value)
                    .map_err(|problem| format!("`{flag} {value}`: {problem}"))?,
            }
        }
        options.scenes = scenes_of(&scenes, &counts)?;
        for name in engines.split(',').filter(|name| !name.is_empty()) {
            for &substeps in &substeps {
                let settings = Settings {
                    substeps,
                    ..settings.clone()
                };
                options.engines.push(engine_of(name, &settings)?);
            }
        }
        options.check()
    }

    fn check(self) -> Result<Self, Problem> {
        if self.iterations == 0 || self.threads.contains(&0) {
            return Err("rapier takes at least a thread and an iteration".into());
        }
        if self.blocks == 0 || self.steps < self.blocks {
            return Err("there is at least a block, and a step in a block".into());
        }
        Ok(self)
    }

    fn set(&mut self, flag: &str, value: &str) -> Result<(), Problem> {
        match flag {
            "--threads" => self.threads = list(value)?,
            "--iterations" => self.iterations = value.parse()?,
            "--cone" => self.cones = cones(value)?,
            "--settle" => self.settle = value.parse()?,
            "--steps" => self.steps = value.parse()?,
            "--blocks" => self.blocks = value.parse()?,
            "--csv" => self.csv = Some(value.to_owned()),
            _ => return Err("there is no such flag".into()),
        }
        Ok(())
    }
}

/// Scenes by their names, with `:COUNT` behind them or with each of these counts.
fn scenes_of(words: &str, counts: &[Option<u64>]) -> Result<Vec<(String, Option<u64>)>, Problem> {
    let mut scenes = Vec::new();
    for word in words.split(',') {
        if let Some((name, count)) = word.split_once(':') {
            scenes.push((name.to_owned(), Some(count.parse()?)));
        } else {
            scenes.extend(counts.iter().map(|&count| (word.to_owned(), count)));
        }
    }
    Ok(scenes)
}

/// Numbers separated by commas.
fn list<T: FromStr>(words: &str) -> Result<Vec<T>, T::Err> {
    words.split(',').map(|word| word.trim().parse()).collect()
}

fn cones(word: &str) -> Result<Vec<Cone>, Problem> {
    match word {
        "coupled" => Ok(vec![Cone::Coupled]),
        "ranges" => Ok(vec![Cone::Ranges]),
        "both" => Ok(vec![Cone::Coupled, Cone::Ranges]),
        _ => Err("it is `coupled`, `ranges` or `both`".into()),
    }
}

/// An engine by its name, with `:METHOD` behind it where it isn't the method of all.
fn engine_of(word: &str, settings: &Settings) -> Result<(EngineEntry, Settings), Problem> {
    let (name, method) = word.split_once(':').unzip();
    let name = name.unwrap_or(word);
    let found = ENGINES.iter().find(|engine| engine.name == name);
    let known = || ENGINES.iter().map(|engine| engine.name).collect::<Vec<_>>();
    let unknown = || format!("`--engines {word}`: there are: {}", known().join(", "));
    let settings = match method {
        Some(method) => settings.clone().with_method(method),
        None => settings.clone(),
    };
    Ok((*found.ok_or_else(unknown)?, settings))
}
