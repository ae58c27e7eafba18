//! What architecture, method and hardware each bring, up to a million balls, and how good the heaps are:
//! drawn from a table that is kept in the book, as few readers have its machine.

mod sample;
mod text;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Source};
use crate::product::{Product, Say};
use sample::{Sample, machines, of, settling};
use text::{csv, page};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_pile_nvidia_h200.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example pile -- \
              --engine NAME --counts N,N,… --csv FILE",
};
/// Its scene.
const SCENE: &str = "pile";

/// An engine's name, what curves of it are called, and how these look: its time and the 99th percentile,
/// and the deepest overlap.
struct Kind {
    engine: &'static str,
    name: &'static str,
    style: Style,
    deepest: Style,
}

/// The engines in the order in which the book builds them.
const KINDS: [Kind; 5] = [
    Kind {
        engine: "objects",
        name: "corrected on objects",
        style: Style::Printed,
        deepest: Style::Printed,
    },
    Kind {
        engine: "properties",
        name: "corrected on properties",
        style: Style::Other(2),
        deepest: Style::Printed,
    },
    Kind {
        engine: "lanes",
        name: "own-row on one thread",
        style: Style::Other(0),
        deepest: Style::Other(4),
    },
    Kind {
        engine: ON_THREADS,
        name: "own-row on threads",
        style: Style::Other(1),
        deepest: Style::Other(4),
    },
    Kind {
        engine: "compute",
        name: "own-row on the GPU",
        style: Style::Corrected,
        deepest: Style::Other(3),
    },
];
/// Engine `lanes` on more than one thread.
const ON_THREADS: &str = "lanes on threads";
/// The last of [`KINDS`].
const COMPUTE: &str = "compute";

/// The budget of the GPU: so many balls in so many ms.
const BUDGET: [(f64, f64); 5] = [
    (1e3, 0.15),
    (1e4, 0.20),
    (1e5, 0.35),
    (4e5, 1.0),
    (1e6, 2.5),
];
/// And so deep an overlap at the 99th percentile, and at most, in radii.
const BUDGET_DEPTHS: [f64; 2] = [0.01, 0.05];
/// From so many balls on the growth is told, and the budget is N to this power of it at most.
const GROWS_FROM: f64 = 1e4;
const BUDGET_GROWTH: f64 = 1.05;

/// Lays out pictures, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    SOURCE.drawn(say, drawn)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let mut samples = kept.samples(Sample::of)?;
    samples.sort_by(|a, b| a.place().total_cmp(&b.place()));
    Ok(Product {
        charts: vec![times(&samples).into(), depths(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples, &kept.origin())),
    })
}

/// x, where an engine's time grows as Nˣ from [`GROWS_FROM`] balls to those of a later sample.
fn growth(samples: &[Sample], sample: &Sample) -> Option<f64> {
    let first = of(samples, &sample.engine).find(|first| first.balls == GROWS_FROM)?;
    let is_later = sample.balls > first.balls;
    is_later.then(|| (sample.ms[0] / first.ms[0]).ln() / (sample.balls / first.balls).ln())
}

/// The same up to the engine's last sample, in words.
fn growth_in_words(samples: &[Sample]) -> Option<String> {
    let last = of(samples, COMPUTE).last()?;
    let [from, to] = [GROWS_FROM, last.balls].map(grouped);
    let exponent = growth(samples, last)?;
    Some(format!(
        "from {from} to {to} balls as N to the power of {exponent:.2}"
    ))
}

fn times(samples: &[Sample]) -> Chart {
    let curve = |kind: &Kind| {
        let points = of(samples, kind.engine).map(|s| (s.balls, s.ms[0]));
        let bars = of(samples, kind.engine).map(|s| (s.ms[1], s.ms[2]));
        Series::new(kind.name, kind.style, points).with_bars(bars.collect())
    };
    let present = KINDS
        .iter()
        .filter(|kind| of(samples, kind.engine).next().is_some());
    let mut series: Vec<Series> = present.map(curve).collect();
    series.push(Series::new("budget for an H200", Style::Theory, BUDGET));
    let growth = growth_in_words(samples);
    let growth = growth.map_or(String::new(), |words| {
        format!("; on the GPU it grows {words}")
    });
    Chart {
        name: "balls_on_the_gpu",
        title: format!(
            "A step of a pile of balls, settled for {} steps, on {}{growth}",
            settling(samples.iter()),
            machines(samples)
        ),
        x: Axis::log("balls"),
        y: Axis::log("time (ms a step)"),
        series,
    }
}

fn depths(samples: &[Sample]) -> Chart {
    let mut series = Vec::new();
    for kind in &KINDS {
        // Properties have the bits of objects, and more balls; and threads change no bit.
        let is_twice = kind.engine == "objects" && of(samples, "properties").next().is_some()
            || kind.engine == ON_THREADS;
        if is_twice || of(samples, kind.engine).next().is_none() {
            continue;
        }
        let settling = settling(of(samples, kind.engine));
        let curve = |what: &str, style, depth: fn(&Sample) -> f64| {
            let points = of(samples, kind.engine).map(|s| (s.balls, depth(s)));
            let name = format!("{}, {what} after {settling} steps", kind.name);
            Series::new(&name, style, points)
        };
        series.push(curve("99th percentile", kind.style, |s| s.p99));
        series.push(curve("deepest", kind.deepest, |s| s.deepest));
    }
    let mut counts: Vec<f64> = samples.iter().map(|sample| sample.balls).collect();
    counts.sort_by(f64::total_cmp);
    counts.dedup();
    let names = ["budget: 0.01 and 0.05", ""];
    let limits = names.iter().zip(BUDGET_DEPTHS);
    series.extend(limits.map(|(name, depth)| Series::of(name, Style::Theory, &counts, |_| depth)));
    Chart {
        name: "balls_on_the_gpu_depths",
        title: format!(
            "How deep balls of a pile overlap when it has settled so long; {}",
            machines(samples)
        ),
        x: Axis::log("balls"),
        y: Axis::log("overlap (radii of the smaller ball)"),
        series,
    }
}

/// The GPU's budget with so many balls, ms.
fn budget(sample: &Sample) -> Option<f64> {
    let found = BUDGET.iter().find(|(balls, _)| *balls == sample.balls);
    found
        .filter(|_| sample.engine == COMPUTE)
        .map(|(_, ms)| *ms)
}

/// A number of balls, 12,345.
fn grouped(balls: f64) -> String {
    draw::grouped(&format!("{balls:.0}"))
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::chart::Picture;

    const NAMES: &str = "scene,count,engine,method,device,threads,settle_steps,ms_median,ms_fastest,ms_slowest,escaped,\
                         not_finite,p99_of_r,max_of_r\n";

    fn drawn_from(lines: &str) -> Result<Product, FindingsError> {
        let text = NAMES.to_owned() + lines;
        drawn(&SOURCE.parse(PathBuf::from(SOURCE.file), &text)?)
    }

    fn curves(picture: &Picture) -> &Chart {
        let Picture::Curves(chart) = picture else {
            panic!("curves are drawn");
        };
        chart
    }

    #[test]
    fn a_hundred_times_the_balls_in_a_hundred_times_the_time_grow_by_one() {
        let made = drawn_from(
            "pile,1000000,compute,own-row,Card,1,300,20,19,21,0,0,0.004,0.03\n\
             pile,10000,compute,own-row,Card,1,300,0.2,0.1,0.3,0,0,0.004,0.02\n",
        );
        let made = made.expect("a table");
        let title = &curves(&made.charts[0]).title;
        assert!(
            title.contains("10,000 to 1,000,000 balls as N to the power of 1.00"),
            "{title}"
        );
        assert!(title.contains("Card"), "{title}");
        let last = made.csv.lines().last().expect("two lines");
        assert!(
            last.starts_with("compute,own-row,Card,1,1000000,300,20.0,19.0,21.0,2.5,1.0"),
            "{last}"
        );
    }

    #[test]
    fn every_engine_has_its_curves_and_equal_bits_are_drawn_once() {
        let made = drawn_from(
            "pile,100,objects,corrected,C P U,1,300,1,1,1,0,0,0.1,0.2\n\
             pile,100,properties,corrected,C P U,1,300,1,1,1,0,0,0.1,0.2\n\
             pile,100,lanes,own-row,C P U,1,300,1,1,1,0,0,0.1,0.2\n\
             pile,100,lanes,own-row,C P U,4,300,1,1,1,0,0,0.1,0.2\n\
             pile,100,compute,own-row,Card,1,300,1,1,1,1,2,0.1,0.2\n",
        );
        let made = made.expect("a table");
        assert_eq!(curves(&made.charts[0]).series.len(), KINDS.len() + 1);
        assert_eq!(curves(&made.charts[1]).series.len(), 3 * 2 + 2);
        let page = made.page.expect("there is one");
        assert!(
            page.contains("Card, and one thread or 4 of C P U"),
            "{page}"
        );
        assert!(
            page.lines()
                .last()
                .is_some_and(|line| line.ends_with(" 3 |")),
            "{page}"
        );
        assert!(!page.contains("grows"), "there are no 10,000 balls: {page}");
    }

    #[test]
    fn other_scenes_and_engines_are_refused() {
        for (line, word) in [
            ("balls,100,lanes,own-row,C,1,300,1,1,1,0,0,0,0", "`scene`"),
            ("pile,100,wheels,own-row,C,1,300,1,1,1,0,0,0,0", "`engine`"),
            ("pile,,lanes,own-row,C,1,300,1,1,1,0,0,0,0", "`count`"),
            ("pile,100,lanes,own-row,C,1,300,1,1,1,0,0,,0", "`p99_of_r`"),
        ] {
            let error = drawn_from(line).expect_err("it is no such line");
            let message = error.to_string();
            assert!(
                message.contains("line 2") && message.contains(word),
                "{message}"
            );
        }
    }
}
