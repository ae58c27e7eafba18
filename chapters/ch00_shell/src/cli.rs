//! The command line: its flags, what they choose, and how errors end the program.
//!
//! [`Args`] is a group of flags and no program of its own, so that a chapter which has more
//! to say can flatten it into its own parser, with [`examples`] after its help.

mod help;
mod values;

use std::path::PathBuf;
use std::process::ExitCode;

use ch00_scenes::{EngineEntry, Layer, Scene, Settings};
use clap::FromArgMatches;
use glam::Vec2;

use crate::chapter::Chapter;
use crate::clock::Pace;
use crate::error::ShellError;
use crate::headless::{Dump, Picture};
use crate::render::Theme;
use crate::screenshot::View;
use crate::session::Session;
use crate::show::{Dissect, Show, Wish};
use crate::side_by_side::Extras;
use crate::{app, headless};
use help::explain;
pub use help::{command, examples};
use values::{at_least_one, dissect, layer, step_count, step_size, view_angles, whole_number};

/// The flags that all chapters share.
#[derive(Clone, Debug, Default, clap::Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag")]
pub struct Args {
    /// Built-in scene, or the path of a scene file
    #[arg(
        long,
        value_name = "NAME|FILE.json",
        help_heading = "What is simulated"
    )]
    pub scene: Option<String>,
    /// Number of bodies that a built-in scene makes
    #[arg(long, value_name = "N", help_heading = "What is simulated",
          allow_negative_numbers = true, value_parser = whole_number)]
    pub count: Option<u64>,
    /// Seed of what is random in a built-in scene
    #[arg(long, value_name = "S", help_heading = "What is simulated",
          allow_negative_numbers = true, value_parser = whole_number)]
    pub seed: Option<u64>,

    /// Architecture that steps the scene
    #[arg(long, value_name = "NAME", help_heading = "How it is simulated")]
    pub engine: Option<String>,
    /// Mathematics that the engine uses
    #[arg(long, value_name = "NAME", help_heading = "How it is simulated")]
    pub method: Option<String>,
    /// Size of a step in seconds, instead of the scene's
    #[arg(long, value_name = "SECONDS", help_heading = "How it is simulated",
          allow_negative_numbers = true, value_parser = step_size)]
    pub dt: Option<f64>,
    /// Parts of a step, for methods that divide it
    #[arg(long, value_name = "K", help_heading = "How it is simulated",
          allow_negative_numbers = true, value_parser = at_least_one)]
    pub substeps: Option<u32>,
    /// Times that a step goes over its contacts, for methods that do
    #[arg(long, value_name = "K", help_heading = "How it is simulated",
          allow_negative_numbers = true, value_parser = at_least_one)]
    pub sweeps: Option<u32>,
    /// Threads, for engines that have more than one
    #[arg(long, value_name = "T", help_heading = "How it is simulated",
          allow_negative_numbers = true, value_parser = at_least_one)]
    pub threads: Option<u32>,
    /// Let bodies sleep that have come to rest, for engines in which they can
    #[arg(long, help_heading = "How it is simulated")]
    pub sleeping: bool,
    /// Make each step as long as the last one took, as the report does: results then vary
    #[arg(long, help_heading = "How it is simulated")]
    pub variable_step: bool,
    /// Say what the engine does with this scene and why, and run nothing
    #[arg(long, help_heading = "How it is simulated")]
    pub explain: bool,

    /// Print a table instead of opening a window; the flags below imply it
    #[arg(long, help_heading = "Running without a window")]
    pub headless: bool,
    /// Number of steps, instead of the scene's
    #[arg(long, value_name = "N", help_heading = "Running without a window",
          allow_negative_numbers = true, value_parser = step_count)]
    pub steps: Option<u32>,
    /// Print one line of JSON instead of the table
    #[arg(long, help_heading = "Running without a window")]
    pub json: bool,
    /// Write the bodies' states to a file as the run goes on
    #[arg(long, value_name = "FILE", help_heading = "Running without a window")]
    pub dump: Option<PathBuf>,
    /// Write every K-th state; the first and the last are always written [default: 1]
    #[arg(long, value_name = "K", help_heading = "Running without a window", requires = "dump",
          allow_negative_numbers = true, value_parser = at_least_one)]
    pub dump_every: Option<u32>,
    /// Draw the state after the last step into a picture
    #[arg(
        long,
        value_name = "FILE.png",
        help_heading = "Running without a window"
    )]
    pub screenshot: Option<PathBuf>,

    /// Layers to draw over the bodies, separated by commas: aabbs, cells, contacts, frames,
    /// joint-frames, limits
    #[arg(long, value_name = "LAYER,…", help_heading = "What is shown besides the bodies",
          value_delimiter = ',', value_parser = layer)]
    pub layers: Vec<Layer>,
    /// Look into the narrow phase of bodies A and B after its iteration STEP, from 1 [default:
    /// the last]; `deepest` is the pair of the deepest contact
    #[arg(long, value_name = "A,B[,STEP]|deepest[,STEP]", value_parser = dissect,
          help_heading = "What is shown besides the bodies")]
    pub dissect: Option<Dissect>,
    /// Draw bodies solid while layers are shown, not as glass
    #[arg(long, help_heading = "What is shown besides the bodies")]
    pub solid: bool,
    /// Draw the picture from this angle about the vertical and above the horizontal, in degrees,
    /// and so much closer than needed to see everything
    #[arg(long, value_name = "YAW,PITCH[,ZOOM]", value_parser = view_angles,
          allow_negative_numbers = true, allow_hyphen_values = true,
          help_heading = "What is shown besides the bodies", requires = "screenshot")]
    pub view: Option<(Vec2, f32)>,
    /// Draw the picture in dark colours
    #[arg(
        long,
        help_heading = "What is shown besides the bodies",
        requires = "screenshot"
    )]
    pub dark: bool,
}

impl Args {
    /// Whether the run has an end, and so no window.
    #[must_use]
    pub fn is_headless(&self) -> bool {
        self.headless
            || self.json
            || self.steps.is_some()
            || self.dump.is_some()
            || self.screenshot.is_some()
    }

    /// What shall be shown besides the bodies.
    #[must_use]
    pub fn wish(&self) -> Wish {
        Wish {
            layers: self.layers.clone(),
            is_solid: self.solid,
            dissect: self.dissect,
        }
    }

    /// From where a picture is drawn, and in which colours.
    #[must_use]
    pub fn view(&self) -> View {
        View {
            angles_and_zoom: self.view,
            theme: if self.dark { Theme::Dark } else { Theme::Light },
        }
    }

    /// What a run without a window writes; without a wish for one, `picture` stands.
    fn headless_options(&self, picture: Picture) -> headless::Options {
        headless::Options {
            wish: self.wish(),
            view: self.view(),
            json: self.json,
            variable_step: self.variable_step,
            dump: self.dump.clone().map(|file| Dump {
                file,
                every: self.dump_every.unwrap_or(1),
            }),
            picture: self.screenshot.clone().map_or(picture, Picture::Wanted),
        }
    }

    /// What the user chose about the engine.
    #[must_use]
    pub fn settings(&self) -> Settings {
        Settings {
            method: self.method.clone(),
            sweeps: self.sweeps,
            substeps: self.substeps,
            threads: self.threads,
            sleeping: self.sleeping,
        }
    }

    /// The scene with the flags that change it.
    ///
    /// # Errors
    /// [`ShellError::Scene`] if there is no such scene or it can't be simulated.
    pub fn scene(&self, chapter: &Chapter) -> Result<Scene, ShellError> {
        let name = self.scene.as_deref().unwrap_or(chapter.default_scene);
        let mut scene = Scene::open(name, self.count, self.seed)?;
        scene.dt = self.dt.unwrap_or(scene.dt);
        scene.steps = self.steps.unwrap_or(scene.steps);
        Ok(scene)
    }

    /// The engine, or the chapter's first.
    ///
    /// # Errors
    /// [`ShellError::Engine`] that lists the chapter's engines.
    pub fn engine(&self, chapter: &Chapter) -> Result<EngineEntry, ShellError> {
        match &self.engine {
            None => Ok(chapter.engines[0]),
            Some(name) => chapter.engine(name),
        }
    }

    /// The scene on the engine, before its first step.
    ///
    /// # Errors
    /// [`ShellError`] where scene, engine or settings can't be had.
    pub fn session(&self, chapter: &Chapter) -> Result<Session, ShellError> {
        let entry = self.engine(chapter)?;
        let settings = self.settings();
        entry.method(&settings)?;
        let session = Session::new(self.scene(chapter)?, entry, settings)?;
        Ok(session.with_fallbacks(chapter.engines))
    }
}

/// A chapter's program: reads the command line, runs, and says how it ended.
///
/// Exit status 0; 1 for an error, told in one paragraph; 2 for a usage error, told by clap.
#[must_use]
pub fn main(chapter: &Chapter) -> ExitCode {
    let mut command = command(chapter);
    let matches = command.get_matches_mut();
    match Args::from_arg_matches(&matches) {
        Ok(args) => report(run(chapter, &args)),
        Err(error) => error.format(&mut command).exit(),
    }
}

/// Ends a program: says what went wrong, if something did, and gives the exit status.
#[must_use]
pub fn report(outcome: Result<(), ShellError>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Does what the flags say: explains, runs without a window, or opens one.
///
/// # Errors
/// [`ShellError`] for whatever can't be had or written.
pub fn run(chapter: &Chapter, args: &Args) -> Result<(), ShellError> {
    run_with(chapter, args, Extras::default())
}

/// The same with what a program adds to the window.
///
/// # Errors
/// [`ShellError`] for whatever can't be had or written.
pub fn run_with(chapter: &Chapter, args: &Args, extras: Extras) -> Result<(), ShellError> {
    let session = args.session(chapter)?;
    args.wish().check(&session)?;
    if args.explain {
        headless::print(&explain(&session))
    } else if args.is_headless() {
        headless::run(session, &args.headless_options(Picture::None))
    } else {
        open_window(chapter, args, session, extras)
    }
}

/// Opens a window; without a display or an adapter says so and runs headless instead.
fn open_window(
    chapter: &Chapter,
    args: &Args,
    session: Session,
    extras: Extras,
) -> Result<(), ShellError> {
    let pace = if args.variable_step {
        Pace::Variable
    } else {
        Pace::Fixed
    };
    let show = args.wish().show(&session);
    match open(chapter, session, pace, show, extras) {
        Err(error @ (ShellError::NoDisplay(_) | ShellError::NoAdapter(_))) => {
            eprintln!("{error}; running without a window");
            headless::run(
                args.session(chapter)?,
                &args.headless_options(Picture::IfPossible),
            )
        }
        outcome => outcome,
    }
}

/// Opens a window on a session and returns when it is closed.
///
/// # Errors
/// [`ShellError::NoDisplay`] or [`ShellError::NoAdapter`] where there can be no window,
/// [`ShellError::Graphics`] if the device fails.
pub fn open(
    chapter: &Chapter,
    session: Session,
    pace: Pace,
    show: Show,
    extras: Extras,
) -> Result<(), ShellError> {
    display()?;
    app::run(chapter, session, pace, show, extras)
}

/// Whether a window can be hoped for: X11 and Wayland say so in the environment.
fn display() -> Result<(), ShellError> {
    let needs_variable = cfg!(all(unix, not(target_os = "macos")));
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    if needs_variable && !DISPLAY_VARIABLES.into_iter().any(is_set) {
        let names = DISPLAY_VARIABLES.join(", ");
        return Err(ShellError::NoDisplay(format!("none of {names} is set")));
    }
    Ok(())
}

const DISPLAY_VARIABLES: [&str; 3] = ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"];

#[cfg(test)]
mod tests;
