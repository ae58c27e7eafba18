//! What the command line says.

use ch00_scenes::{EngineEntry, Settings};

use crate::table::Problem;

/// What `--engine` can name, the default first.
const ENGINES: &[EngineEntry] = &[
    ch06_compute::LANES,
    ch06_compute::COMPUTE,
    ch05_properties::ENGINE,
    ch04_ragdolls::ENGINE,
];

pub struct Options {
    pub engine: EngineEntry,
    pub scene: String,
    /// The scene's own count where there is none.
    pub counts: Vec<Option<u64>>,
    pub settle: u32,
    pub steps: u32,
    pub settings: Settings,
    /// As the engine chooses where there is none.
    pub threads: Vec<Option<u32>>,
    /// How many, if heaps take turns.
    pub turns: Option<u32>,
    pub csv: Option<String>,
    /// Whether there is a heap that may sleep beside the one that may not.
    pub sleeping: bool,
}

/// What is to be timed.
#[derive(Clone, Copy)]
pub struct Heap {
    pub count: Option<u64>,
    pub threads: Option<u32>,
    pub sleeping: bool,
}

impl Options {
    pub fn of(mut words: impl Iterator<Item = String>) -> Result<Self, Problem> {
        let mut options = Self {
            engine: ENGINES[0],
            scene: "pile".to_owned(),
            counts: vec![None],
            settle: 600,
            steps: 200,
            settings: Settings::defaults(),
            threads: vec![None],
            turns: None,
            csv: None,
            sleeping: false,
        };
        while let Some(flag) = words.next() {
            if flag == "--sleeping" {
                options.sleeping = true;
                continue;
            }
            let Some(value) = words.next() else {
                return Err(format!("`{flag}` has no value").into());
            };
            options
                .set(&flag, &value)
                .map_err(|problem| format!("`{flag} {value}`: {problem}"))?;
        }
        Ok(options)
    }

    fn set(&mut self, flag: &str, value: &str) -> Result<(), Problem> {
        match flag {
            "--engine" => self.engine = engine_of(value)?,
            "--scene" => value.clone_into(&mut self.scene),
            "--counts" => {
                let counts = value.split(',').map(|count| count.trim().parse().map(Some));
                self.counts = counts.collect::<Result<_, _>>()?;
            }
            "--settle" => self.settle = value.parse()?,
            "--steps" => self.steps = value.parse()?,
            "--method" => self.settings.method = Some(value.to_owned()),
            "--substeps" => self.settings.substeps = Some(value.parse()?),
            "--threads" => {
                let threads = value.split(',').map(|count| count.trim().parse().map(Some));
                self.threads = threads.collect::<Result<_, _>>()?;
            }
            "--turns" => self.turns = Some(value.parse::<std::num::NonZero<u32>>()?.get()),
            "--csv" => self.csv = Some(value.to_owned()),
            _ => return Err("there is no such flag".into()),
        }
        Ok(())
    }

    /// All heaps, in the order of their lines.
    pub fn heaps(&self) -> Vec<Heap> {
        let mut heaps = Vec::new();
        for &threads in &self.threads {
            for &count in &self.counts {
                for sleeping in [false, true] {
                    if self.sleeping || !sleeping {
                        heaps.push(Heap {
                            count,
                            threads,
                            sleeping,
                        });
                    }
                }
            }
        }
        heaps
    }
}

fn engine_of(name: &str) -> Result<EngineEntry, Problem> {
    let found = ENGINES.iter().find(|engine| engine.name == name);
    let known = || ENGINES.iter().map(|engine| engine.name).collect::<Vec<_>>();
    let unknown = || format!("there are these engines: {}", known().join(", "));
    Ok(*found.ok_or_else(unknown)?)
}
