//! How long it takes to find the pairs of boxes that overlap, all of them, as a step needs it: by
//! asking every pair, by a KD-tree that is built anew, and by a uniform grid that is built anew; for
//! 10 to 100,000 boxes.
//!
//! Three crowds: spread out in a cube, with room between them; in a pile between a floor and walls,
//! close together; and of edges from 1 to 50, where no size of a cell is right for all.

use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

use ch00_scenes::random::SplitMix64;
use ch03_collision::aabb::Aabb;
use ch03_collision::brute_force;
use ch03_collision::grid::Grid;
use ch03_collision::kd_tree::KdTree;
use glam::Vec3;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::lab::median;
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// Numbers of boxes.
pub const COUNTS: [usize; 13] = [
    10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000,
];
/// A way that took longer than this isn't tried on more boxes, ms.
const PATIENCE: f64 = 200.0;
/// A measurement goes on for so many runs and so long, s, whichever comes last.
const RUNS: usize = 5;
const LEAST_TIME: f64 = 0.03;
/// Each run has other boxes, of this many in all: a processor learns by heart which of a few hundred
/// pairs overlap, and is then five times as fast as it would be in a step.
const BOXES_IN_ALL: usize = 20_000;

/// A way to find pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Every pair is asked.
    Force,
    /// `kd_tree.rs`.
    Tree,
    /// `grid.rs`.
    Grid,
}

/// The ways in the order of the tables, with their names and looks.
const WAYS: [(Way, &str, Style); 3] = [
    (Way::Force, "every pair", Style::Printed),
    (Way::Tree, "KD-tree", Style::Corrected),
    (Way::Grid, "grid", Style::Other(0)),
];

/// A kind of crowd.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crowd {
    /// Spread out in a cube.
    Cloud,
    /// Close together between a floor and walls.
    Pile,
    /// Of edges from 1 to 50.
    Unequal,
}

/// The crowds in the order of the tables.
pub const CROWDS: [Crowd; 3] = [Crowd::Cloud, Crowd::Pile, Crowd::Unequal];

impl Crowd {
    /// Name of its chart.
    fn chart(self) -> &'static str {
        match self {
            Crowd::Cloud => "broad_phase",
            Crowd::Pile => "broad_phase_pile",
            Crowd::Unequal => "broad_phase_unequal",
        }
    }

    fn title(self) -> &'static str {
        match self {
            Crowd::Cloud => "a cloud of boxes of 0.2 to 0.6 m",
            Crowd::Pile => "a pile of boxes of 0.2 to 0.6 m between floor and walls",
            Crowd::Unequal => "a cloud of boxes of 0.1 to 5 m",
        }
    }

    fn boxes(self, count: usize, seed: u64) -> Vec<Aabb> {
        match self {
            Crowd::Cloud => cloud(count, seed),
            Crowd::Pile => pile(count, seed),
            Crowd::Unequal => unequal(count, seed),
        }
    }
}

/// How long a way took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The crowd.
    pub crowd: Crowd,
    /// The way.
    pub way: Way,
    /// Number of boxes.
    pub count: usize,
    /// Pairs that it found.
    pub pairs: usize,
    /// Median of the runs, building included, ms.
    pub median_ms: f64,
}

/// Measures, and lays out pictures, CSV and page.
///
/// # Errors
/// None: no scene is loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let most = if quick { 5000 } else { 100_000 };
    let mut samples = Vec::new();
    for crowd in CROWDS {
        let mut ways = WAYS.map(|(way, ..)| way).to_vec();
        for count in COUNTS.into_iter().filter(|&count| count <= most) {
            let now = measured(crowd, count, &ways);
            ways = now
                .iter()
                .filter(|sample| sample.median_ms < PATIENCE)
                .map(|sample| sample.way)
                .collect();
            samples.extend(now);
        }
        say(crowd.title());
    }
    Ok(Product {
        charts: CROWDS.map(|crowd| chart(crowd, &samples).into()).to_vec(),
        csv: csv(&samples),
        page: Some(page(&samples)),
    })
}

/// Times some ways on the same boxes.
#[must_use]
pub fn measured(crowd: Crowd, count: usize, ways: &[Way]) -> Vec<Sample> {
    let seeds = 1..=(BOXES_IN_ALL / count).max(1) as u64;
    let sets: Vec<Vec<Aabb>> = seeds.map(|seed| crowd.boxes(count, seed)).collect();
    let (mut tree, mut grid) = (KdTree::default(), Grid::default());
    ways.iter()
        .map(|&way| {
            let (pairs, median_ms) = timed(&sets, |boxes| match way {
                Way::Force => by_force(boxes),
                Way::Tree => by_tree(&mut tree, boxes),
                Way::Grid => by_grid(&mut grid, boxes),
            });
            Sample {
                crowd,
                way,
                count,
                pairs,
                median_ms,
            }
        })
        .collect()
}

fn by_force(boxes: &[Aabb]) -> usize {
    let mut pairs = 0;
    brute_force::all_pairs(boxes, |_, _| pairs += 1);
    pairs
}

fn by_tree(tree: &mut KdTree, boxes: &[Aabb]) -> usize {
    tree.build(boxes);
    let mut pairs = 0;
    for (i, one) in boxes.iter().enumerate() {
        tree.overlapping(boxes, one, |j| pairs += usize::from(j > i));
    }
    pairs
}

fn by_grid(grid: &mut Grid, boxes: &[Aabb]) -> usize {
    grid.build(boxes);
    let mut pairs = 0;
    for (i, one) in boxes.iter().enumerate() {
        grid.overlapping(boxes, one, |j| pairs += usize::from(j > i));
    }
    pairs
}

/// What it found in the first set of boxes, and the median time of its runs on all of them in turn
/// after one that doesn't count, ms.
fn timed(sets: &[Vec<Aabb>], mut find: impl FnMut(&[Aabb]) -> usize) -> (usize, f64) {
    let pairs = find(&sets[0]);
    let mut times = Vec::new();
    let start = Instant::now();
    for boxes in sets.iter().cycle() {
        let run = Instant::now();
        black_box(find(boxes));
        times.push(1e3 * run.elapsed().as_secs_f64());
        if times.len() >= RUNS && start.elapsed().as_secs_f64() >= LEAST_TIME {
            break;
        }
    }
    (pairs, median(times))
}

/// `count` boxes with their centres anywhere in a box of so many cubic metres for each, `shape`
/// wide, high and deep in proportion.
fn scattered(
    count: usize,
    room: f32,
    shape: Vec3,
    seed: u64,
    mut edge: impl FnMut(f64) -> f64,
) -> (Vec<Aabb>, Vec3) {
    let volume = room * count as f32;
    let extent = shape * (volume / shape.element_product()).cbrt();
    let mut random = SplitMix64::new(seed);
    let mut number = || random.unit();
    let boxes = (0..count).map(|_| {
        let half = 0.5 * edge(number()) as f32;
        let centre = Vec3::new(number() as f32, number() as f32, number() as f32) * extent;
        Aabb {
            min: centre - half,
            max: centre + half,
        }
    });
    (boxes.collect(), extent)
}

fn usual_edge(share: f64) -> f64 {
    0.2 + 0.4 * share
}

/// About as far from each other as four of their edges: a pair for every seven boxes.
fn cloud(count: usize, seed: u64) -> Vec<Aabb> {
    scattered(count, 1.8, Vec3::ONE, seed, usual_edge).0
}

/// As close as balls in a heap: each overlaps with about six others.
fn pile(count: usize, seed: u64) -> Vec<Aabb> {
    let (mut boxes, extent) = scattered(count, 0.09, Vec3::new(2.0, 1.0, 2.0), seed, usual_edge);
    let (low, high) = (Vec3::splat(-1.0), extent + 1.0);
    let slab = |min: Vec3, max: Vec3| Aabb { min, max };
    boxes.extend([
        slab(low, high.with_y(0.0)),
        slab(low, high.with_x(0.0)),
        slab(low, high.with_z(0.0)),
        slab(low.with_x(extent.x), high),
        slab(low.with_z(extent.z), high),
    ]);
    boxes
}

/// Every decade of edges has as many boxes.
fn unequal(count: usize, seed: u64) -> Vec<Aabb> {
    scattered(count, 8.0, Vec3::ONE, seed, |share| 0.1 * 50f64.powf(share)).0
}

/// The times of a way on a crowd, by number of boxes.
fn times(samples: &[Sample], crowd: Crowd, way: Way) -> Vec<(f64, f64)> {
    let same = |s: &&Sample| (s.crowd, s.way) == (crowd, way);
    let some = samples.iter().filter(same);
    some.map(|s| (s.count as f64, s.median_ms)).collect()
}

/// The number of boxes from which on the second of two curves lies below the first, by a straight
/// line between the last two points where they change sides on logarithmic axes; 0 where it
/// always does, infinite where it doesn't at the end.
#[must_use]
pub fn crossover(first: &[(f64, f64)], second: &[(f64, f64)]) -> f64 {
    let both: Vec<(f64, f64)> = first
        .iter()
        .zip(second)
        .map(|(a, b)| (a.0.ln(), (b.1 / a.1).ln()))
        .collect();
    let Some(last) = both.iter().rposition(|&(_, ratio)| ratio >= 0.0) else {
        return 0.0;
    };
    match both.get(last + 1) {
        None => f64::INFINITY,
        Some(next) => {
            let here = both[last];
            let share = here.1 / (here.1 - next.1);
            (here.0 + share * (next.0 - here.0)).exp()
        }
    }
}

fn chart(crowd: Crowd, samples: &[Sample]) -> Chart {
    let curve = |(way, name, style)| Series::new(name, style, times(samples, crowd, way));
    Chart {
        name: crowd.chart(),
        title: format!("Finding all pairs once: {}", crowd.title()),
        x: Axis::log("boxes"),
        y: Axis::log("time, building included (ms)"),
        series: WAYS.map(curve).to_vec(),
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "crowd,way,boxes,pairs,median_ms\n".to_owned();
    for s in samples {
        let name = WAYS
            .iter()
            .find(|(way, ..)| *way == s.way)
            .map_or("", |w| w.1);
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{name},{},{},{:?}",
            s.crowd.chart(),
            s.count,
            s.pairs,
            s.median_ms
        );
    }
    text
}

fn page(samples: &[Sample]) -> String {
    let mut table = Table::new(&[
        "crowd",
        "boxes",
        "pairs",
        "every pair (ms)",
        "KD-tree (ms)",
        "grid (ms)",
    ]);
    let mut turns = Table::new(&[
        "crowd",
        "KD-tree beats every pair from",
        "grid beats every pair from",
        "grid beats KD-tree from",
    ]);
    for crowd in CROWDS {
        for count in [10, 100, 1000, 10_000, 100_000] {
            let at = |way| {
                let same = |s: &&Sample| (s.crowd, s.way, s.count) == (crowd, way, count);
                samples.iter().find(same)
            };
            let Some(found) = at(Way::Tree) else { continue };
            let mut cells = vec![
                crowd.title().to_owned(),
                draw::grouped(&count.to_string()),
                draw::grouped(&found.pairs.to_string()),
            ];
            let time = |way| at(way).map_or("–".to_owned(), |s| three_digits(s.median_ms));
            cells.extend(WAYS.map(|(way, ..)| time(way)));
            table.push(cells);
        }
        let times = |way| times(samples, crowd, way);
        let from = |first, second| boxes(crossover(&times(first), &times(second)));
        turns.push(vec![
            crowd.title().to_owned(),
            from(Way::Force, Way::Tree),
            from(Way::Force, Way::Grid),
            from(Way::Tree, Way::Grid),
        ]);
    }
    format!(
        "Time to find every pair of overlapping boxes once, on one core: median of at least {RUNS} runs \
         after one that doesn't count; tree and grid are built anew in each, and a run has other boxes \
         than the one before, as far as they are few. A way that took longer \
         than {PATIENCE} ms was not tried on more boxes.\n\n{times}\n\
         Who wins from how many boxes on, read between the measured numbers:\n\n{turns}",
        times = table.markdown(1),
        turns = turns.markdown(1),
    )
}

/// A number of boxes where sides change.
fn boxes(number: f64) -> String {
    if number == 0.0 {
        "always".to_owned()
    } else if number.is_finite() {
        three_digits(number)
            .split('.')
            .next()
            .unwrap_or_default()
            .to_owned()
    } else {
        "never".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_ways_find_the_same_pairs() {
        for crowd in CROWDS {
            let boxes = crowd.boxes(500, 1);
            let force = by_force(&boxes);
            assert!(force > 0, "{}", crowd.title());
            assert_eq!(by_tree(&mut KdTree::default(), &boxes), force);
            assert_eq!(by_grid(&mut Grid::default(), &boxes), force);
        }
    }

    #[test]
    fn crowds_are_as_dense_as_they_say() {
        let a_box = |crowd: Crowd| by_force(&crowd.boxes(2000, 1)) as f64 / 2000.0;
        let [cloud, pile, unequal] = CROWDS.map(a_box);
        assert!((0.1..0.2).contains(&cloud), "{cloud}");
        assert!((2.5..4.0).contains(&pile), "{pile}");
        assert!((2.0..6.0).contains(&unequal), "{unequal}");
    }

    #[test]
    fn curves_cross_where_they_are_equal() {
        let square = [1.0, 10.0, 100.0].map(|n| (n, n * n));
        let line = [1.0, 10.0, 100.0].map(|n| (n, 30.0 * n));
        assert!((crossover(&square, &line) - 30.0).abs() < 1e-9);
        assert_eq!(crossover(&line, &square), f64::INFINITY);
        assert_eq!(crossover(&line, &line.map(|(n, t)| (n, 0.5 * t))), 0.0);
    }
}
