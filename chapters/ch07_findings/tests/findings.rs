//! What the page Findings says in words and numbers is what the kept table of the laboratory holds.

use std::path::Path;

use ch07_findings::laboratory::{Cell, End};

/// What a number on the page is: of a scenario by a contender at so many steps a second.
struct Claim {
    /// A part of the page.
    said: &'static str,
    /// The number in it, with its decimals.
    number: &'static str,
    /// Where it comes from: scenario, contender, steps a second.
    cell: (&'static str, &'static str, u32),
    /// From a cell to the number.
    of: fn(&Cell) -> f64,
}

const fn claim(
    said: &'static str,
    number: &'static str,
    cell: (&'static str, &'static str, u32),
    of: fn(&Cell) -> f64,
) -> Claim {
    Claim {
        said,
        number,
        cell,
        of,
    }
}

fn error(cell: &Cell) -> f64 {
    cell.error
}

fn millimetres(cell: &Cell) -> f64 {
    1e3 * cell.error
}

fn microseconds(cell: &Cell) -> f64 {
    1e6 * cell.cost
}

const CLAIMS: &[Claim] = &[
    claim(
        "A constant spin is off by 2.10 rad",
        "2.10",
        ("free_top", "constant-spin", 60),
        error,
    ),
    claim(
        "A constant spin is off by 2.10 rad after ten seconds at any rate",
        "2.10",
        ("free_top", "constant-spin", 960),
        error,
    ),
    claim(
        "The splitting has 3·10⁻⁴ rad",
        "3",
        ("free_top", "splitting", 60),
        |cell| 1e4 * cell.error,
    ),
    claim(
        "at 60 Hz for 30 µs a second",
        "30",
        ("free_top", "splitting", 60),
        microseconds,
    ),
    claim(
        "the Runge–Kutta method 4·10⁻⁶ for 25",
        "4",
        ("free_top", "runge-kutta", 60),
        |cell| 1e6 * cell.error,
    ),
    claim(
        "the Runge–Kutta method 4·10⁻⁶ for 25",
        "25",
        ("free_top", "runge-kutta", 60),
        microseconds,
    ),
    claim(
        "takes 777 µs",
        "777",
        ("free_top", "rapier", 60),
        microseconds,
    ),
    claim(
        "is off by 0.145 rad",
        "0.145",
        ("free_top", "rapier", 60),
        error,
    ),
    claim(
        "opens by 0.25 mm with own rows in ten substeps",
        "0.25",
        ("ball_and_chain", "own-row", 60),
        millimetres,
    ),
    claim(
        "by 0.015 mm in 32",
        "0.015",
        ("ball_and_chain", "own-row in 32", 60),
        millimetres,
    ),
    claim(
        "XPBD's joints open by 143 mm",
        "143",
        ("ball_and_chain", "xpbd", 60),
        millimetres,
    ),
    claim(
        "with sixteen iterations by 87 mm",
        "87",
        ("ball_and_chain", "rapier tuned", 60),
        millimetres,
    ),
    claim(
        "holds ten rods to 5·10⁻⁷ of their period",
        "5",
        ("hanging_chain", "direct-joints", 60),
        |cell| 1e7 * cell.error,
    ),
    claim(
        "with colours in 32 substeps, at 19 ms a second",
        "19",
        ("stack", "coloured in 32", 60),
        |cell| 1e3 * cell.cost,
    ),
    claim(
        "Rapier's tower stands too, 6 cm from its place",
        "6",
        ("stack", "rapier", 60),
        |cell| 1e2 * cell.error,
    ),
    claim(
        "sink by 1 mm with colours in 32 substeps",
        "1",
        ("mass_ratio_1000", "coloured in 32", 60),
        millimetres,
    ),
    claim(
        "and by 3 mm with own rows",
        "3",
        ("mass_ratio_1000", "own-row in 32", 60),
        millimetres,
    ),
    claim(
        "by 26 and 72 mm",
        "26",
        ("mass_ratio_1000", "coloured", 60),
        millimetres,
    ),
    claim(
        "by 26 and 72 mm",
        "72",
        ("mass_ratio_1000", "own-row", 60),
        millimetres,
    ),
    claim(
        "where they sink by 0.33 m",
        "0.33",
        ("mass_ratio_1000", "rapier tuned", 60),
        error,
    ),
    claim(
        "lose the cradle to it (0.6 of 1 m/s)",
        "0.6",
        ("cradle", "own-row", 60),
        error,
    ),
    claim(
        "lose the cradle to it (0.6 of 1 m/s)",
        "0.6",
        ("cradle", "coloured", 60),
        error,
    ),
    claim(
        "a bounce without loss errs by 0.019 in place of 0.029",
        "0.019",
        ("bounce", "rapier with CCD", 60),
        error,
    ),
    claim(
        "a bounce without loss errs by 0.019 in place of 0.029",
        "0.029",
        ("bounce", "rapier", 60),
        error,
    ),
];

/// What fails, and how, where the page says that it does.
const FAILURES: &[(&str, &str, &str, u32, &str)] = &[
    (
        "with its usual four it tears",
        "ball_and_chain",
        "rapier",
        60,
        "torn",
    ),
    (
        "the heavy chain tears at 60 Hz",
        "ball_and_chain",
        "direct-joints",
        60,
        "torn",
    ),
    (
        "By `printed` and `corrected` it falls",
        "stack",
        "printed",
        60,
        "fell",
    ),
    (
        "By `printed` and `corrected` it falls",
        "stack",
        "corrected",
        60,
        "fell",
    ),
    (
        "and by the four solvers",
        "stack",
        "sequential-impulses",
        60,
        "fell",
    ),
    ("and by the four solvers", "stack", "soft-step", 60, "fell"),
    ("and by the four solvers", "stack", "xpbd", 60, "fell"),
    (
        "and by the four solvers",
        "stack",
        "direct-joints",
        60,
        "fell",
    ),
    (
        "By all other methods they fall over",
        "mass_ratio_1000",
        "corrected",
        60,
        "fell",
    ),
    (
        "By all other methods they fall over",
        "mass_ratio_1000",
        "sequential-impulses",
        60,
        "fell",
    ),
    (
        "By all other methods they fall over",
        "mass_ratio_1000",
        "soft-step",
        60,
        "fell",
    ),
    (
        "By all other methods they fall over",
        "mass_ratio_1000",
        "xpbd",
        60,
        "fell",
    ),
    (
        "By all other methods they fall over",
        "mass_ratio_1000",
        "direct-joints",
        60,
        "fell",
    ),
    (
        "By all other methods they fall over",
        "mass_ratio_1000",
        "rapier",
        60,
        "fell",
    ),
    (
        "Rapier's tear below 60 Hz",
        "ragdoll_pile",
        "rapier",
        30,
        "torn",
    ),
    (
        "Rapier's tear below 60 Hz",
        "ragdoll_pile",
        "rapier with CCD",
        30,
        "torn",
    ),
    (
        "ragdolls tear at 120 and 240 steps a second too",
        "ragdoll_hitches",
        "rapier with CCD",
        120,
        "torn",
    ),
    (
        "ragdolls tear at 120 and 240 steps a second too",
        "ragdoll_hitches",
        "rapier with CCD",
        240,
        "torn",
    ),
];

fn book() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

fn page() -> String {
    std::fs::read_to_string(book().join("ch07_findings.md")).expect("the page is there")
}

fn cells() -> Vec<Cell> {
    let file = book().join("charts/laboratory.csv");
    let text = std::fs::read_to_string(file).expect("the table is kept in the book");
    text.lines().filter_map(|line| line.parse().ok()).collect()
}

fn cell<'c>(cells: &'c [Cell], wanted: (&str, &str, u32)) -> &'c Cell {
    let found = cells.iter().find(|cell| cell.key() == wanted);
    found.unwrap_or_else(|| panic!("no cell {wanted:?}"))
}

/// Half a unit of the last digit.
fn rounding(number: &str) -> f64 {
    let decimals = number.split_once('.').map_or(0, |(_, behind)| behind.len());
    (0..decimals).fold(0.5, |half, _| half / 10.0)
}

#[test]
fn numbers_on_the_page_are_those_of_the_table_to_their_last_digit() {
    let (page, cells) = (page(), cells());
    let mut wrong = Vec::new();
    for Claim {
        said,
        number,
        cell: key,
        of,
    } in CLAIMS
    {
        assert!(said.contains(number), "{said}: no {number}");
        let cell = cell(&cells, *key);
        let (found, told) = (of(cell), number.parse::<f64>().expect("a number"));
        let is_told = (found - told).abs() <= rounding(number) * (1.0 + 1e-9);
        if !(page.contains(said) && is_told) {
            wrong.push(format!("{said}: {found} in the table of {key:?}"));
        }
        assert_eq!(cell.end, End::Measured, "{key:?}");
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn what_fails_on_the_page_fails_in_the_table() {
    let (page, cells) = (page(), cells());
    for &(said, scenario, contender, rate, how) in FAILURES {
        assert!(page.contains(said), "{said}");
        let cell = cell(&cells, (scenario, contender, rate));
        assert_eq!(cell.end, End::Failed(how.to_owned()), "{said}: {cell:?}");
    }
}

#[test]
fn ratios_on_the_page_are_those_of_the_table() {
    let (page, cells) = (page(), cells());
    let cost = |scenario, contender| cell(&cells, (scenario, contender, 60)).cost;
    let times = cost("hanging_chain", "direct-joints") / cost("hanging_chain", "own-row");
    assert!(page.contains("at 2.3 times the cost of own rows") && (times - 2.3).abs() <= 0.05);
    let share = cost("stack", "coloured in 32") / cost("stack", "rapier");
    assert!(page.contains("for an eleventh of that price") && (share - 11.0).abs() <= 0.5);
    let error = |scenario, contender| cell(&cells, (scenario, contender, 60)).error;
    assert!(
        page.contains("within 1 mm with colours in 32") && error("stack", "coloured in 32") <= 1e-3
    );
    for scenario in ["cradle", "oblique", "elastic_gas"] {
        let others = cells.iter().filter(|cell| {
            cell.scenario == scenario && cell.rate == 60 && cell.contender != "corrected"
        });
        let next = others
            .filter(|cell| cell.is_measured())
            .map(|cell| cell.error);
        let ahead = next.fold(f64::INFINITY, f64::min) / error(scenario, "corrected");
        assert!(
            page.contains("by three digits and more") && ahead >= 1e3,
            "{scenario}: {ahead}"
        );
    }
}

#[test]
fn continuous_detection_changes_as_many_scenarios_as_the_page_says() {
    let (page, cells) = (page(), cells());
    let of = |name: &str| -> Vec<Cell> {
        let same = cells.iter().filter(|cell| cell.contender == name);
        same.cloned().collect()
    };
    let (without, with) = (of("rapier"), of("rapier with CCD"));
    assert_eq!(without.len(), with.len(), "every cell is measured");
    let found = |one: &Cell| {
        let key = (one.scenario.as_str(), "rapier with CCD", one.rate);
        cell(&with, key)
    };
    let differs = |one: &&Cell| {
        let other = found(one);
        one.end != other.end || one.error.to_bits() != other.error.to_bits()
    };
    let mut all: Vec<_> = without.iter().map(|cell| &cell.scenario).collect();
    let mut changed: Vec<_> = without.iter().filter(differs).collect();
    all.dedup();
    changed.dedup_by_key(|cell| &cell.scenario);
    assert!(page.contains("In twenty of 28 scenarios it takes the same steps as without"));
    assert_eq!((all.len(), changed.len()), (28, 28 - 20), "{changed:#?}");
    assert!(page.contains("loses no ball of scenario 23 at any rate"));
    let wall = with.iter().filter(|cell| cell.scenario == "tunnelling");
    assert!(wall.into_iter().all(|cell| cell.error == 0.0));
    assert!(page.contains("where without it they hold"));
    for rate in [120, 240] {
        let cell = cell(&without, ("ragdoll_hitches", "rapier", rate));
        assert_eq!(cell.end, End::Measured);
    }
}
