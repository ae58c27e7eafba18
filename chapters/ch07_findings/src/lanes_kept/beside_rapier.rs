//! The lanes beside rapier3d: time of a step against how deep 99 of 100 contacts are, and the fastest of ours
//! of which no error is larger.

use std::fmt::Write as _;

use ch00_scenes::{Scene, Settings};
use ch06_compute::rules::Rules;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, millimetres, three_digits};

/// The kept table of programs for any x86-64 processor, both of four lanes.
const FOUR: Source = Source {
    file: "ch06_peer.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --features rapier --example peer -- \
              --scene NAME:N,NAME:N,… --csv FILE",
};
/// The kept table of programs for processors with AVX2, both of eight lanes.
const EIGHT: Source = Source {
    file: "ch06_peer_eight_lanes.csv",
    command: "RUSTFLAGS=\"-C target-cpu=x86-64-v3\" cargo run --release -p ch06_compute --no-default-features \
              --features rapier,rapier3d/simd8 --example peer -- --scene NAME:N,NAME:N,… --csv FILE",
};
/// Engines and methods, as the table says them and as charts do.
const WHO: [(&str, &str, &str, Style); 3] = [
    ("lanes", "own-row", "own rows", Style::Other(0)),
    ("lanes", "coloured", "colours", Style::Other(1)),
    ("rapier", "cones", "Rapier", Style::Marks(13)),
];
/// The scenes that are drawn: name and count, of the file, and what they are.
const DRAWN: [(&str, u32, &str, &str); 3] = [
    (
        "balls",
        1_000,
        "lanes_beside_rapier",
        "1,000 balls, settled",
    ),
    (
        "balls",
        10_000,
        "lanes_beside_rapier_crash",
        "10,000 balls, crashing",
    ),
    (
        "ragdolls",
        80,
        "lanes_beside_rapier_ragdolls",
        "80 ragdolls",
    ),
];

/// A line of the table.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    scene: String,
    count: u32,
    /// Place in [`WHO`].
    who: usize,
    threads: u32,
    substeps: u32,
    /// A step, ms.
    ms: f64,
    /// 99th percentiles: depth, m; gap of a joint, m; beyond a limit, rad.
    errors: [Option<f64>; 3],
    /// How deep the deepest contact is, m.
    deepest: f64,
    /// Bodies outside, and of numbers that are not finite.
    gone: u64,
}

/// Lays out pictures, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where a table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    let eight = EIGHT.read()?;
    say(&format!("from {}", EIGHT.file));
    FOUR.drawn(say, |four| drawn(four, &eight))
}

fn drawn(four: &Kept, eight: &Kept) -> Result<Product, FindingsError> {
    let origins = [four.origin(), eight.origin()];
    let [four, eight] = [four.samples(Sample::of)?, eight.samples(Sample::of)?];
    Ok(Product {
        charts: DRAWN.map(|known| chart(&four, known).into()).into(),
        csv: csv(&[(4, &four), (8, &eight)]),
        page: Some(page(&four, &eight, &origins)),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        let [engine, method] = ["engine", "method"].map(|column| line.text(column));
        let (engine, method) = (engine?, method?);
        line.one_of("engine", &WHO.map(|who| who.0))?;
        line.one_of("method", &WHO.map(|who| who.1))?;
        let who = WHO
            .iter()
            .position(|who| (who.0, who.1) == (engine, method));
        let some = |column| match line.text(column)? {
            "" => Ok(None),
            _ => line.number(column).map(Some),
        };
        Ok(Self {
            scene: line.text("scene")?.to_owned(),
            count: line.number("count")?,
            who: who.unwrap_or(0),
            threads: line.number("threads")?,
            substeps: line.number("substeps")?,
            ms: line.positive("ms_median")?,
            errors: [
                some("depth_p99_m")?,
                some("gap_p99_m")?,
                some("excess_p99_rad")?,
            ],
            deepest: line.number("depth_max_m")?,
            gone: line.number::<u64>("outside")? + line.number::<u64>("not_finite")?,
        })
    }

    fn is_rapier(&self) -> bool {
        WHO[self.who].0 == "rapier"
    }

    /// Whether none of its errors is larger than the other's.
    fn errs_no_more_than(&self, other: &Self) -> bool {
        let pairs = self.errors.iter().zip(&other.errors);
        self.gone <= other.gone && pairs.into_iter().all(|(own, other)| own <= other)
    }

    fn told(&self) -> String {
        let parts = if self.substeps == 1 {
            "substep"
        } else {
            "substeps"
        };
        format!("{} in {} {parts}", WHO[self.who].2, self.substeps)
    }
}

fn fastest<'s>(samples: impl Iterator<Item = &'s Sample>) -> Option<&'s Sample> {
    samples.min_by(|a, b| a.ms.total_cmp(&b.ms))
}

/// Rapier's fastest of a scene, and the fastest of ours that errs no more.
fn verdict<'s>(samples: &'s [Sample], scene: (&str, u32)) -> Option<(&'s Sample, &'s Sample)> {
    let of_scene = || {
        samples
            .iter()
            .filter(move |s| (s.scene.as_str(), s.count) == scene)
    };
    let rapier = fastest(of_scene().filter(|s| s.is_rapier()))?;
    let as_good = |s: &&Sample| !s.is_rapier() && s.errs_no_more_than(rapier);
    Some((rapier, fastest(of_scene().filter(as_good))?))
}

/// The scenes of the table, in its order.
fn scenes(samples: &[Sample]) -> Vec<(&str, u32)> {
    let mut scenes: Vec<_> = samples
        .iter()
        .map(|s| (s.scene.as_str(), s.count))
        .collect();
    scenes.dedup();
    scenes
}

/// The better number of threads each, a mark a number of substeps.
fn chart(samples: &[Sample], known: (&str, u32, &'static str, &str)) -> Chart {
    let (scene, count, name, title) = known;
    let of = |who: usize| {
        let of_who: Vec<_> = samples
            .iter()
            .filter(|s| s.scene == scene && s.count == count && s.who == who)
            .collect();
        let mut parts: Vec<u32> = of_who.iter().map(|s| s.substeps).collect();
        parts.sort_unstable();
        parts.dedup();
        parts
            .into_iter()
            .filter_map(|parts| fastest(of_who.iter().copied().filter(|s| s.substeps == parts)))
            .filter_map(|s| s.errors[0].map(|depth| (s.ms, 1e3 * depth)))
            .collect::<Vec<_>>()
    };
    let curve =
        |(who, known): (usize, &(&str, &str, &str, Style))| Series::new(known.2, known.3, of(who));
    Chart {
        name,
        title: format!("{title}: depth against time, a mark for each number of substeps"),
        x: Axis::log("time of a step (ms)"),
        y: Axis::log("99th percentile of depth (mm)"),
        series: WHO.iter().enumerate().map(curve).collect(),
    }
}

/// All lines, of each number of lanes.
fn csv(by_lanes: &[(u32, &[Sample])]) -> String {
    let mut text = "lanes,scene,count,who,threads,substeps,step (ms),depth (m),gap (m),beyond limits (rad),gone\n"
        .to_owned();
    let lines = by_lanes
        .iter()
        .flat_map(|(lanes, samples)| samples.iter().map(move |sample| (lanes, sample)));
    for (lanes, s) in lines {
        let [depth, gap, excess] = s
            .errors
            .map(|error| error.map(|error| error.to_string()).unwrap_or_default());
        let _ = writeln!(
            text,
            "{lanes},{},{},{},{},{},{},{depth},{gap},{excess},{}",
            s.scene, s.count, WHO[s.who].2, s.threads, s.substeps, s.ms, s.gone
        );
    }
    text
}

fn page(four: &[Sample], eight: &[Sample], origins: &[String; 2]) -> String {
    let [of_four, of_eight] = origins;
    format!(
        "Both with four lanes:\n\n{}\nBoth with eight:\n\n{}\nOf two numbers, Rapier's comes first: the 99th percentile \
         of contacts or joints, and the deepest contact of all. The better of one and two threads each. Four lanes: \
         {of_four}. Eight: {of_eight}.\n\n{}\nOurs in parts of Rapier's, with four lanes.\n",
        verdicts(four).markdown(1),
        verdicts(eight).markdown(1),
        usual(four).markdown(2)
    )
}

/// Each scene with its verdict.
fn verdicts(samples: &[Sample]) -> Table {
    let mut table = Table::new(&[
        "scene",
        "Rapier (ms)",
        "ours (ms)",
        "by",
        "times as fast",
        "depths (mm)",
        "deepest (mm)",
        "gaps (mm)",
        "beyond limits (rad)",
    ]);
    for (scene, count) in scenes(samples) {
        let Some((rapier, ours)) = verdict(samples, (scene, count)) else {
            continue;
        };
        let both = |k: usize, told: fn(f64) -> String| match (rapier.errors[k], ours.errors[k]) {
            (Some(theirs), Some(own)) => format!("{}, {}", told(theirs), told(own)),
            _ => String::new(),
        };
        table.push(vec![
            format!("{scene} {}", draw::grouped(&count.to_string())),
            three_digits(rapier.ms),
            three_digits(ours.ms),
            ours.told(),
            format!("{:.2}", rapier.ms / ours.ms),
            both(0, millimetres),
            format!(
                "{}, {}",
                millimetres(rapier.deepest),
                millimetres(ours.deepest)
            ),
            both(1, millimetres),
            both(2, three_digits),
        ]);
    }
    table
}

/// Each scene with the substeps that the plan takes unless told otherwise, where they were measured.
fn usual(samples: &[Sample]) -> Table {
    let mut table = Table::new(&["scene", "usual", "time", "depth", "deepest"]);
    for (scene, count) in scenes(samples) {
        let of_scene = || {
            samples
                .iter()
                .filter(move |s| (s.scene.as_str(), s.count) == (scene, count))
        };
        let Some(rapier) = fastest(of_scene().filter(|s| s.is_rapier())) else {
            continue;
        };
        for (who, known) in WHO.iter().enumerate() {
            let substeps = usual_substeps(scene, known.1);
            let usual = of_scene().filter(|s| s.who == who && Some(s.substeps) == substeps);
            if let Some(ours) = fastest(usual) {
                let depths = ours.errors[0].zip(rapier.errors[0]);
                let depth = depths.map(|(own, their)| own / their);
                table.push(vec![
                    format!("{scene} {}", draw::grouped(&count.to_string())),
                    ours.told(),
                    three_digits(ours.ms / rapier.ms),
                    depth.map(three_digits).unwrap_or_default(),
                    three_digits(ours.deepest / rapier.deepest),
                ]);
            }
        }
    }
    table
}

/// What the plan takes for a scene.
fn usual_substeps(scene: &str, method: &str) -> Option<u32> {
    let scene = Scene::open(scene, Some(1), None).ok()?;
    let settings = Settings::defaults().with_method(method);
    let rules = Rules::of(&scene, &settings).ok()?;
    Some(rules.substeps)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(source: Source) -> Vec<Sample> {
        let kept = source.read().expect("it is in the book");
        let samples = kept.samples(Sample::of);
        samples.expect("it can be read")
    }

    #[test]
    fn in_the_book_ours_is_at_least_half_as_fast_again_with_four_lanes_and_with_eight() {
        for source in [FOUR, EIGHT] {
            let samples = samples(source);
            let scenes = scenes(&samples);
            assert_eq!(scenes.len(), 6, "{scenes:?}");
            for scene in scenes {
                let (rapier, ours) = verdict(&samples, scene).expect("somebody errs as little");
                assert!(rapier.ms >= 1.5 * ours.ms, "{scene:?}: {rapier:?} {ours:?}");
            }
        }
    }

    #[test]
    fn ours_errs_the_same_in_any_number_of_lanes() {
        let [four, eight] = [samples(FOUR), samples(EIGHT)].map(|all| {
            let ours = all.into_iter().filter(|s| !s.is_rapier());
            ours.map(|s| (s.errors, s.deepest, s.gone))
                .collect::<Vec<_>>()
        });
        assert_eq!(four, eight);
    }

    #[test]
    fn what_errs_more_in_anything_is_not_chosen() {
        let mut samples = samples(FOUR);
        let scene = ("ragdolls", 80);
        let best = verdict(&samples, scene).expect("there is one").1.clone();
        for s in &mut samples {
            if *s == best {
                s.errors[2] = Some(10.0);
            }
        }
        let next = verdict(&samples, scene).expect("another").1;
        let line = |s: &Sample| (s.who, s.threads, s.substeps);
        assert_ne!(line(next), line(&best));
        samples.retain(Sample::is_rapier);
        assert_eq!(verdict(&samples, scene), None);
    }

    #[test]
    fn an_unknown_method_is_refused_by_line() {
        let text = "scene,count,engine,method,threads,substeps,ms_median,depth_p99_m,depth_max_m,gap_p99_m,excess_p99_rad,outside,not_finite\n\
                    balls,60,lanes,magic,1,1,0.1,1e-3,1e-3,,,0,0\n";
        let kept = FOUR.parse("here.csv".into(), text).expect("a table");
        let error = kept.lines().map(Sample::of).next().expect("a line");
        let message = error.expect_err("magic").to_string();
        assert!(
            message.contains("line 2") && message.contains("magic"),
            "{message}"
        );
    }
}
