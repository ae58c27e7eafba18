//! The quick laboratory: each scenario once, by the method that does it best, within its bound. A change that
//! costs accuracy fails here.

use ch07_findings::laboratory::runs::measure;
use ch07_findings::laboratory::{CONTENDERS, Contender, End, SCENARIOS, Scenario};

/// Who reaches the figure at 60 Hz; everything else by own rows.
const OTHERS: [(&str, &str); 7] = [
    ("rolling", "corrected"),
    ("pushed_box", "corrected"),
    ("oblique", "corrected"),
    ("cradle", "corrected"),
    ("elastic_gas", "corrected"),
    ("stack", "coloured in 32"),
    ("mass_ratio_1000", "coloured in 32"),
];

fn best(scenario: &str) -> &'static Contender {
    let other = OTHERS.iter().find(|known| known.0 == scenario);
    let name = other.map_or("own-row", |known| known.1);
    let found = CONTENDERS.iter().find(|contender| contender.name == name);
    found.expect("it is in the list")
}

#[test]
fn every_scenario_is_passed_by_a_method_of_the_book() {
    let mut missed = Vec::new();
    for scenario in SCENARIOS {
        let contender = best(scenario.name);
        assert!(contender.ours, "{}", contender.name);
        let cell = measure(scenario, contender, 60, true).expect("it can be built");
        if cell.end != End::Measured || cell.error > scenario.pass {
            missed.push(format!(
                "{} by {}: {} {}, {:?}",
                scenario.name, contender.name, cell.error, scenario.unit, cell.end
            ));
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}

#[test]
fn there_are_all_24_and_their_names_are_their_own() {
    let mut numbers: Vec<_> = SCENARIOS.iter().map(|scenario| scenario.number).collect();
    numbers.dedup();
    assert_eq!(numbers, (1..=24).collect::<Vec<_>>());
    let mut headings: Vec<_> = SCENARIOS.iter().map(Scenario::heading).collect();
    assert!(headings[9].starts_with("9b. ") && headings[10].starts_with("10. "));
    headings.sort_unstable();
    headings.dedup();
    assert_eq!(headings.len(), SCENARIOS.len());
    let mut names: Vec<_> = SCENARIOS.iter().map(|scenario| scenario.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), SCENARIOS.len());
}

#[test]
fn pages_that_scenarios_name_are_in_the_book() {
    let book = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src");
    for scenario in SCENARIOS {
        let page = book.join(format!("{}.md", scenario.page));
        assert!(page.is_file(), "{}: {}", scenario.name, page.display());
    }
}

#[test]
fn the_page_of_scenarios_says_of_each_what_the_code_says() {
    let book = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src");
    let page = std::fs::read_to_string(book.join("ch07_scenarios.md")).expect("the page");
    for scenario in SCENARIOS {
        let heading = format!("## {}\n\n{}\n", scenario.heading(), scenario.watch);
        assert!(page.contains(&heading), "{heading}");
        let chart = format!("charts/scenario_{}.svg", scenario.name);
        assert!(page.contains(&chart), "{chart}");
        assert!(book.join(&chart).is_file(), "{chart}");
    }
}

#[test]
fn a_scenario_fails_where_its_method_does() {
    for (scenario, contender, how) in [
        ("stack", "sequential-impulses", "fell"),
        ("heavy_top", "explicit-gyro", "NaN"),
    ] {
        let scenario = SCENARIOS.iter().find(|known| known.name == scenario);
        let contender = CONTENDERS.iter().find(|known| known.name == contender);
        let cell = measure(
            scenario.expect("known"),
            contender.expect("known"),
            60,
            true,
        );
        assert_eq!(cell.expect("built").end, End::Failed(how.to_owned()));
    }
}
