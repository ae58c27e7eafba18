//! The command: what it writes, and what it says when it can't.

use std::path::Path;
use std::process::{Command, Output};

use ch07_findings::product::known;

use crate::assert_well_formed;

/// Runs the program's `chart` command.
fn chart(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ch07_findings"))
        .arg("chart")
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn words(path: &Path) -> &str {
    path.to_str().expect("the path is plain text")
}

#[test]
fn the_command_writes_picture_and_numbers_and_says_so() {
    let folder = tempfile::tempdir().expect("there is room");
    let ran = chart(&["erratum_01", "--quick", "--out", words(folder.path())]);
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    for ending in ["svg", "csv"] {
        let file = folder.path().join(format!("erratum_01.{ending}"));
        assert!(file.is_file(), "{} is missing", file.display());
        assert!(said.contains(words(&file)), "{said}");
    }
    let files = std::fs::read_dir(folder.path())
        .expect("it is ours")
        .count();
    assert_eq!(files, 2, "nothing else is left behind");
}

#[test]
fn a_chart_of_several_pictures_writes_them_all_and_one_table() {
    let folder = tempfile::tempdir().expect("there is room");
    let ran = chart(&["friction", "--quick", "--out", words(folder.path())]);
    assert!(ran.status.success());
    let mut files: Vec<String> = std::fs::read_dir(folder.path())
        .expect("it is ours")
        .map(|file| file.expect("it is ours").file_name())
        .map(|name| name.into_string().expect("plain text"))
        .collect();
    files.sort();
    let wanted = [
        "friction.csv",
        "friction.svg",
        "friction.txt",
        "friction_directions.svg",
    ];
    assert_eq!(files, wanted);
    let page = std::fs::read_to_string(folder.path().join("friction.txt")).expect("it is there");
    assert_eq!(String::from_utf8_lossy(&ran.stdout), page);
    for name in ["friction", "friction_directions"] {
        let file = folder.path().join(format!("{name}.svg"));
        assert_well_formed(&std::fs::read_to_string(file).expect("it is there"));
    }
}

#[test]
fn charts_of_a_machine_that_few_have_name_it_and_measure_nothing() {
    let folder = tempfile::tempdir().expect("there is room");
    let names = ["round_trip", "balls_on_the_gpu"];
    let ran = chart(&[names[0], names[1], "--out", words(folder.path())]);
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
    for picture in [
        "round_trip",
        "round_trip_boxes",
        "round_trip_shares",
        "balls_on_the_gpu",
        "balls_on_the_gpu_depths",
    ] {
        let file = folder.path().join(format!("{picture}.svg"));
        let drawn = std::fs::read_to_string(file).expect("it is there");
        assert_well_formed(&drawn);
        assert!(drawn.contains("NVIDIA H200"), "{picture}");
    }
    for name in names {
        let page = folder.path().join(format!("{name}.txt"));
        let page = std::fs::read_to_string(page).expect("it is there");
        assert!(
            page.contains("NVIDIA H200") && page.contains("--csv FILE"),
            "{page}"
        );
    }
}

#[test]
fn the_files_of_the_book_are_what_their_kept_tables_say() {
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/charts");
    let folder = tempfile::tempdir().expect("there is room");
    let ran = chart(&[
        "round_trip",
        "balls_on_the_gpu",
        "lanes_roofline",
        "lanes_growth",
        "--out",
        words(folder.path()),
    ]);
    assert!(ran.status.success());
    for file in std::fs::read_dir(folder.path()).expect("it is ours") {
        let file = file.expect("it is ours");
        let in_book = book.join(file.file_name());
        let text = |path: &Path| std::fs::read_to_string(path).unwrap_or_default();
        assert!(
            text(&file.path()) == text(&in_book),
            "{} is out of date: `cargo chart round_trip balls_on_the_gpu lanes_roofline lanes_growth`",
            in_book.display()
        );
    }
}

#[test]
fn the_command_makes_the_folder() {
    let folder = tempfile::tempdir().expect("there is room");
    let deeper = folder.path().join("a/b");
    let ran = chart(&["erratum_02", "--out", words(&deeper)]);
    assert!(ran.status.success());
    assert!(deeper.join("erratum_02.csv").is_file());
}

#[test]
fn an_unknown_chart_is_an_error_of_one_paragraph() {
    let ran = chart(&["tabel1"]);
    assert_eq!(ran.status.code(), Some(1));
    let said = String::from_utf8_lossy(&ran.stderr);
    assert_eq!(said.lines().count(), 1, "{said}");
    for word in ["`tabel1`", "table1", "bounce", "erratum_07"] {
        assert!(said.contains(word), "{said}");
    }
}

#[test]
fn a_scenario_that_was_cut_short_goes_on_where_it_stopped() {
    let folder = tempfile::tempdir().expect("there is room");
    let args = [
        "scenario_spin_kept",
        "--quick",
        "--out",
        words(folder.path()),
    ];
    let run = || {
        let ran = chart(&args);
        assert!(
            ran.status.success(),
            "{}",
            String::from_utf8_lossy(&ran.stderr)
        );
        String::from_utf8_lossy(&ran.stderr).into_owned()
    };
    let all = run();
    let path = folder.path().join("laboratory_quick.csv");
    let table = std::fs::read_to_string(&path).expect("it was written");
    let cells = table.lines().count() - 1;
    assert!(
        all.contains(&format!("{cells} of {cells}, 0 s left")),
        "{all}"
    );
    // Cut off in the middle of the last line but one.
    let cut = table[..table.len() - 1].rfind('\n').expect("lines") - 5;
    std::fs::write(&path, &table[..cut]).expect("it is ours");
    let rest = run();
    assert!(
        rest.contains("2 of 2, 0 s left") && !rest.contains("3 of"),
        "{rest}"
    );
    let again = std::fs::read_to_string(&path).expect("it is there");
    assert_eq!(again.lines().count() - 1, cells);
    assert_eq!(
        again[..cut - 100],
        table[..cut - 100],
        "what was measured is kept"
    );
    assert!(!run().contains("left"), "nothing is measured twice");
}

#[test]
fn an_unknown_scenario_is_answered_with_the_known_ones() {
    let ran = chart(&["scenario_stak"]);
    assert_eq!(ran.status.code(), Some(1));
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(
        said.contains("`scenario_stak`") && said.contains("scenario_stack"),
        "{said}"
    );
}

#[test]
fn a_folder_that_can_not_be_written_stops_before_measuring() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("file");
    std::fs::write(&file, "in the way").expect("it is ours");
    let ran = chart(&["table1", "--out", words(&file.join("charts"))]);
    assert_eq!(ran.status.code(), Some(1));
    let said = String::from_utf8_lossy(&ran.stderr);
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(said.contains("can't be written"), "{said}");
}

#[test]
fn help_lists_the_charts() {
    let ran = chart(&["--help"]);
    let said = String::from_utf8_lossy(&ran.stdout);
    for chart in known() {
        assert!(said.contains(&chart.name), "{said}");
    }
}

#[test]
fn a_failure_map_is_drawn_told_and_kept() {
    let folder = tempfile::tempdir().expect("there is room");
    let args = ["failure_stall", "--quick", "--out", words(folder.path())];
    let ran = chart(&args);
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    let drawn = std::fs::read_to_string(folder.path().join("failure_stall.svg"));
    assert_well_formed(&drawn.expect("it is there"));
    let page = std::fs::read_to_string(folder.path().join("failure_stall.txt")).expect("there");
    assert!(page.contains("`printed`"), "{page}");
    // Cut off in mid-row: the rest is measured anew, and no more.
    let path = folder.path().join("failure_maps_quick.csv");
    let table = std::fs::read_to_string(&path).expect("it was written");
    std::fs::write(&path, &table[..table.len() - 5]).expect("it is ours");
    let again = String::from_utf8_lossy(&chart(&args).stderr).into_owned();
    assert!(again.contains("1 of 1, 0 s left"), "{again}");
    let whole = std::fs::read_to_string(&path).expect("it is there");
    assert_eq!(whole, table, "a run says the same every time");
}

#[test]
fn the_reports_tables_and_the_cost_of_a_body_are_told_of_every_engine() {
    let folder = tempfile::tempdir().expect("there is room");
    let names = ["report_on_engines", "microseconds_per_body"];
    let ran = chart(&[names[0], names[1], "--quick", "--out", words(folder.path())]);
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
    let read = |file: String| std::fs::read_to_string(folder.path().join(file)).expect("there");
    for picture in [names[0], "report_on_engines_ragdolls", names[1]] {
        assert_well_formed(&read(format!("{picture}.svg")));
        assert_well_formed(&read(format!("{picture}_others.svg")));
    }
    for name in names {
        let page = read(format!("{name}.txt"));
        for engine in [
            "corrected on objects",
            "corrected on properties",
            "own-row on lanes",
            "coloured on lanes",
            "own-row on compute",
            "xpbd",
        ] {
            assert!(page.contains(&format!("| {engine} ")), "{engine}: {page}");
        }
    }
    let page = read("report_on_engines.txt".to_owned());
    assert!(page.contains("| the report "), "{page}");
    let page = read("microseconds_per_body.txt".to_owned());
    assert!(page.contains("| own-row on NVIDIA H200 "), "{page}");
    let table = read("microseconds_per_body.csv".to_owned());
    assert!(table.contains(",NVIDIA H200,true,1000000,"), "{table}");
}
