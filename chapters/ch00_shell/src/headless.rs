//! A run without a window: so many steps, timed one by one, then a summary, and if wanted
//! the states in a file and a picture of the last one.
//!
//! Files are opened before the first step, so that a path that can't be written costs no
//! run. Overlaps and joints are measured after every k-th step and the last; k is the number
//! of bodies over 5000, rounded up.

use std::fs::{OpenOptions, remove_file};
use std::io::{ErrorKind, Write, stdout};
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::clock::variable_step;
use crate::error::ShellError;
use crate::frame_rate::FrameRate;
use crate::screenshot::{self, View};
use crate::session::Session;
use crate::show::Wish;
use crate::state_file::StateFile;
use crate::summary::{Summary, Timing};
use crate::worst::{Worst, deepest};

/// What a run writes besides its summary.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// One line of JSON instead of a table; no progress bar.
    pub json: bool,
    /// Each step as long as the last one took.
    pub variable_step: bool,
    /// Where the states go.
    pub dump: Option<Dump>,
    /// Whether and where the last state is drawn.
    pub picture: Picture,
    /// What is drawn besides the bodies.
    pub wish: Wish,
    /// From where it is drawn.
    pub view: View,
}

/// A file of states.
#[derive(Clone, Debug)]
pub struct Dump {
    /// The file.
    pub file: PathBuf,
    /// Every how many steps a state is written; the first and the last always are.
    pub every: u32,
}

/// Whether the last state is drawn.
#[derive(Clone, Debug, Default)]
pub enum Picture {
    /// No.
    #[default]
    None,
    /// Yes; without an adapter that is an error.
    Wanted(PathBuf),
    /// Yes, into the current directory, if there is an adapter.
    IfPossible,
}

/// Makes the scene's steps and reports them on the standard output.
///
/// # Errors
/// [`ShellError::Write`] for a file that can't be written, and what
/// [`screenshot::save`] answers where a picture is wanted.
pub fn run(mut session: Session, options: &Options) -> Result<(), ShellError> {
    if let Picture::Wanted(file) = &options.picture {
        check_writable(file)?;
    }
    let summary = simulate(&mut session, options)?;
    print(&if options.json {
        summary.json() + "\n"
    } else {
        summary.to_string()
    })?;
    draw(&session, options)
}

/// Makes the scene's steps and says how they went; prints nothing but the progress bar.
///
/// # Errors
/// [`ShellError::Write`] for a dump that can't be written, [`ShellError::Stopped`] if the engine fails
/// and no other one can go on.
pub fn simulate(session: &mut Session, options: &Options) -> Result<Summary, ShellError> {
    let mut states = StateFile::create(options.dump.as_ref(), session)?;
    let progress = progress_bar(session, options.json);
    let mut times = FrameRate::of_run();
    let mut worst = Worst::at_start(session);
    let last = session.scene().steps;
    let mut dt = session.dt();
    while session.steps() < u64::from(last) {
        session.step_by(dt);
        hear_of_failure(session, &progress)?;
        if session.steps() > 1 {
            times.record(session.step_time());
        }
        if options.variable_step {
            dt = variable_step(session.step_time().as_secs_f64());
        }
        worst.measure(session, last);
        states.write(session, last)?;
        progress.inc(1);
    }
    progress.finish_and_clear();
    states.finish()?;
    Ok(summarise(session, options, Timing::of(&times), &worst))
}

/// Says so where the engine has failed and another one went on.
fn hear_of_failure(session: &mut Session, progress: &ProgressBar) -> Result<(), ShellError> {
    let notice = session.take_notice();
    if let Some(why) = session.failure() {
        return Err(ShellError::Stopped(why.to_owned()));
    }
    if let Some(notice) = notice {
        progress.suspend(|| eprintln!("{notice}"));
    }
    Ok(())
}

fn summarise(session: &Session, options: &Options, timing: Timing, worst: &Worst) -> Summary {
    let info = session.engine().info();
    let Worst { last, .. } = worst;
    let deepest_now = deepest(&last.penetration);
    Summary {
        scene: session.scene().name.clone(),
        engine: info.engine,
        method: info.method,
        threads: info.threads,
        device: info.device,
        n: session.scene().bodies.len(),
        joints: session.scene().joints.len(),
        steps: session.steps(),
        dt: (!options.variable_step).then_some(session.dt()),
        substeps: info.substeps,
        timing,
        max_penetration_final_m: deepest_now,
        p99_penetration_final_m: deepest_now.map(|_| last.penetration.p99),
        max_penetration_run_m: worst.penetration,
        max_joint_separation_final_m: last.joint_separation,
        max_joint_separation_run_m: worst.joint_separation,
        escaped: worst.escaped,
        nan: last.not_finite,
        overflow: session.engine().counters().overflow,
        kinetic_energy_final: Some(last.conserved.kinetic_energy),
        momentum_error: session.history().largest_momentum_error(),
        max_limit_excess_final_rad: last.limit_excess,
    }
}

/// Writes to the standard output. That nobody reads it any more (`| head`) is no error.
///
/// # Errors
/// [`ShellError::Write`] where it can't be written.
pub fn print(text: &str) -> Result<(), ShellError> {
    match stdout().lock().write_all(text.as_bytes()) {
        Err(source) if source.kind() != ErrorKind::BrokenPipe => Err(ShellError::Write {
            file: PathBuf::from("the standard output"),
            source,
        }),
        _ => Ok(()),
    }
}

/// Draws the last state, if it shall and can be drawn.
fn draw(session: &Session, options: &Options) -> Result<(), ShellError> {
    match &options.picture {
        Picture::None => Ok(()),
        Picture::Wanted(file) => {
            say_drawn(file, &save(session, options, file)?);
            Ok(())
        }
        Picture::IfPossible => draw_if_possible(session, options),
    }
}

fn save(session: &Session, options: &Options, file: &Path) -> Result<String, ShellError> {
    let show = options.wish.show(session);
    if options.wish.dissect.is_some() && show.pair.is_none() {
        eprintln!("no two bodies are near each other, so no pair is looked at");
    }
    screenshot::save(session, &show, options.view, file)
}

fn draw_if_possible(session: &Session, options: &Options) -> Result<(), ShellError> {
    let file = picture_name(&session.scene().name, session.steps());
    match save(session, options, &file) {
        Ok(adapter) => {
            say_drawn(&file, &adapter);
            Ok(())
        }
        Err(ShellError::NoAdapter(why)) => {
            eprintln!("no pictures: no graphics adapter was found ({why})");
            Ok(())
        }
        Err(error) => Err(error),
    }
}

fn say_drawn(file: &Path, adapter: &str) {
    eprintln!(
        "{}: the state after the last step, drawn by {adapter}",
        file.display()
    );
}

/// `balls-after-600-steps.png`; what can't stand in a file's name becomes `_`.
#[must_use]
pub fn picture_name(scene: &str, steps: u64) -> PathBuf {
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_".contains(c) {
            c
        } else {
            '_'
        }
    };
    let scene: String = scene.chars().take(64).map(plain).collect();
    PathBuf::from(format!("{scene}-after-{steps}-steps.png"))
}

/// Opens the file for writing, leaves what stands in it, and leaves none where there was none.
///
/// # Errors
/// [`ShellError::Write`] where it can't be.
pub fn check_writable(file: &Path) -> Result<(), ShellError> {
    let existed = file.exists();
    let check = || {
        OpenOptions::new().create(true).append(true).open(file)?;
        if existed { Ok(()) } else { remove_file(file) }
    };
    check().map_err(|source| ShellError::Write {
        file: file.to_owned(),
        source,
    })
}

/// On the standard error, so that it doesn't mix with results; not shown beside JSON, nor
/// where the standard error is no terminal.
fn progress_bar(session: &Session, json: bool) -> ProgressBar {
    let target = if json {
        ProgressDrawTarget::hidden()
    } else {
        ProgressDrawTarget::stderr()
    };
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} steps, {eta} left")
        .expect("a template without mistakes, as the test shows");
    ProgressBar::with_draw_target(Some(u64::from(session.scene().steps)), target)
        .with_style(style)
        .with_message(session.scene().name.clone())
}

#[cfg(test)]
mod tests;
