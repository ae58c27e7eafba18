//! From a class to columns in seven small steps. Each is a whole program: a number of balls that fly
//! and bounce on a floor, always by the same formulas, so that all of them print the same hash.
//!
//! `cargo run --release -p ch05_properties --no-default-features --example from_class_to_columns`;
//! with `-- --step K` one step and what is new in it, with `-- --check` without the times, with
//! `-- --write` for all N and into the book.

mod ball;
mod chart;
mod measure;
mod step_1_class;
mod step_2_structs;
mod step_3_parts;
mod step_4_columns;
mod step_5_container;
mod step_6_systems;
mod step_7_ids;
mod tables;
mod world;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

use ball::{Ball, balls};
use world::World;

/// A step of time, s.
const DT: f32 = 1.0 / 60.0;
/// So many of them go by before the balls are compared: 10 s.
const FRAMES: usize = 600;
/// So many balls are compared.
const COMPARED: usize = 1_000;
/// For so many the times are printed.
const TIMED: usize = 100_000;
/// For so many they are drawn.
const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, TIMED, 1_000_000];

/// One of the seven.
struct Step {
    number: usize,
    name: &'static str,
    build: fn(&[Ball]) -> Box<dyn World>,
    /// What is new in it, where a program can show that.
    story: Option<fn() -> String>,
}

/// A step of the list.
macro_rules! step {
    ($number:literal, $name:literal, $World:ty, $story:expr) => {
        Step {
            number: $number,
            name: $name,
            build: |balls| Box::new(<$World>::new(balls)),
            story: $story,
        }
    };
}

#[rustfmt::skip]
const STEPS: [Step; 7] = [
    step!(1, "class", step_1_class::Level, None),
    step!(2, "structs", step_2_structs::Balls, None),
    step!(3, "parts", step_3_parts::Parts, None),
    step!(4, "columns", step_4_columns::Columns, None),
    step!(5, "container", step_5_container::Data, Some(step_5_container::story)),
    step!(6, "systems", step_6_systems::Data, Some(step_6_systems::story)),
    step!(7, "IDs", step_7_ids::Level, Some(step_7_ids::story)),
];

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let wanted = Wanted::read(env::args().skip(1))?;
    let steps: Vec<&Step> = STEPS
        .iter()
        .filter(|step| wanted.step.is_none_or(|number| number == step.number))
        .collect();
    let hashes: Vec<u64> = steps.iter().map(|step| hash_of(step)).collect();
    if wanted.check {
        print!("{}", tables::checked(&steps, &hashes));
    } else {
        let rows = measure::all(&steps, TIMED);
        print!("{}", tables::timed(&rows, &hashes));
    }
    if let [step] = steps[..] {
        print!("{}", step.story.map_or(String::new(), |story| story()));
    }
    if let Some(other) = hashes.iter().position(|hash| *hash != hashes[0]) {
        let name = steps[other].name;
        return Err(format!("`{name}` computes other positions than `{}`", steps[0].name).into());
    }
    if wanted.write {
        write(&steps)?;
    }
    Ok(())
}

/// What the command line asks for.
#[derive(Default)]
struct Wanted {
    step: Option<usize>,
    check: bool,
    write: bool,
}

impl Wanted {
    fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut wanted = Self::default();
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--check" => wanted.check = true,
                "--write" => wanted.write = true,
                "--step" => {
                    let number = arguments.next().and_then(|number| number.parse().ok());
                    let number = number.filter(|number| (1..=STEPS.len()).contains(number));
                    let steps = STEPS.len();
                    wanted.step = Some(number.ok_or(format!("--step wants 1 to {steps}"))?);
                }
                other => {
                    return Err(format!(
                        "`{other}`: there are --step K, --check and --write"
                    ));
                }
            }
        }
        Ok(wanted)
    }
}

/// The hash of all positions after ten seconds.
fn hash_of(step: &Step) -> u64 {
    let mut world = (step.build)(&balls(COMPARED, DT));
    for _ in 0..FRAMES {
        world.step(DT);
    }
    world::hash((0..COMPARED).map(|number| world.ball(number)))
}

/// Measures for all N and writes what the book shows.
fn write(steps: &[&Step]) -> Result<(), Box<dyn Error>> {
    let rows: Vec<_> = COUNTS
        .iter()
        .flat_map(|&count| measure::all(steps, count))
        .collect();
    let charts = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/charts");
    fs::create_dir_all(&charts)?;
    fs::write(charts.join("ch05_steps.csv"), tables::csv(&rows))?;
    fs::write(charts.join("ch05_steps.txt"), tables::at(&rows, TIMED))?;
    fs::write(charts.join("ch05_steps_counts.txt"), tables::counts(&rows))?;
    chart::draw(&rows, &charts.join("ch05_steps.svg"))?;
    println!("written to {}", charts.canonicalize()?.display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_steps_compute_the_same_positions_bit_by_bit() {
        let hashes = STEPS.each_ref().map(hash_of);
        assert_eq!(hashes, [hashes[0]; STEPS.len()]);
    }

    #[test]
    fn all_steps_hand_back_the_balls_that_they_were_given() {
        let balls = balls(10, DT);
        for step in STEPS {
            let world = (step.build)(&balls);
            let same = (0..10).all(|number| world.ball(number) == balls[number]);
            assert!(same, "{}", step.name);
        }
    }

    #[test]
    fn no_ball_is_ever_below_the_floor() {
        let mut world = (STEPS[0].build)(&balls(10, DT));
        for _ in 0..FRAMES {
            world.step(DT);
            let above = |number| world.ball(number).position.y >= world.ball(number).radius;
            assert!((0..10).all(above));
        }
    }
}
