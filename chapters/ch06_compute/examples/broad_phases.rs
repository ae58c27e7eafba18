//! What it costs to find who may touch: grids by size and the tree of engine `lanes`, in the steps of a run and built
//! anew in each, beside chapter 3's tree and grid over the same boxes. Writes a line of CSV for each crowd, count and
//! way: the mean over some steps, ms, on one thread. All ways take turns in each step, and must find the same pairs.
//!
//! The mean is of two numbers: of what the quickest tenth of the steps takes in which all is built anew, and of the
//! same for the others. What other programs on the machine do to a step would spoil a plain one.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example broad_phases -- [CROWD COUNT]…`

use std::time::Instant;

use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Scene, Settings, Shape};
use ch01_hierarchy::styles::report::processor;
use ch03_collision::aabb::Aabb;
use ch03_collision::grid::Grid;
use ch03_collision::kd_tree::KdTree;
use ch06_compute::bodies::Bodies;
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::broad_phase::{BroadPhase, Way, find_pairs};
use ch06_compute::rules::Rules;
use glam::DVec3;

type Problem = Box<dyn std::error::Error>;

/// The crowds: what they are called, the scene, and the steps before any is measured.
const CROWDS: [(&str, &str, u32); 4] = [
    // They have come to rest, or nearly so.
    ("settled", "pile", 300),
    // They fall into a heap.
    ("crashing", "balls", 40),
    // They fly apart from each other, without weight.
    ("sparse", "balls", 0),
    // Limbs of all kinds, in their fall.
    ("ragdolls", "ragdolls", 40),
];

/// How many.
const COUNTS: [u64; 3] = [1000, 10_000, 100_000];

/// Steps before, where there are more than this many bodies: they take long.
const MANY: (usize, u32) = (50_000, 80);

/// Steps that are measured, of few bodies and of many.
const MEASURED: [usize; 2] = [48, 12];

/// Crowds like `sparse`, but nearer together, and of radii that are drawn from 1 to so much, evenly by logarithm:
/// `unequal 3` and so on. All are run with the second count, the last with the first one too.
const SPREADS: [f64; 6] = [1.0, 2.0, 4.0, 10.0, 30.0, 100.0];

/// A ball of those that fly has this many times the room of its own cube: in `sparse`, and in the others.
const ROOM: [f64; 2] = [30.0, 5.0];

/// How fast they fly, radii a second.
const SPEED: f64 = 2.0;

fn main() -> Result<(), Problem> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut wanted: Vec<(String, u64)> = Vec::new();
    for pair in words.chunks_exact(2) {
        wanted.push((pair[0].clone(), pair[1].parse()?));
    }
    if wanted.is_empty() {
        for (crowd, ..) in CROWDS {
            // A ragdoll has twelve limbs, and a thousand ragdolls are the most.
            let part = if crowd == "ragdolls" { 120 } else { 1 };
            let counts = COUNTS.map(|count| (crowd.to_owned(), count / part));
            wanted.extend(counts);
        }
        // Chapter 3's grid would take a minute a step for more.
        let [few, some, _] = COUNTS;
        for spread in SPREADS {
            wanted.push((format!("unequal {spread}"), some));
        }
        wanted.push((format!("unequal {}", SPREADS[SPREADS.len() - 1]), few));
    }
    println!("processor,crowd,bodies,pairs,way,ms,anew_of_steps");
    for (crowd, count) in wanted {
        measure(&crowd, count)?;
    }
    Ok(())
}

/// A crowd and the steps before any is measured; none if it flies.
fn scene_of(crowd: &str, count: u64) -> Result<(Scene, u32), Problem> {
    let known = CROWDS.iter().find(|(name, ..)| *name == crowd);
    let spread = crowd.strip_prefix("unequal ");
    let &(_, scene, before) = match spread {
        Some(_) => &("", "balls", 0),
        None => known.ok_or("no such crowd")?,
    };
    let room = ROOM[usize::from(spread.is_some())];
    let spread: f64 = spread.map_or(Ok(1.0), str::parse)?;
    let mut scene = Scene::open(scene, Some(count), None)?;
    if before > 0 {
        return Ok((scene, before));
    }
    let mut random = SplitMix64::new(3);
    scene.bodies.retain(|body| !body.is_static());
    let mut volume = 0.0;
    for body in &mut scene.bodies {
        if let Shape::Sphere { radius } = &mut body.shape {
            *radius *= spread.powf(random.unit() - 0.5);
            volume += room * (2.0 * *radius).powi(3);
        }
    }
    let edge = volume.cbrt();
    let mut place = || DVec3::from_array(std::array::from_fn(|_| random.unit() - 0.5));
    for body in &mut scene.bodies {
        body.position = edge * place();
        body.linear_velocity = SPEED * f64::from(body.shape.single().bounding_radius()) * place();
    }
    Ok((scene, 0))
}

/// A way to find the pairs, and what it took in each step, ms.
struct Contender {
    name: &'static str,
    /// Whether boxes have room, all is built anew in each step, or chapter 3 does it.
    by: By,
    broad: BroadPhase,
    /// Of the steps in which it used what it had, and of those in which it built all anew.
    times: [Vec<f64>; 2],
}

#[derive(Clone, Copy, PartialEq)]
enum By {
    Rooms,
    Anew,
    OldTree,
    OldGrid,
}

fn contenders(lanes: &Lanes) -> Vec<Contender> {
    let of = |name, way, by| {
        let mut broad = BroadPhase::default();
        broad.force(way);
        broad.ignored.clone_from(&lanes.broad.ignored);
        Contender {
            name,
            by,
            broad,
            times: Default::default(),
        }
    };
    vec![
        of("grids", Way::Grids, By::Rooms),
        of("tree", Way::Tree, By::Rooms),
        of("grids anew", Way::Grids, By::Anew),
        of("tree anew", Way::Tree, By::Anew),
        of("chapter 3's tree", Way::Grids, By::OldTree),
        of("chapter 3's grid", Way::Grids, By::OldGrid),
    ]
}

// ANCHOR: measure
/// Measures all ways beside each other in the same steps.
fn measure(crowd: &str, count: u64) -> Result<(), Problem> {
    let (scene, before) = scene_of(crowd, count)?;
    let rules = Rules::of(&scene, &Settings::defaults().with_method("coloured"))?;
    let mut lanes =
        <Lanes>::of(&scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
    let dt = scene.dt as f32;
    let many = lanes.bodies.rows() > MANY.0;
    for _ in 0..if many { before.min(MANY.1) } else { before } {
        lanes.step(dt, |_| {});
    }
    let mut contenders = contenders(&lanes);
    let steps = MEASURED[usize::from(many)];
    for step in 0..=steps {
        let count = contenders.len();
        for k in 0..count {
            contenders[(k + step) % count].find(&lanes.bodies, dt, step > 0);
        }
        let [first, others @ ..] = &contenders[..] else {
            continue;
        };
        if let Some(other) = others.iter().find(|o| o.broad.pairs != first.broad.pairs) {
            return Err(format!("{crowd} {count}: {} finds others", other.name).into());
        }
        if before > 0 {
            lanes.step(dt, |_| {});
        } else {
            fly(&mut lanes.bodies, dt);
        }
    }
    let processor = processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    for contender in &contenders {
        let [kept, anew] = &contender.times;
        let steps = (kept.len() + anew.len()) as f64;
        let all = [kept, anew].map(|times| times.len() as f64 * quick(times));
        let (mean, share) = (all.iter().sum::<f64>() / steps, anew.len() as f64 / steps);
        println!(
            "\"{processor}\",{crowd},{},{},{},{mean:.4},{share:.3}",
            lanes.bodies.rows(),
            contender.broad.pairs.len(),
            contender.name,
        );
    }
    Ok(())
}
// ANCHOR_END: measure

impl Contender {
    /// Finds the pairs; what the first time takes doesn't count.
    fn find(&mut self, bodies: &Bodies, dt: f32, counts: bool) {
        let boxes = match self.by {
            By::OldTree | By::OldGrid => {
                find_pairs(bodies, dt, &mut self.broad);
                self.broad.boxes()
            }
            By::Rooms | By::Anew => Vec::new(),
        };
        let before = self.broad.rebuilds;
        let start = Instant::now();
        match self.by {
            By::OldTree => by_tree(&boxes, &mut self.broad.pairs),
            By::OldGrid => by_grid(&boxes, &mut self.broad.pairs),
            By::Anew => {
                self.broad.forget();
                find_pairs(bodies, dt, &mut self.broad);
            }
            By::Rooms => find_pairs(bodies, dt, &mut self.broad),
        }
        if counts {
            let ms = 1e3 * start.elapsed().as_secs_f64();
            let old = matches!(self.by, By::OldTree | By::OldGrid);
            let anew = old || self.broad.rebuilds > before;
            self.times[usize::from(anew)].push(ms);
        }
        if matches!(self.by, By::OldTree | By::OldGrid) {
            let broad = &mut self.broad;
            let idle = |row: usize| bodies.is_static(row);
            let ignored = &broad.ignored;
            broad.pairs.retain(|pair| {
                !(idle(pair.0) && idle(pair.1)) && ignored.binary_search(pair).is_err()
            });
        }
    }
}

/// What the quickest tenth takes at most; 0 of none.
fn quick(times: &[f64]) -> f64 {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 10).copied().unwrap_or(0.0)
}

/// Bodies that touch nobody, a step later.
fn fly(bodies: &mut Bodies, dt: f32) {
    for (place, motion) in bodies.place.iter_mut().zip(&bodies.motion) {
        place.position += dt * motion.velocity;
    }
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
