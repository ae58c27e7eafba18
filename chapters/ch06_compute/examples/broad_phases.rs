//! What it costs to find who may touch: the grids by size of engine `lanes` built anew, the same in the steps of
//! a run, chapter 3's KD-tree and chapter 3's grid over the same boxes, and all pairs. Writes a CSV: the
//! median of some steps, ms, on one thread and on all.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example broad_phases -- [SCENE COUNT]…`

use std::time::Instant;

use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Scene, Settings, Shape};
use ch03_collision::aabb::Aabb;
use ch03_collision::grid::Grid;
use ch03_collision::kd_tree::KdTree;
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::broad_phase::{BroadPhase, find_pairs};
use ch06_compute::rules::Rules;

type Problem = Box<dyn std::error::Error>;

/// Steps before any is measured: things have begun to pile up.
const BEFORE: u32 = 120;

/// Steps that are measured.
const MEASURED: usize = 20;

/// Radii of `unequal` are drawn from this many times one another, evenly by logarithm.
const SPREAD: f64 = 100.0;

fn main() -> Result<(), Problem> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut wanted: Vec<(String, u64)> = Vec::new();
    for pair in words.chunks_exact(2) {
        wanted.push((pair[0].clone(), pair[1].parse()?));
    }
    if wanted.is_empty() {
        let balls = [60, 1000, 10_000].map(|count| ("balls".to_owned(), count));
        let ragdolls = [80, 800].map(|count| ("ragdolls".to_owned(), count));
        let unequal = [1000, 10_000].map(|count| ("unequal".to_owned(), count));
        wanted.extend(balls.into_iter().chain(ragdolls).chain(unequal));
    }
    println!(
        "scene,count,bodies,pairs,rebuilds,reuses,step_ms,rebuild_ms,step_all_threads_ms,kd_tree_ms,grid_ms"
    );
    for (name, count) in wanted {
        measure(&name, count)?;
    }
    Ok(())
}

fn scene_of(name: &str, count: u64) -> Result<Scene, Problem> {
    if name != "unequal" {
        return Ok(Scene::open(name, Some(count), None)?);
    }
    let mut scene = Scene::open("balls", Some(count), None)?;
    let mut random = SplitMix64::new(3);
    for body in scene.bodies.iter_mut().filter(|body| !body.is_static()) {
        if let Shape::Sphere { radius } = &mut body.shape {
            *radius *= SPREAD.powf(random.unit() - 0.5);
        }
    }
    Ok(scene)
}

// ANCHOR: measure
/// Measures all ways beside each other in the same steps.
fn measure(name: &str, count: u64) -> Result<(), Problem> {
    let scene = scene_of(name, count)?;
    let rules = Rules::of(&scene, &Settings::defaults())?;
    let mut lanes =
        <Lanes>::of(&scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
    let dt = scene.dt as f32;
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let all = rayon::ThreadPoolBuilder::new().build()?;
    // Bodies of very unequal sizes start inside each other and are looked at as they stand.
    let stands = name == "unequal";
    let mut times: [Vec<f64>; 5] = Default::default();
    for _ in 0..if stands { 0 } else { BEFORE } {
        lanes.step(dt, |_| {});
    }
    let mut shared = BroadPhase::default();
    shared.ignored.clone_from(&lanes.broad.ignored);
    let mut anew = shared.clone();
    let (before, reused) = (lanes.broad.rebuilds, lanes.broad.reuses);
    for _ in 0..MEASURED {
        let bodies = &lanes.bodies;
        one.install(|| {
            times[0].push(time(|| find_pairs(bodies, dt, &mut lanes.broad)));
            anew.forget();
            times[1].push(time(|| find_pairs(bodies, dt, &mut anew)));
        });
        all.install(|| times[2].push(time(|| find_pairs(bodies, dt, &mut shared))));
        let boxes = lanes.broad.boxes();
        let mut pairs = Vec::new();
        times[3].push(time(|| by_tree(&boxes, &mut pairs)));
        times[4].push(time(|| by_grid(&boxes, &mut pairs)));
        if !stands {
            // It finds the pairs that it has.
            lanes.step(dt, |_| {});
        }
    }
    let steps = [lanes.broad.rebuilds - before, lanes.broad.reuses - reused];
    let [step, rebuild, all_threads, tree, grid] = times.map(median);
    println!(
        "{name},{count},{},{},{},{},{step:.3},{rebuild:.3},{all_threads:.3},{tree:.3},{grid:.3}",
        lanes.bodies.rows(),
        lanes.broad.pairs.len(),
        steps[0],
        // The second look in each step finds nobody moved.
        steps[1].saturating_sub(if stands { 0 } else { MEASURED }),
    );
    Ok(())
}
// ANCHOR_END: measure

fn time(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    1e3 * start.elapsed().as_secs_f64()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Pairs of boxes by chapter 3's tree, in order.
fn by_tree(boxes: &[Aabb], pairs: &mut Vec<(usize, usize)>) {
    let mut tree = KdTree::default();
    tree.build(boxes);
    sort_found(boxes, pairs, |wanted, found| {
        tree.overlapping(boxes, wanted, found);
    });
}

/// The same by its grid.
fn by_grid(boxes: &[Aabb], pairs: &mut Vec<(usize, usize)>) {
    let mut grid = Grid::default();
    grid.build(boxes);
    sort_found(boxes, pairs, |wanted, found| {
        grid.overlapping(boxes, wanted, found);
    });
}

fn sort_found(
    boxes: &[Aabb],
    pairs: &mut Vec<(usize, usize)>,
    ask: impl Fn(&Aabb, &mut dyn FnMut(usize)),
) {
    pairs.clear();
    for (i, wanted) in boxes.iter().enumerate() {
        let first = pairs.len();
        ask(wanted, &mut |j| {
            if j > i {
                pairs.push((i, j));
            }
        });
        pairs[first..].sort_unstable();
    }
}
