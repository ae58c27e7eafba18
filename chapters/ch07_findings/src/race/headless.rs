//! A race without a window: all steps, then a table with a contender a row, or a line of JSON each, and a picture
//! of the last state if one is wanted.

use std::fmt::Write as _;
use std::path::PathBuf;

use ch00_scenes::Scene;
use ch00_shell::cli::Args;
use ch00_shell::headless::{check_writable, print};
use ch00_shell::screenshot::save_beside;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};

use super::Race;
use super::runner::Runner;
use crate::FindingsError;

/// Bodies of one contender up to which it is measured after every step; beyond, after every second for
/// twice as many, and so on. The interval follows from the scene, so that two runs measure the same steps.
const BODIES_MEASURED_A_STEP: usize = 2000;

/// Makes the scene's steps, prints the table, draws the picture.
///
/// # Errors
/// [`FindingsError::Shell`] for what can't be written or drawn.
pub fn run(mut race: Race, args: &Args, picture: Option<PathBuf>) -> Result<(), FindingsError> {
    if let Some(file) = &picture {
        check_writable(file)?;
    }
    simulate(&mut race);
    let text = if args.json { json(&race) } else { table(&race) };
    print(&text)?;
    if let Some(file) = picture {
        let adapter = save_beside(&mut race, args.view(), &file)?;
        eprintln!(
            "{}: the states after the last step, drawn by {adapter}",
            file.display()
        );
    }
    Ok(())
}

/// Makes the scene's steps.
fn simulate(race: &mut Race) {
    let last = u64::from(race.scene().steps);
    let every = race.scene().bodies.len().div_ceil(BODIES_MEASURED_A_STEP);
    let every = every.max(1) as u64;
    let progress = progress_bar(race);
    while race.steps() < last {
        race.step_all();
        if race.steps().is_multiple_of(every) || race.steps() == last {
            race.measure();
        }
        progress.inc(1);
    }
    progress.finish_and_clear();
}

/// What ran, and a row a contender.
pub fn table(race: &Race) -> String {
    let scene = race.scene();
    let mut text = format!(
        "{}: {} bodies, {} joints, {} steps of {:.6} s\n",
        scene.name,
        scene.bodies.len(),
        scene.joints.len(),
        race.steps(),
        scene.dt
    );
    if let Some(setup) = race.setup {
        let _ = writeln!(text, "watch: {} [{}]", setup.watch, setup.page.0);
    }
    let names: Vec<String> = race.runners.iter().map(Runner::name).collect();
    let width = names.iter().map(|name| name.chars().count()).max();
    let width = width.unwrap_or(0).max(9);
    let _ = writeln!(
        text,
        "\n{:<width$} {:>10} {:>11} {:>11} {:>11} {:>11}  hash",
        "contender", "median ms", "energy", "overlap m", "p99 m", "joint m"
    );
    for (name, runner) in names.iter().zip(&race.runners) {
        let _ = writeln!(text, "{name:<width$} {}", row(runner));
    }
    text
}

/// A line a contender, with the names that a run by itself has; null where there is nothing to tell.
pub fn json(race: &Race) -> String {
    let mut text = String::new();
    for runner in &race.runners {
        let _ = writeln!(text, "{}", line(race.scene(), runner));
    }
    text
}

fn line(scene: &Scene, runner: &Runner) -> Value {
    let last = runner.curve.last();
    let session = runner.session.as_ref().ok();
    let info = session.map(|session| session.engine().info());
    let info = info.as_ref();
    json!({
        "scene": scene.name,
        "contender": runner.contender.to_string(),
        "engine": info.map(|info| info.engine),
        "method": info.map(|info| info.method),
        "device": info.map(|info| info.device.clone()),
        "n": scene.bodies.len(),
        "joints": scene.joints.len(),
        "steps": session.map(ch00_shell::Session::steps),
        "dt": scene.dt,
        "substeps": info.map(|info| info.substeps),
        "sweeps": info.and_then(|info| info.sweeps),
        "median_ms": runner.median_ms(),
        "energy_error_final": last.and_then(|last| last.energy_error),
        "p99_penetration_final_m": last.and_then(|last| last.p99),
        "max_penetration_run_m": session.and(runner.deepest),
        "max_joint_separation_run_m": runner.widest,
        "hash": session.map(|session| format!("{:016x}", session.state_now().hash())),
        "trouble": runner.trouble(),
    })
}

/// The numbers of a contender, or why there are none.
fn row(runner: &Runner) -> String {
    let Ok(session) = &runner.session else {
        return format!("can't: {}", runner.trouble().unwrap_or_default());
    };
    let last = runner.curve.last();
    let columns = [
        number(runner.median_ms(), 10),
        number(last.and_then(|last| last.energy_error), 11),
        number(runner.deepest, 11),
        number(last.and_then(|last| last.p99), 11),
        number(runner.widest, 11),
    ];
    let hash = session.state_now().hash();
    let stopped = runner.stopped.as_ref();
    let stopped = stopped.map_or_else(String::new, |why| format!("  {why}"));
    format!("{}  {hash:016x}{stopped}", columns.join(" "))
}

/// Four digits, with an exponent where the number is small or large; a dash where there is none.
fn number(value: Option<f64>, width: usize) -> String {
    match value {
        None => format!("{:>width$}", "-"),
        Some(0.0) => format!("{:>width$}", "0"),
        Some(value) if (1e-2..1e4).contains(&value.abs()) => format!("{value:>width$.4}"),
        Some(value) => format!("{value:>width$.3e}"),
    }
}

/// On the standard error, so that it doesn't mix with results; not shown where that is no terminal.
fn progress_bar(race: &Race) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} steps, {eta} left")
        .expect("a template without mistakes, as the test shows");
    let length = Some(u64::from(race.scene().steps));
    ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr())
        .with_style(style)
        .with_message(race.scene().name.clone())
}

#[cfg(test)]
mod tests {
    use super::super::Contender;
    use super::*;

    fn race(scene: &str, contenders: &str, steps: u32) -> Race {
        let mut scene = Scene::open(scene, None, None).expect("a built-in");
        scene.steps = steps;
        let contenders = Contender::all(contenders).expect("they are");
        let mut race = Race::new(scene, contenders).expect("one can run it");
        simulate(&mut race);
        race
    }

    #[test]
    fn objects_and_properties_run_with_the_same_bits() {
        let race = race("oblique", "objects,properties,lanes", 60);
        let hash = |i: usize| {
            let session = race.runners[i].session.as_ref().expect("it runs");
            session.state_now().hash()
        };
        assert_eq!(hash(0), hash(1));
        assert_ne!(hash(0), hash(2));
        let table = table(&race);
        assert_eq!(table.lines().count(), 6, "{table}");
        let hash = format!("{:016x}", hash(2));
        for words in ["oblique: ", "60 steps", "lanes · own-row · ", hash.as_str()] {
            assert!(table.contains(words), "`{words}` isn't in: {table}");
        }
    }

    #[test]
    fn who_cannot_run_the_scene_says_why_and_the_others_go_on() {
        let race = race("oblique", "objects@4,lanes", 5);
        let table = table(&race);
        assert!(table.contains("can't: "), "{table}");
        assert_eq!(race.steps(), 5);
        assert!(race.check_settings().is_err());
        let text = "objects@4,properties@4";
        let scene = Scene::open("oblique", None, None).expect("a built-in");
        let nobody = Race::new(scene, Contender::all(text).expect("they are"));
        assert!(nobody.is_err());
    }

    #[test]
    fn json_has_a_line_each_with_the_numbers_of_the_table_or_the_trouble() {
        let race = race("oblique", "objects@4,lanes", 5);
        let lines: Vec<Value> = json(&race)
            .lines()
            .map(|line| serde_json::from_str(line).expect("JSON"))
            .collect();
        assert_eq!(lines.len(), 2);
        assert!(lines[0]["trouble"].is_string() && lines[0]["median_ms"].is_null());
        assert_eq!(
            (&lines[1]["engine"], &lines[1]["steps"]),
            (&json!("lanes"), &json!(5))
        );
        assert!(lines[1]["trouble"].is_null() && lines[1]["median_ms"].is_number());
        let hash = lines[1]["hash"].as_str().expect("a hash");
        assert!(table(&race).contains(hash), "{hash}");
    }

    #[test]
    fn the_progress_bar_has_a_valid_template() {
        progress_bar(&race("pair", "objects,lanes", 1)).finish_and_clear();
    }
}
