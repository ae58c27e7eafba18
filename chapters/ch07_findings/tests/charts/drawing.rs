//! A chart as a drawing and as numbers.

use ch07_findings::chart::{Axis, Chart, Series, Style};
use ch07_findings::draw::{csv, svg};
use ch07_findings::errata::ERRATA;
use ch07_findings::product::known;

use crate::assert_well_formed;

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
