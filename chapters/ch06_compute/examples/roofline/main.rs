//! How near to what the machine could do are the passes of engine `lanes`? Each pass of a settled heap, by
//! its operations, the bytes that it touches and its time, on one thread, beside how fast the machine copies and
//! how fast it multiplies and adds.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example roofline -- [--csv FILE]
//! [SCENE COUNT]…`
//!
//! Operations are counted by running the same step over numbers that count ([`counted::Counted`]). `needed`
//! are those of one lane, `done` those of eight, idle lanes with them.

mod machine;
mod passes;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::time::Instant;

use ch00_scenes::{Scene, Settings, State};
use ch01_hierarchy::styles::report::processor;
use ch06_compute::lanes::Lanes;
use ch06_compute::rules::Rules;
use ch06_compute::simd::counted::{self, Counted, Work};
use ch06_compute::simd::{Eight, Real};
use passes::{PASSES, substeps};

type Problem = Box<dyn std::error::Error>;

/// Steps in which a heap settles.
const SETTLED: u32 = 300;

/// Steps after which all kinds of numbers know again what pressed.
const WARM: u32 = 20;

/// Steps that are timed.
const TIMED: usize = 15;

fn main() -> Result<(), Problem> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let mut file = None;
    if words.first().is_some_and(|word| word == "--csv") {
        words.remove(0);
        file = Some(words.remove(0));
    }
    let mut heaps: Vec<(String, u64)> = Vec::new();
    for pair in words.chunks_exact(2) {
        heaps.push((pair[0].clone(), pair[1].parse()?));
    }
    if heaps.is_empty() {
        heaps = vec![("pile".to_owned(), 10_000), ("ragdolls".to_owned(), 80)];
    }
    let mut lines = vec![
        "processor,instructions,scene,bodies,what,us_a_step,bytes,done,needed,choices".to_owned(),
    ];
    for ceiling in machine::ceilings() {
        lines.push(line(
            ("machine", 0),
            &ceiling.what,
            1e6 * ceiling.seconds,
            ceiling.bytes,
            [ceiling.arithmetic; 2],
            0.0,
        ));
        println!("{}", told(lines.last().map_or("", String::as_str)));
    }
    for (name, count) in heaps {
        for line in measured(&name, count)? {
            println!("{}", told(&line));
            lines.push(line);
        }
    }
    if let Some(file) = file {
        std::fs::write(file, lines.join("\n") + "\n")?;
    }
    Ok(())
}

/// A line of the table.
fn line(
    (scene, bodies): (&str, usize),
    what: &str,
    us: f64,
    bytes: f64,
    [done, needed]: [f64; 2],
    choices: f64,
) -> String {
    let processor = processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let wide = instructions();
    format!(
        "\"{processor}\",{wide},{scene},{bodies},{what},{us:?},{bytes},{done},{needed},{choices}"
    )
}

/// The widest instructions that this program was built for.
fn instructions() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "AVX-512"
    } else if cfg!(target_feature = "avx2") {
        "AVX2"
    } else if cfg!(target_feature = "sse2") {
        "SSE2"
    } else {
        "others"
    }
}

/// A line for people.
fn told(line: &str) -> String {
    let fields: Vec<&str> = line.rsplitn(9, ',').collect();
    let number = |k: usize| fields[k].parse().unwrap_or(0.0);
    let (us, bytes, done, needed): (f64, f64, f64, f64) =
        (number(4), number(3), number(2), number(1));
    let mut text = format!("{:9}{:22}{us:>13.4} µs", fields[7], fields[5]);
    if bytes + done == 0.0 {
        return text;
    }
    // Writing into a String can't fail.
    let _ = write!(text, "{:>8.1} GB/s", 1e-3 * bytes / us);
    let _ = write!(text, "{:>8.2} Gop/s", 1e-3 * done / us);
    if bytes > 0.0 && done > 0.0 {
        let idle = 100.0 * (1.0 - needed / done);
        let _ = write!(
            text,
            "{:>7.2} a byte{idle:>5.0} % in idle lanes",
            done / bytes
        );
    }
    text
}

/// What happened in the passes, in order of their names.
type By<T> = BTreeMap<&'static str, T>;

/// Passes of a heap.
fn measured(name: &str, count: u64) -> Result<Vec<String>, Problem> {
    let scene = Scene::open(name, Some(count), None)?;
    let mut settling = load::<Eight>(&scene)?;
    let dt = scene.dt as f32;
    for _ in 0..SETTLED {
        settling.step(dt, |_| {});
    }
    let mut state = State::default();
    settling.bodies.read(&mut state);
    let lanes: Lanes<Eight> = warm(&scene, &state)?;
    let (done, needed) = (
        counts::<Eight>(&scene, &state, &lanes)?,
        counts::<f32>(&scene, &state, &lanes)?,
    );
    let times = timed(&lanes, dt);
    let bodies = lanes.bodies.rows();
    let mut lines = Vec::new();
    for part in ["broad phase", "narrow phase"] {
        let us = times[part];
        lines.push(line((name, bodies), part, us, 0.0, [0.0; 2], 0.0));
    }
    for pass in PASSES.into_iter().filter(|pass| times.contains_key(pass)) {
        let substeps = f64::from(lanes.rules.substeps);
        let bytes = passes::bytes(pass, &lanes) as f64 * substeps;
        let work = |by: &By<Work>| by.get(pass).copied().unwrap_or_default();
        let by_hand = if pass == "gather" {
            passes::gathered(&lanes) as f64 * substeps
        } else {
            0.0
        };
        let mut arithmetic = [&done, &needed].map(|by| work(by).arithmetic as f64 + by_hand);
        // In one lane a tree is solved over plain `f32`, which counts nothing. In eight all are needed.
        if pass == "trees" {
            arithmetic[1] = arithmetic[0];
        }
        let choices = work(&done).choices as f64;
        let us = times[pass];
        lines.push(line((name, bodies), pass, us, bytes, arithmetic, choices));
    }
    Ok(lines)
}

fn load<R: Real>(scene: &Scene) -> Result<Lanes<R>, Problem> {
    let rules = Rules::of(scene, &Settings::defaults())?;
    let lanes = Lanes::of(scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
    Ok(lanes)
}

/// A run that goes on from a state.
fn warm<R: Real>(scene: &Scene, state: &State) -> Result<Lanes<R>, Problem> {
    let mut lanes = load(scene)?;
    lanes.write_state(state);
    for _ in 0..WARM {
        lanes.step(scene.dt as f32, |_| {});
    }
    Ok(lanes)
}

// ANCHOR: counts
/// What the passes compute in the substeps of a step, in the lanes of R. The run must have the bits of `lanes`.
fn counts<R: Real>(
    scene: &Scene,
    state: &State,
    lanes: &Lanes<Eight>,
) -> Result<By<Work>, Problem> {
    let mut counting: Lanes<Counted<R>> = warm(scene, state)?;
    if !passes::same_bits(&counting.bodies, &lanes.bodies) {
        return Err("numbers that count compute something else".into());
    }
    let mut by = By::<Work>::new();
    let _ = counted::done();
    substeps(&mut counting, scene.dt as f32, |pass| {
        let (work, sum) = (counted::done(), by.entry(pass).or_default());
        sum.arithmetic += work.arithmetic;
        sum.choices += work.choices;
    });
    Ok(by)
}
// ANCHOR_END: counts

/// How long the passes of a step take, µs. A pass runs in each substep of each timed step: of all these times
/// the least, as often as it runs in a step. Nothing but other work on the machine makes one longer.
fn timed(lanes: &Lanes<Eight>, dt: f32) -> By<f64> {
    let mut all = By::<Vec<f64>>::new();
    let mut last = Instant::now();
    let mut hear = |pass: &'static str| {
        let now = Instant::now();
        all.entry(pass)
            .or_default()
            .push(1e6 * (now - last).as_secs_f64());
        last = Instant::now();
    };
    for _ in 0..TIMED {
        let mut copy = lanes.clone();
        hear("copying");
        copy.step(dt, &mut hear);
        let mut copy = lanes.clone();
        hear("copying");
        substeps(&mut copy, dt, &mut hear);
    }
    let in_a_step = |(pass, times): (_, Vec<f64>)| {
        let often = (times.len() / TIMED) as f64;
        (
            pass,
            often * times.into_iter().fold(f64::INFINITY, f64::min),
        )
    };
    all.into_iter().map(in_a_step).collect()
}
