//! What each part that a plan leaves out would cost: the run with no more than the scene needs, beside
//! the same with one part more, and with all. All have the same bits; they take turns, and each
//! comparison is made several times, with engines loaded anew. The planned run a second time, as if it
//! were another one, says how much of a difference is chance.

mod contest;
mod lanes;

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Bar, Bars, Group};
use crate::columns::built;
use crate::draw;
use crate::lab::{self, Spread, TURN};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

pub use contest::{Case, measured};
pub use lanes::product as lanes_product;

/// The scenes.
pub const CASES: [Case; 6] = [
    Case::new("smooth_balls", Some(1000), 300),
    Case::new("balls", Some(1000), 200),
    Case::new("tops", None, 600),
    Case::new("stack", None, 600),
    Case::new("chain", None, 200),
    Case::new("ragdolls", Some(20), 150),
];
/// Comparisons of each.
const REPEATS: usize = 5;

/// What a run has beside the planned one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum More {
    /// Nothing: the same once more.
    Nothing,
    /// A part, by its name, and what it can't do without.
    Part(&'static str),
    /// All parts.
    All,
}

/// A run beside the planned one.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// What it has more.
    pub more: More,
    /// Bytes a body.
    pub bytes: usize,
    /// What a step takes longer, µs: median of the comparisons, the least and the largest. Each is the
    /// median over the steps.
    pub micros: Spread,
    /// The same over the planned run's step.
    pub share: Spread,
}

/// All runs of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Name of the scene and how many there are of what it counts.
    pub name: String,
    /// Bodies that move.
    pub bodies: usize,
    /// Bytes a body of the planned run.
    pub bytes: usize,
    /// A step of the planned run, ms.
    pub planned: Spread,
    /// The others: nothing more, the parts in order, all.
    pub samples: Vec<Sample>,
}

impl More {
    fn name(self) -> &'static str {
        match self {
            More::Nothing => "the same once more",
            More::Part(name) => name,
            More::All => "all parts",
        }
    }
}

impl Scene {
    fn chance(&self) -> &Sample {
        &self.samples[0]
    }

    fn all(&self) -> &Sample {
        &self.samples[self.samples.len() - 1]
    }

    fn parts(&self) -> &[Sample] {
        &self.samples[1..self.samples.len() - 1]
    }

    /// Whether a difference could be chance: it has values in common with that of the same run, or
    /// with none.
    fn may_be_chance(&self, sample: &Sample) -> bool {
        let none = Spread::default();
        sample.share.overlaps(self.chance().share) || sample.share.overlaps(none)
    }

    /// The parts that cost more than chance explains, the dearest first.
    fn dear(&self) -> Vec<&Sample> {
        let mut dear: Vec<&Sample> = self
            .parts()
            .iter()
            .filter(|sample| !self.may_be_chance(sample))
            .collect();
        dear.sort_by(|a, b| b.share.median.total_cmp(&a.share.median));
        dear
    }

    /// The other parts.
    fn cheap(&self) -> Vec<&Sample> {
        let parts = self.parts().iter();
        parts.filter(|sample| self.may_be_chance(sample)).collect()
    }
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be loaded or a part changes what comes out.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let repeats = if quick { 2 } else { REPEATS };
    let mut scenes = Vec::new();
    for case in CASES {
        let case = if quick { case.shortened(10) } else { case };
        let scene = measured(case, repeats)?;
        say(&format!(
            "{}: {} parts left out",
            scene.name,
            scene.parts().len()
        ));
        scenes.push(scene);
    }
    Ok(Product {
        charts: vec![chart(&scenes).into()],
        csv: csv(&scenes),
        page: Some(page(&scenes, repeats)),
    })
}

/// A share with its sign.
fn signed_percent(share: f64) -> String {
    let percent = format!("{:.1}", 100.0 * share.abs());
    let sign = match share {
        _ if percent == "0.0" => "",
        ..0.0 => "−",
        _ => "+",
    };
    format!("{sign}{percent} %")
}

fn chart(scenes: &[Scene]) -> Bars {
    Bars {
        name: "left_out",
        title: "What a part that a scene doesn't need would add to a step".to_owned(),
        label: "more time for a step than planned (%)".to_owned(),
        powers: false,
        parts: vec!["more time"],
        groups: scenes.iter().map(group).collect(),
    }
}

fn group(scene: &Scene) -> Group {
    let bar = |name: String, share: Spread, bytes: usize| Bar {
        name,
        lengths: vec![100.0 * share.median],
        spread: Some((100.0 * share.low, 100.0 * share.high)),
        note: match bytes - scene.bytes {
            0 => signed_percent(share.median),
            more => format!("{}, +{more} B", signed_percent(share.median)),
        },
    };
    let of = |sample: &Sample| bar(sample.more.name().to_owned(), sample.share, sample.bytes);
    let mut bars: Vec<Bar> = scene.dear().into_iter().map(of).collect();
    let cheap = scene.cheap();
    if !cheap.is_empty() {
        let shares: Vec<f64> = cheap.iter().map(|sample| sample.share.median).collect();
        let name = match (cheap.len(), bars.len()) {
            (1, _) => cheap[0].more.name().to_owned(),
            (count, 0) => format!("each of {count}"),
            (count, _) => format!("each of {count} others"),
        };
        bars.push(bar(name, Spread::of_all(&shares), scene.bytes));
    }
    bars.push(of(scene.all()));
    bars.push(of(scene.chance()));
    Group {
        name: format!(
            "{}: {} ms a step, {} B a body",
            scene.name,
            three_digits(scene.planned.median),
            scene.bytes
        ),
        bars,
    }
}

fn csv(scenes: &[Scene]) -> String {
    let mut text = "scene,bodies,run,bytes_a_body,planned_ms,least_planned_ms,largest_planned_ms,\
        more_us,least_more_us,largest_more_us,more_share,least_more_share,largest_more_share,\
        may_be_chance\n"
        .to_owned();
    for scene in scenes {
        for sample in &scene.samples {
            // Writing into a String can't fail.
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{}",
                draw::quoted(&scene.name),
                scene.bodies,
                sample.more.name(),
                sample.bytes,
                fields(scene.planned),
                fields(sample.micros),
                fields(sample.share),
                scene.may_be_chance(sample),
            );
        }
    }
    text
}

/// Median, least, largest.
fn fields(spread: Spread) -> String {
    format!("{:?},{:?},{:?}", spread.median, spread.low, spread.high)
}

fn page(scenes: &[Scene], repeats: usize) -> String {
    let mut table = Table::new(&[
        "scene",
        "bytes a body, planned / full",
        "ms/step, planned / full",
        "full takes longer by",
        "the same once more",
        "parts left out",
        "of them beyond chance",
        "dearest part",
    ]);
    for scene in scenes {
        let full_ms = scene.planned.median + 1e-3 * scene.all().micros.median;
        let (dear, all) = (scene.dear(), scene.all());
        let of = |share: Spread| {
            let [low, high] = [share.low, share.high].map(signed_percent);
            format!("{} ({low} … {high})", signed_percent(share.median))
        };
        table.push(vec![
            scene.name.clone(),
            format!("{} / {}", scene.bytes, all.bytes),
            format!(
                "{} / {}",
                three_digits(scene.planned.median),
                three_digits(full_ms)
            ),
            of(all.share),
            of(scene.chance().share),
            scene.parts().len().to_string(),
            dear.len().to_string(),
            dear.first().map_or("–".to_owned(), |part| {
                format!(
                    "{}, {}",
                    part.more.name(),
                    signed_percent(part.share.median)
                )
            }),
        ]);
    }
    format!(
        "Method `corrected` on one core of {cpu}, steps from the start, without the clock between the \
         systems. The planned run, the full one and one for each part that the plan leaves out (with what \
         that part can't do without) take turns of {TURN} steps; each difference is the median over the steps of what a step \
         takes longer than the planned run's, of {repeats} comparisons with engines loaded anew the median (and the \
         least … the largest). What lies within the differences of the planned run from itself, or reaches \
         both sides of 0, may be chance. After the last step all runs have the same bits in every column of \
         the bodies that the plan keeps. Bytes: of a body's state, and of its notes while it is \
         resolved.\n\n{table}",
        cpu = lab::processor(),
        table = table.markdown(1),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spread(low: f64, median: f64, high: f64) -> Spread {
        Spread { median, low, high }
    }

    fn sample(more: More, micros: Spread) -> Sample {
        Sample {
            more,
            bytes: 60,
            micros,
            share: micros.times(0.01),
        }
    }

    #[test]
    fn what_chance_explains_is_told_from_what_it_does_not() {
        let scene = Scene {
            name: "any".to_owned(),
            bodies: 1,
            bytes: 60,
            planned: spread(0.1, 0.1, 0.1),
            samples: vec![
                sample(More::Nothing, spread(-0.5, 0.1, 0.4)),
                sample(More::Part("within"), spread(0.3, 0.6, 0.9)),
                sample(More::Part("on both sides"), spread(-9.0, 5.0, 9.0)),
                sample(More::Part("some"), spread(0.5, 0.6, 0.9)),
                sample(More::Part("most"), spread(2.0, 3.0, 4.0)),
                sample(More::All, spread(4.0, 5.0, 6.0)),
            ],
        };
        let names = |samples: Vec<&Sample>| -> Vec<&str> {
            samples.iter().map(|sample| sample.more.name()).collect()
        };
        assert_eq!(names(scene.dear()), ["most", "some"]);
        assert_eq!(names(scene.cheap()), ["within", "on both sides"]);
        let bars = group(&scene).bars;
        assert_eq!(bars.len(), 5);
        assert_eq!(bars[2].name, "each of 2 others");
    }

    #[test]
    fn shares_have_a_sign_unless_they_are_nothing() {
        let texts = [0.123, -0.02, -0.0004, 0.0].map(signed_percent);
        assert_eq!(texts, ["+12.3 %", "−2.0 %", "0.0 %", "0.0 %"]);
    }

    #[test]
    fn every_case_leaves_parts_out_and_keeps_the_bits() {
        for case in CASES {
            let scene = measured(case.shortened(20), 1).expect("the same bits");
            assert!(!scene.parts().is_empty(), "{}", scene.name);
            assert!(scene.all().bytes >= scene.bytes);
            assert_eq!(scene.chance().bytes, scene.bytes);
        }
    }
}
