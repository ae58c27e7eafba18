//! What each part that engine `lanes` leaves out would cost: a step with no more than the scene needs, beside the
//! same with one part more, and with all. They take turns, on one thread; each comparison is made several times,
//! with engines loaded anew. Operations are counted by numbers that count.

mod told;

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, Settings, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::plan::{PARTS, Part, Plan};
use ch06_compute::rules::Rules;
use ch06_compute::simd::Real;
use ch06_compute::simd::counted::{self, Counted};

use crate::FindingsError;
use crate::columns::built;
use crate::draw;
use crate::lab::{Clock, Spread, turns};
use crate::product::{Product, Say};

/// A scene, and how it is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Case {
    scene: &'static str,
    count: u64,
    /// Whether friction is taken from all bodies.
    smooth: bool,
    method: &'static str,
    /// Steps that are timed.
    steps: u32,
}

const fn case(scene: &'static str, count: u64, method: &'static str, steps: u32) -> Case {
    Case {
        scene,
        count,
        smooth: false,
        method,
        steps,
    }
}

/// The cases.
const CASES: [Case; 7] = [
    case("smooth_balls", 1000, "own-row", 400),
    case("smooth_balls", 1000, "coloured", 400),
    case("pile", 3000, "coloured", 200),
    Case {
        smooth: true,
        ..case("pile", 3000, "coloured", 200)
    },
    case("mixed", 300, "own-row", 400),
    Case {
        smooth: true,
        ..case("mixed", 300, "own-row", 400)
    },
    case("ragdolls", 40, "own-row", 300),
];
/// Steps before any is timed.
const SETTLE: u32 = 200;
/// Steps after which a run that began in the middle knows again what presses.
const WARM: u32 = 5;
/// Comparisons of each.
const REPEATS: usize = 5;

/// Which run it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum More {
    /// The planned one once more.
    Nothing,
    Part(Part),
    All,
}

impl More {
    fn name(self) -> &'static str {
        match self {
            More::Nothing => "the same once more",
            More::Part(part) => part.name(),
            More::All => "all of these",
        }
    }

    fn plan(self) -> Plan {
        match self {
            More::Nothing => Plan::default(),
            More::Part(part) => Plan::default().with(part),
            More::All => Plan::full(),
        }
    }

    /// Whether it has the planned run's bits.
    fn keeps_bits(self) -> bool {
        match self {
            More::Nothing => true,
            More::Part(part) => part.keeps_bits(),
            More::All => false,
        }
    }
}

/// What can be said of a run without a clock.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Facts {
    /// Operations of a substep, over the pairs.
    operations: f64,
    /// Of the batches, over the pairs.
    bytes: f64,
    /// 99 of 100 pairs that overlap do so by no more than this part of the smaller radius: mean of the comparisons.
    p99: f64,
}

/// A run beside the planned one.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    more: More,
    facts: Facts,
    /// What a step takes longer, over the planned run's: median of the comparisons, the least, the largest.
    share: Spread,
}

/// All runs of a case.
#[derive(Clone, Debug, PartialEq)]
struct Outcome {
    name: String,
    method: &'static str,
    pairs: usize,
    facts: Facts,
    /// A step, ms.
    planned: Spread,
    samples: Vec<Sample>,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where a scene can't be loaded or a part that shouldn't changes what comes out.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let repeats = if quick { 1 } else { REPEATS };
    let mut outcomes = Vec::new();
    for case in CASES {
        let case = if quick { shortened(case) } else { case };
        let outcome = measured(case, repeats)?;
        say(&format!("{}, {}", outcome.name, outcome.method));
        outcomes.push(outcome);
    }
    Ok(Product {
        charts: vec![told::chart(&outcomes).into()],
        csv: told::csv(&outcomes),
        page: Some(told::page(&outcomes, repeats)),
    })
}

fn shortened(case: Case) -> Case {
    Case {
        count: case.count.min(1000) / 10,
        steps: 20,
        ..case
    }
}

// ANCHOR: measured
/// Compares the planned run with the others, so many times.
fn measured(case: Case, repeats: usize) -> Result<Outcome, FindingsError> {
    let (scene, rules) = open(case)?;
    let start = settled(&scene, rules)?;
    let others = others(&start);
    let mut planned = Vec::new();
    let mut shares = vec![Vec::new(); others.len()];
    let mut depths = vec![0.0; others.len() + 1];
    for _ in 0..repeats {
        let plans = std::iter::once(More::Nothing).chain(others.iter().copied());
        let mut runs = plans
            .map(|more| from::<ch06_compute::simd::Widest>(&scene, rules, &start.state, more))
            .collect::<Result<Vec<_>, _>>()?;
        let times = steps(case, &scene, &mut runs);
        same_bits(&scene, &others, &runs)?;
        planned.push(1e3 * times[0]);
        for (shares, time) in shares.iter_mut().zip(&times[1..]) {
            shares.push(time / times[0] - 1.0);
        }
        for (sum, run) in depths.iter_mut().zip(&runs) {
            *sum += depth(&scene, run) / repeats as f64;
        }
    }
    // ANCHOR_END: measured
    let facts = |more: More, p99: f64| facts(&scene, rules, &start.state, more, p99);
    let mut samples = Vec::new();
    for (k, &more) in others.iter().enumerate() {
        samples.push(Sample {
            more,
            facts: facts(more, depths[k + 1])?,
            share: Spread::of_all(&shares[k]),
        });
    }
    let smooth = if case.smooth { ", smooth" } else { "" };
    let count = draw::grouped(&case.count.to_string());
    Ok(Outcome {
        name: format!("{}{smooth}, {count}", case.scene),
        method: case.method,
        pairs: start.pairs,
        facts: facts(More::Nothing, depths[0])?,
        planned: Spread::of_all(&planned),
        samples,
    })
}

fn open(case: Case) -> Result<(Scene, Rules), FindingsError> {
    let mut scene = built(case.scene, Some(case.count))?;
    if case.smooth {
        for body in &mut scene.bodies {
            (body.friction, body.static_friction) = (0.0, None);
        }
    }
    let settings = Settings::defaults().with_method(case.method);
    let rules = Rules::of(&scene, &settings)?;
    Ok((scene, rules))
}

/// A run of a plan from the scene's start.
fn load<R: Real>(scene: &Scene, rules: Rules, more: More) -> Result<Lanes<R>, FindingsError> {
    let lanes = Lanes::of(scene, rules);
    let mut lanes = lanes.map_err(|why| ch06_compute::lanes::unsupported("lanes", scene, why))?;
    lanes.plan = more.plan();
    Ok(lanes)
}

/// The same from the middle.
fn from<R: Real>(
    scene: &Scene,
    rules: Rules,
    state: &State,
    more: More,
) -> Result<Lanes<R>, FindingsError> {
    let mut lanes = load::<R>(scene, rules, more)?;
    lanes.write_state(state);
    for _ in 0..WARM {
        lanes.step(scene.dt as f32, |_| ());
    }
    Ok(lanes)
}

/// Where the timed runs begin.
struct Start {
    state: State,
    pairs: usize,
    /// Which parts are left out there.
    left_out: Vec<Part>,
}

fn settled(scene: &Scene, rules: Rules) -> Result<Start, FindingsError> {
    let mut lanes = load::<ch06_compute::simd::Widest>(scene, rules, More::Nothing)?;
    for _ in 0..SETTLE {
        lanes.step(scene.dt as f32, |_| ());
    }
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    let [rough, smooth] = lanes.pairs.counts();
    let sum = |batches: &[usize]| batches.iter().sum::<usize>();
    let is_left_out = |part: &Part| match part {
        Part::Shapes => sum(&rough[..2]) + sum(&smooth[..2]) > 0,
        Part::Friction => sum(&smooth) > 0,
        Part::Points => sum(&rough[..5]) + sum(&smooth[..5]) > 0,
        Part::Joints => scene.joints.is_empty() && scene.forces.is_empty(),
    };
    Ok(Start {
        state,
        pairs: lanes.pairs.bodies.len(),
        left_out: PARTS.into_iter().filter(is_left_out).collect(),
    })
}

/// What runs beside the planned one.
fn others(start: &Start) -> Vec<More> {
    let parts = start.left_out.iter().map(|&part| More::Part(part));
    [More::Nothing]
        .into_iter()
        .chain(parts)
        .chain([More::All])
        .collect()
}

/// Makes all steps of all runs, in turn; gives what a step of each took, s of the processor's time.
fn steps(case: Case, scene: &Scene, runs: &mut [Lanes]) -> Vec<f64> {
    let mut times = vec![0.0; runs.len()];
    for (k, turn) in turns(case.steps, runs.len()) {
        let clock = Clock::start();
        for _ in 0..turn {
            runs[k].step(scene.dt as f32, |_| ());
        }
        times[k] += clock.seconds() / f64::from(case.steps);
    }
    times
}

/// Whether the runs that should have the bits of the first, which is the planned one.
fn same_bits(scene: &Scene, others: &[More], runs: &[Lanes]) -> Result<(), FindingsError> {
    let of = |lanes: &Lanes| {
        let mut state = State::default();
        lanes.bodies.read(&mut state);
        state
    };
    let first = of(&runs[0]);
    for (more, run) in others.iter().zip(&runs[1..]) {
        if more.keeps_bits() && of(run) != first {
            return Err(FindingsError::Differs {
                chart: "lanes_left_out",
                scene: scene.name.clone(),
                run: more.name().to_owned(),
                what: "where the bodies are, and how they move".to_owned(),
            });
        }
    }
    Ok(())
}

fn depth(scene: &Scene, lanes: &Lanes) -> f64 {
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    Measures::of(scene, &state).penetration.relative.p99
}

/// Counts a step from the middle.
fn facts(
    scene: &Scene,
    rules: Rules,
    state: &State,
    more: More,
    p99: f64,
) -> Result<Facts, FindingsError> {
    let mut lanes = from::<Counted<f32>>(scene, rules, state, more)?;
    let mut operations = 0;
    lanes.step(scene.dt as f32, |part| {
        let work = counted::done();
        if part == "substeps" {
            operations = work.arithmetic;
        }
    });
    let wide = from::<ch06_compute::simd::Widest>(scene, rules, state, more)?;
    let per_pair = |number: f64, lanes: usize| number / lanes.max(1) as f64;
    Ok(Facts {
        operations: per_pair(operations as f64, lanes.pairs.bodies.len())
            / f64::from(rules.substeps),
        bytes: per_pair(wide.pairs.bytes() as f64, wide.pairs.bodies.len()),
        p99,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_case_leaves_out_what_it_says_and_computes_no_more_with_it() {
        let wanted: [&[Part]; 7] = [
            &PARTS,
            &PARTS,
            &[Part::Shapes, Part::Points, Part::Joints],
            &PARTS,
            &[Part::Shapes, Part::Points, Part::Joints],
            &PARTS,
            &[Part::Points],
        ];
        for (case, parts) in CASES.into_iter().zip(wanted) {
            let outcome = measured(shortened(case), 1).expect("the same bits");
            let runs: Vec<More> = outcome.samples.iter().map(|s| s.more).collect();
            let parts = parts.iter().map(|&part| More::Part(part));
            let all: Vec<More> = [More::Nothing]
                .into_iter()
                .chain(parts)
                .chain([More::All])
                .collect();
            assert_eq!(runs, all, "{}", outcome.name);
            for sample in &outcome.samples {
                let (with, planned) = (sample.facts, outcome.facts);
                assert!(with.operations >= planned.operations, "{outcome:?}");
                assert!(with.bytes >= planned.bytes, "{outcome:?}");
            }
        }
    }
}
