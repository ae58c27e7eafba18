//! The race: one scene on two to four engines or methods at once, step by step together, with the time
//! that each needs and the errors that each makes.
//!
//! In a window the contenders stand side by side under one camera; without one, a table says how each
//! did. The gallery has races worth seeing.

mod contender;
mod curves;
mod error;
pub mod gallery;
mod headless;
mod menu;
mod panel;
mod plots;
mod run;
mod runner;

use std::fmt::Write as _;
use std::path::PathBuf;

use ch00_scenes::{Scene, Settings};
use ch00_shell::cli::Args;
use ch00_shell::clock::Pace;
use ch00_shell::show::Show;
use ch00_shell::{Extras, Opening, Session, ShellError};

use crate::{CHAPTER, FindingsError};

pub use contender::Contender;
pub use error::RaceError;
pub use menu::RaceMenu;
pub use run::Race;

/// Flags that a race has no use for: contenders say how they run.
pub const NOT_FOR_A_RACE: [&str; 11] = [
    "engine",
    "method",
    "substeps",
    "sweeps",
    "threads",
    "variable_step",
    "explain",
    "dump",
    "layers",
    "dissect",
    "solid",
];

/// What the window has besides the shell's own sections.
#[must_use]
pub fn extras() -> Extras {
    Extras {
        menus: vec![Box::new(RaceMenu::default())],
        runs: None,
    }
}

/// How to start a race, for the end of `--help`.
#[must_use]
pub fn help(program: &str) -> String {
    let mut text = format!(
        "\n  {program} --race lanes:own-row@16,properties:printed --scene chain\n      \
         run a scene on both, side by side\n\nRaces of the gallery, such as `{program} --race cradle`:"
    );
    for setup in gallery::GALLERY {
        let _ = write!(text, "\n  {:<14} {}", setup.name, setup.contenders);
    }
    text + "\n\nCharts:"
}

/// Runs the race that the command line wants: `--race` and the flags of every run.
///
/// # Errors
/// [`FindingsError`] for contenders, scenes and files that can't be had.
pub fn run(contenders: &str, args: &Args) -> Result<(), FindingsError> {
    let race = of_command_line(contenders, args)?;
    if args.is_headless() {
        return headless::run(race, args, args.screenshot.clone());
    }
    match open(race) {
        Err(error @ (ShellError::NoDisplay(_) | ShellError::NoAdapter(_))) => {
            eprintln!("{error}; running without a window");
            let race = of_command_line(contenders, args)?;
            let steps = u64::from(race.scene().steps);
            let name = format!("{}-race", race.scene().name);
            let picture = ch00_shell::headless::picture_name(&name, steps);
            headless::run(race, args, picture_if_possible(picture))
        }
        outcome => Ok(outcome?),
    }
}

/// The picture, where there is an adapter to draw it.
fn picture_if_possible(picture: PathBuf) -> Option<PathBuf> {
    match ch00_shell::Gpu::shared() {
        Ok(_) => Some(picture),
        Err(error) => {
            eprintln!("no pictures: {error}");
            None
        }
    }
}

/// The contenders, or those of a set-up of the gallery with its scene; in the scene of the flags.
fn of_command_line(contenders: &str, args: &Args) -> Result<Race, FindingsError> {
    let setup = gallery::find(contenders.trim());
    let race = match setup {
        Some(setup) => {
            if let Some(scene) = &args.scene {
                return Err(RaceError::GalleryScene {
                    name: setup.name,
                    scene: scene.clone(),
                }
                .into());
            }
            let mut args = args.clone();
            args.scene = Some(setup.scene.to_owned());
            args.count = args.count.or(setup.count);
            let contenders = Contender::all(setup.contenders)?;
            Race::new(args.scene(&CHAPTER)?, contenders)?.to_watch(setup)
        }
        None => Race::new(args.scene(&CHAPTER)?, Contender::all(contenders)?)?,
    };
    race.check_settings()?;
    Ok(race)
}

/// Opens a window on the race.
fn open(race: Race) -> Result<(), ShellError> {
    let menu = RaceMenu::of(&race);
    let Opening { runs, session } = opening(race)?;
    let extras = Extras {
        menus: vec![Box::new(menu)],
        runs: Some(runs),
    };
    ch00_shell::open(&CHAPTER, session, Pace::Fixed, Show::default(), extras)
}

/// The race, and a session of its scene on the first engine that takes it.
fn opening(race: Race) -> Result<Opening, ShellError> {
    let scene = race.scene().clone();
    let (entry, settings) = race
        .first_running()
        .unwrap_or((CHAPTER.engines[0], Settings::defaults()));
    let session = Session::new(scene, entry, settings)?;
    Ok(Opening {
        runs: Box::new(race),
        session,
    })
}

/// A race in a scene of the gallery.
///
/// # Errors
/// [`FindingsError`] if the scene or its contenders can't be had.
pub fn of_gallery(setup: &'static gallery::Setup) -> Result<Race, FindingsError> {
    let scene = Scene::open(setup.scene, setup.count, None)?;
    Ok(Race::new(scene, Contender::all(setup.contenders)?)?.to_watch(setup))
}
