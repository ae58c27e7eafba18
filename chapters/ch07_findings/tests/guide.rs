//! The guide of the page Findings, "What do I need for my scene?": the program accepts what a line takes, and the
//! kept table of the laboratory says that it reaches the bounds of the scenarios for which the line takes it.

use std::path::Path;

use ch00_shell::cli::{self, Args};
use ch07_findings::CHAPTER;
use ch07_findings::laboratory::runs::measure;
use ch07_findings::laboratory::{CONTENDERS, Cell, Contender, SCENARIOS, Scenario};
use clap::FromArgMatches;

/// A line of the guide.
struct Line {
    /// The first column.
    has: String,
    /// Flags that the second column names.
    takes: Vec<String>,
    /// Scenarios that the third column names, and the rates at which they count, 1/s.
    scenarios: Vec<(&'static Scenario, Vec<u32>)>,
    /// The third column.
    because: String,
}

/// At which rate a scenario counts where a line doesn't say, 1/s.
const USUAL: u32 = 60;

fn book() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

fn read(file: &str) -> String {
    std::fs::read_to_string(book().join(file)).expect("it is in the book")
}

fn cells() -> Vec<Cell> {
    let text = read("charts/laboratory.csv");
    text.lines().filter_map(|line| line.parse().ok()).collect()
}

/// The guide, line by line.
fn guide(page: &str) -> Vec<Line> {
    let (_, section) = page
        .split_once("## What do I need for my scene?")
        .expect("the guide has its heading");
    let rows = section.lines().skip_while(|line| !line.starts_with('|'));
    let rows = rows.take_while(|line| line.starts_with('|')).skip(2);
    rows.map(line).collect()
}

fn line(row: &str) -> Line {
    let columns: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
    let [has, take, because] = columns[..] else {
        panic!("three columns: {row}");
    };
    let spans = take.split('`').skip(1).step_by(2);
    Line {
        has: has.to_owned(),
        takes: spans.map(str::to_owned).collect(),
        scenarios: scenarios(because),
        because: because.to_owned(),
    }
}

/// What stands before the colon: numbers and ranges of numbers, with rates in brackets. A line without a colon
/// names none.
fn scenarios(because: &str) -> Vec<(&'static Scenario, Vec<u32>)> {
    let Some((named, _)) = because.split_once(": ") else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for item in named.split(", ") {
        let (numbers, rates) = item.split_once(" (").unwrap_or((item, ""));
        let (first, last) = numbers.split_once(" to ").unwrap_or((numbers, numbers));
        let number = |text: &str| -> u32 { text.parse().expect("a number of a scenario") };
        let range = number(first)..=number(last);
        let named = SCENARIOS.iter().filter(|one| range.contains(&one.number));
        all.extend(named.map(|one| (one, counted(one, rates))));
    }
    all
}

/// The rates of a scenario that words in brackets mean.
fn counted(scenario: &Scenario, words: &str) -> Vec<u32> {
    let all = scenario.rates.iter().copied();
    let from = words
        .strip_prefix("from ")
        .map(|rest| rest.strip_suffix(" Hz)"));
    match (words, from) {
        ("", _) => vec![USUAL],
        ("at any rate)", _) => all.collect(),
        (_, Some(Some(rate))) => {
            let least: u32 = rate.parse().expect("a rate");
            assert!(scenario.rates.contains(&least), "{words}: it is measured");
            all.filter(|rate| *rate >= least).collect()
        }
        _ => panic!("what rates are {words}"),
    }
}

/// The flags as the program reads them.
fn args(flags: &str) -> Args {
    let words = [CHAPTER.name].into_iter().chain(flags.split(' '));
    let matches = cli::command(&CHAPTER).try_get_matches_from(words);
    let matches = matches.unwrap_or_else(|error| panic!("{flags}: {error}"));
    Args::from_arg_matches(&matches).expect("they were matched")
}

/// Who runs by these flags: of the laboratory's list where it is there, and else as the flags say.
fn contender(flags: &str) -> Contender {
    let args = args(flags);
    let engine = args.engine(&CHAPTER).expect("the program has the engine");
    let method = engine.method(&args.settings());
    let method = method.expect("the engine has the method").name;
    // The twin of the kernels.
    let engine = if engine.name == "compute" {
        ch06_compute::LANES
    } else {
        engine
    };
    let same = |one: &&Contender| one.engine.name == engine.name && one.method == method;
    let usual = CONTENDERS.iter().find(same).expect("the laboratory has it");
    let exact = |one: &&Contender| same(one) && one.substeps == args.substeps;
    let known = CONTENDERS.iter().find(exact).copied();
    known.unwrap_or(Contender {
        name: "as the flags say",
        substeps: args.substeps,
        ..*usual
    })
}

/// The kept cell, or one that is measured here if the laboratory doesn't show these flags.
fn cell(cells: &[Cell], scenario: &Scenario, contender: &Contender, rate: u32) -> Cell {
    let key = (scenario.name, contender.name, rate);
    let kept = cells.iter().find(|cell| cell.key() == key);
    kept.cloned()
        .unwrap_or_else(|| measure(scenario, contender, rate, false).expect("it can be built"))
}

fn reaches(cell: &Cell, scenario: &Scenario) -> bool {
    cell.is_measured() && cell.error <= scenario.pass
}

#[test]
fn what_the_guide_takes_reaches_the_bounds_of_the_scenarios_that_it_names() {
    let (lines, cells) = (guide(&read("ch07_findings.md")), cells());
    assert_eq!(lines.len(), 10);
    let mut missed = Vec::new();
    for line in &lines {
        for flags in &line.takes {
            let contender = contender(flags);
            for (scenario, rates) in &line.scenarios {
                for &rate in rates {
                    let cell = cell(&cells, scenario, &contender, rate);
                    if !reaches(&cell, scenario) {
                        missed.push(format!("{}: {flags}: {cell:?}", line.has));
                    }
                }
            }
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}

#[test]
fn the_program_takes_what_the_guide_takes_on_the_scenes_of_its_scenarios() {
    for line in guide(&read("ch07_findings.md")) {
        let (takes, scenarios) = (&line.takes, &line.scenarios);
        assert_eq!(takes.is_empty(), scenarios.is_empty(), "{}", line.has);
        assert!(!takes.is_empty() || line.because.contains(".md"));
        for flags in takes {
            let args = args(flags);
            let engine = args.engine(&CHAPTER).expect("the program has the engine");
            // It needs a device.
            if engine.name == "compute" {
                continue;
            }
            for (scenario, _) in scenarios {
                for scene in (scenario.scenes)(USUAL, true).expect("it can be built") {
                    let loaded = (engine.load)(&scene, &args.settings());
                    assert!(loaded.is_ok(), "{flags}: {:?}", loaded.err());
                }
            }
        }
    }
}

#[test]
fn where_a_line_says_that_all_others_sink_or_fall_they_do() {
    let cells = cells();
    let lines = guide(&read("ch07_findings.md"));
    let says = |line: &&Line| {
        line.because
            .contains("by all others something sinks or falls")
    };
    let line = lines.iter().find(says).expect("one line does");
    let taken = contender(&line.takes[0]);
    for other in CONTENDERS.iter().filter(|one| one.name != taken.name) {
        let missed = line.scenarios.iter().any(|(scenario, _)| {
            let kept = cells.iter();
            let mut kept = kept.filter(|cell| cell.key() == (scenario.name, other.name, USUAL));
            kept.all(|cell| !reaches(cell, scenario))
        });
        assert!(missed, "{} reaches all bounds", other.name);
    }
}

/// What a line says in numbers: the words, the number in them, the scenario and the flags of its cell, and how
/// many times the cell's error it is.
type Told = (&'static str, &'static str, &'static str, &'static str, f64);

const TOLD: [Told; 4] = [
    ("0.008 % and", "0.008", "heavy_top", "--engine lanes", 1e2),
    (
        "and 0.8 %",
        "0.8",
        "heavy_top",
        "--engine methods --method splitting",
        1e2,
    ),
    (
        "0.06 mm at 672 to 1",
        "0.06",
        "ball_and_chain",
        "--engine lanes --substeps 16",
        1e3,
    ),
    (
        "0.25 mm as it comes",
        "0.25",
        "ball_and_chain",
        "--engine lanes",
        1e3,
    ),
];

/// Half a unit of the last digit.
fn rounding(number: &str) -> f64 {
    let decimals = number.split_once('.').map_or(0, |(_, behind)| behind.len());
    (0..decimals).fold(0.5, |half, _| half / 10.0)
}

#[test]
fn numbers_in_the_guide_are_those_of_the_table() {
    let (lines, cells) = (guide(&read("ch07_findings.md")), cells());
    for (said, number, scenario, flags, times) in TOLD {
        let is_said = |line: &Line| line.because.contains(said);
        assert!(said.contains(number) && lines.iter().any(is_said), "{said}");
        let scenario = SCENARIOS.iter().find(|one| one.name == scenario);
        let scenario = scenario.expect("it is in the list");
        let found = times * cell(&cells, scenario, &contender(flags), USUAL).error;
        let told: f64 = number.parse().expect("a number");
        assert!((found - told).abs() <= rounding(number), "{said}: {found}");
    }
}

#[test]
fn bodies_that_only_fly_and_spin_err_and_cost_as_little_as_the_guide_says() {
    let (lines, cells) = (guide(&read("ch07_findings.md")), cells());
    let said = "errors below a thousandth, for 40 µs a second";
    let line = lines.iter().find(|line| line.because.contains(said));
    let line = line.expect("a line says so");
    for flags in &line.takes {
        for (scenario, _) in &line.scenarios {
            let cell = cell(&cells, scenario, &contender(flags), USUAL);
            assert!(cell.error < 1e-3 && cell.cost <= 40e-6, "{cell:?}");
        }
    }
}
