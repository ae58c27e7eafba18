//! The charts as files: the command writes what it says, the picture shows all that was
//! measured, and the CSV gives the same numbers back.

use std::path::Path;
use std::process::{Command, Output};

use ch07_findings::bounce::{CASES, measured};
use ch07_findings::chart::{Axis, Chart, Series, Style};
use ch07_findings::draw::{csv, svg};
use ch07_findings::errata::ERRATA;
use ch07_findings::product::known;
use ch07_findings::{architecture_method_hardware, friction, limbs, stack, tunnelling};

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

/// What can happen to a measurement.
fn mixed(y: Axis) -> Chart {
    let points = [
        (0.001, 1e-6),
        (0.01, 0.0),
        (0.02, -1.0),
        (0.05, 3.5e-3),
        (0.1, f64::NAN),
        (0.2, f64::INFINITY),
        (0.5, f64::NEG_INFINITY),
        (1.0, 2.0),
    ];
    Chart {
        name: "mixed",
        title: "Everything <that> can happen & \"more\"".to_owned(),
        x: Axis::log("time step (s)"),
        y,
        series: vec![
            Series::new("printed, of \"all\"", Style::Printed, points),
            Series::of("corrected", Style::Corrected, &[0.001, 1.0], |x| x),
            Series::of("law", Style::Theory, &[0.001, 1.0], |x| 0.5 * x),
        ],
    }
}

/// The elements of this name in a drawing.
fn elements<'a>(svg: &'a str, name: &str) -> Vec<&'a str> {
    let start = format!("<{name} ");
    svg.lines()
        .filter(|line| line.starts_with(&start))
        .collect()
}

/// Every element is closed, in order, and nothing stands raw that XML wants escaped.
fn assert_well_formed(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = svg;
    while let Some((text, after)) = rest.split_once('<') {
        assert!(!text.contains('>'), "a raw > in {text:?}");
        let (tag, after) = after.split_once('>').expect("every < has its >");
        assert_eq!(tag.matches('"').count() % 2, 0, "quotes in {tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "closing order");
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or(tag));
        }
        rest = after;
    }
    assert!(open.is_empty(), "not closed: {open:?}");
    let entities = ["&amp;", "&lt;", "&gt;", "&quot;", "&apos;"];
    let known: usize = entities
        .iter()
        .map(|entity| svg.matches(entity).count())
        .sum();
    assert_eq!(svg.matches('&').count(), known, "a raw &");
}

/// The records of a CSV file.
fn records(text: &str) -> Vec<Vec<String>> {
    let (mut rows, mut fields, mut field) = (Vec::new(), Vec::new(), String::new());
    let (mut is_quoted, mut chars) = (false, text.chars().peekable());
    while let Some(c) = chars.next() {
        match c {
            '"' if is_quoted && chars.peek() == Some(&'"') => field.extend(chars.next()),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => fields.push(std::mem::take(&mut field)),
            '\n' if !is_quoted => {
                fields.push(std::mem::take(&mut field));
                rows.push(std::mem::take(&mut fields));
            }
            c => field.push(c),
        }
    }
    rows
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
            "{} is out of date: `cargo chart round_trip balls_on_the_gpu lanes_roofline`",
            in_book.display()
        );
    }
}

#[test]
fn what_the_three_bring_is_measured_on_this_machines_device() {
    let sample = architecture_method_hardware::measured(100, 1, 100).expect("all engines can");
    let [objects, properties, lanes, compute] = &sample.runs[..] else {
        panic!("four engines: {sample:?}");
    };
    assert_eq!(
        (objects.p99, objects.deepest),
        (properties.p99, properties.deepest)
    );
    assert_eq!(lanes.device, objects.device);
    assert_ne!(compute.device, lanes.device);
    assert!(sample.runs.iter().all(|run| run.escaped == 0), "{sample:?}");
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
fn errata_are_called_what_their_charts_are_called() {
    let names: Vec<String> = known().into_iter().map(|chart| chart.name).collect();
    for erratum in ERRATA {
        let name = (erratum.chart)().name.to_owned();
        assert!(names.contains(&name), "{name}");
    }
}

#[test]
fn every_chart_of_an_erratum_is_drawn_well() {
    for erratum in ERRATA {
        let chart = (erratum.chart)();
        let drawn = svg(&chart).expect("it can be drawn");
        assert_well_formed(&drawn);
        assert!(elements(&drawn, "polyline").len() >= chart.series.len());
    }
}

#[test]
fn a_chart_says_what_its_axes_and_curves_are() {
    let chart = mixed(Axis::log("error (m)"));
    let drawn = svg(&chart).expect("it can be drawn");
    assert_well_formed(&drawn);
    for text in [
        "\ntime step (s)\n",
        "\nerror (m)\n",
        "\nprinted, of &quot;all&quot;\n",
        "\nlaw\n",
        "Everything &lt;that&gt;",
    ] {
        assert!(drawn.contains(text), "{text:?} isn't in:\n{drawn}");
    }
}

#[test]
fn zeros_negatives_and_losses_stand_on_labelled_bands() {
    let drawn = svg(&mixed(Axis::log("error (m)"))).expect("it can be drawn");
    assert!(drawn.contains("\n≤ 0\n") && drawn.contains("\nlost\n"));
    // Eight points and the legend's sample; two for the corrected curve and its sample.
    assert_eq!(elements(&drawn, "circle").len(), 9);
    let heights = |from: usize| -> Vec<f64> {
        let circles = elements(&drawn, "circle");
        let at = circles.iter().skip(1).skip(from);
        at.map(|circle| attribute(circle, "cy")).collect()
    };
    let all = heights(0);
    // y grows downwards: the zeros are under all numbers, the losses above.
    let (zeros, lost) = ([all[1], all[2]], [all[4], all[5], all[6]]);
    for number in [all[0], all[3], all[7]] {
        assert!(zeros.iter().all(|zero| *zero > number), "{all:?}");
        assert!(lost.iter().all(|lost| *lost < number), "{all:?}");
    }
}

/// A number among an element's attributes.
fn attribute(element: &str, name: &str) -> f64 {
    let (_, rest) = element
        .split_once(&format!(" {name}=\""))
        .expect("it has one");
    let (value, _) = rest.split_once('"').expect("quotes come in pairs");
    value.parse().expect("a number")
}

#[test]
fn marks_alone_have_no_line_and_error_bars_have_three() {
    let mut chart = mixed(Axis::linear("share"));
    let lines = |chart: &Chart| {
        let drawn = svg(chart).expect("it can be drawn");
        assert_well_formed(&drawn);
        elements(&drawn, "polyline").len() + elements(&drawn, "line").len()
    };
    let points = [(0.01, 0.2), (0.1, 0.5)];
    let bars = vec![(0.1, 0.3), (0.4, 0.6)];
    chart.series = vec![Series::new("share", Style::Marks(0), points)];
    let without = lines(&chart);
    chart.series = vec![Series::new("share", Style::Other(0), points)];
    // The curve itself, and its sample in the legend.
    assert_eq!(lines(&chart), without + 2);
    chart.series = vec![Series::new("share", Style::Marks(0), points).with_bars(bars)];
    let with_bars = svg(&chart).expect("it can be drawn");
    // The axis reaches to the ends of the bars, so its other lines may be more or fewer.
    let thick = |line: &&&str| line.contains("stroke-width=\"13\"");
    assert_eq!(
        elements(&with_bars, "polyline")
            .iter()
            .filter(thick)
            .count(),
        6
    );
}

#[test]
fn what_is_lost_has_the_name_that_the_axis_gives_it() {
    let drawn = svg(&mixed(Axis::log("sunk (mm)").lost("fell"))).expect("it can be drawn");
    assert!(drawn.contains("\nfell\n") && !drawn.contains("\nlost\n"));
}

#[test]
fn on_an_even_axis_zeros_and_negatives_are_numbers() {
    let drawn = svg(&mixed(Axis::linear("error (m)"))).expect("it can be drawn");
    assert!(!drawn.contains("\n≤ 0\n") && drawn.contains("\nlost\n"));
}

#[test]
fn a_chart_of_losses_alone_and_one_without_curves_are_drawn() {
    let mut chart = mixed(Axis::log("error (m)"));
    for series in &mut chart.series {
        for point in &mut series.points {
            point.1 = f64::NAN;
        }
    }
    assert_well_formed(&svg(&chart).expect("it can be drawn"));
    chart.series.clear();
    assert_well_formed(&svg(&chart).expect("it can be drawn"));
}

#[test]
fn the_same_chart_gives_the_same_bytes() {
    let chart = mixed(Axis::log("error (m)"));
    let drawn = || svg(&chart).expect("it can be drawn");
    assert_eq!(drawn(), drawn());
}

#[test]
fn a_chart_needs_nothing_from_elsewhere() {
    let drawn = svg(&mixed(Axis::log("error (m)"))).expect("it can be drawn");
    for word in ["href", "url(", "<script", "<style", "<image"] {
        assert!(!drawn.contains(word), "{word}");
    }
    assert_eq!(drawn.matches("http").count(), 1, "the namespace alone");
}

#[test]
fn numbers_come_back_from_csv_with_all_their_bits() {
    let chart = mixed(Axis::log("error, relative"));
    let rows = records(&csv(&chart));
    assert_eq!(rows[0], ["series", "time step (s)", "error, relative"]);
    let mut rows = rows.iter().skip(1);
    for series in &chart.series {
        for &(x, y) in &series.points {
            let row = rows.next().expect("a line a point");
            assert_eq!(row[0], series.name);
            let number = |k: usize| row[k].parse::<f64>().expect("a number").to_bits();
            assert_eq!((number(1), number(2)), (x.to_bits(), y.to_bits()));
        }
    }
    assert!(rows.next().is_none());
}

#[test]
fn a_corrected_ball_keeps_its_apexes_within_a_hundredth_at_240_hz() {
    for case in CASES {
        let sample = measured(case, "corrected", 240, &[4.95, 5.0, 5.05]).expect("it loads");
        for run in sample.runs {
            assert!(run.apex < 0.01, "{}: {run:?}", case.scene);
            // The engine learns of the hit at the end of the step in which it happens.
            assert!((-1e-4..1.01 / 240.0).contains(&run.first_hit), "{run:?}");
        }
    }
}

#[test]
fn friction_is_exact_within_a_hundredth_at_60_hz() {
    let rate = 60.0;
    let mut checks = friction::slip_to_roll(rate).expect("it loads").to_vec();
    checks.extend(friction::slopes(rate).expect("it loads"));
    checks.extend(friction::oblique(rate).expect("it loads"));
    for check in checks {
        assert!(check.error < 0.01, "{check:?}");
    }
    for stop in friction::slides(rate).expect("it loads") {
        assert!((stop.distance - 1.0).abs() < 0.01, "{stop:?}");
        assert!(
            stop.sideways.abs() < 0.01 && stop.yaw.abs() < 0.01,
            "{stop:?}"
        );
    }
}

#[test]
fn five_cubes_stand_for_ten_seconds_and_twelve_with_two_sweeps_do_not() {
    let sweeps = ch03_collision::DEFAULT_SWEEPS;
    let five = stack::built("corrected", sweeps, 5, 10.0).expect("it loads");
    assert!(five.stands(), "{five:?}");
    let twelve = stack::built("corrected", 2, 12, 10.0).expect("it loads");
    assert!(!twelve.stands(), "{twelve:?}");
}

#[test]
fn slow_balls_never_get_through_the_wall_and_fast_ones_as_often_as_theory_says() {
    for method in ["printed", "corrected"] {
        for speed in [2.0, 9.0] {
            let slow = tunnelling::shot(method, 60.0, speed, 100).expect("it loads");
            assert_eq!(slow.through, 0, "{slow:?}");
        }
    }
    let fast = tunnelling::shot("printed", 60.0, 60.0, 400).expect("it loads");
    let (low, high) = fast.bar();
    let theory = tunnelling::unseen(60.0, 60.0);
    assert!((low..=high).contains(&theory), "{fast:?}");
}

#[test]
fn at_60_hz_no_limb_gets_through_the_floor() {
    let sample = limbs::dropped("corrected", 60.0, 1).expect("it loads");
    assert_eq!((sample.outside, sample.nowhere), (0, 0), "{sample:?}");
}
