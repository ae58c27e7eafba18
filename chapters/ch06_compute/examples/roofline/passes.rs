//! The passes of the substeps, one by one: what each computes, what it touches, and how long it takes.

use ch06_compute::bodies::Bodies;
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::batches::Batch;
use ch06_compute::lanes::movers::Movers;
use ch06_compute::lanes::sums::Sums;
use ch06_compute::lanes::work::{PressAgain, Solve};
use ch06_compute::own_row::body::Gathered;
use ch06_compute::own_row::contact::Impulses;
use ch06_compute::own_row::limits::Bounds;
use ch06_compute::own_row::tree::{Limb, Solved};
use ch06_compute::rows::{Held, Motion, Place, Press, Push, Seen, Spin, Turned};
use ch06_compute::simd::{Eight, Real};
use glam::{Quat, Vec3};

/// The passes that a substep may have, in order.
pub const PASSES: [&str; 6] = ["pairs", "limits", "gather", "bodies", "exchange", "trees"];

/// The kind of a pair of balls.
const TWO_BALLS: u32 = 0;

/// One thread does all.
const ALL: usize = usize::MAX;

/// The substeps of a step over the pairs that the last step found: what [`Lanes::step`] does, cut into its
/// passes. `done` hears of each when it is done.
pub fn substeps<R: Real>(lanes: &mut Lanes<R>, dt: f32, mut done: impl FnMut(&'static str)) {
    let step = lanes.rules.step(dt, lanes.bodies.rows());
    let is_plain = lanes.joints.is_empty();
    let mut sums = vec![Gathered::default(); lanes.bodies.rows()];
    start(lanes, &mut sums, step.h);
    Movers::of(&mut lanes.bodies, ALL).each::<R>(|b| b.kick::<R>(&[], &lanes.joints, &step));
    done("start");
    for substep in 1..=lanes.rules.substeps {
        let kicks = substep < lanes.rules.substeps;
        let bodies = &lanes.bodies;
        let solve = Solve {
            bodies,
            step: &step,
        };
        lanes.pairs.each(ALL, &solve);
        done("pairs");
        if !is_plain {
            lanes.joints.solve_rows(&lanes.bodies, step.h);
            done("limits");
        }
        gather(lanes, &mut sums);
        done("gather");
        let mut movers = Movers::of(&mut lanes.bodies, ALL);
        let sums = Sums::at(&sums, lanes.regions.spots());
        if is_plain {
            movers.each::<R>(|block| block.substep::<R>(&sums, kicks, &step));
            done("bodies");
            continue;
        }
        movers.each::<R>(|block| block.exchange::<R>(&sums));
        done("exchange");
        lanes.joints.solve_trees(&mut lanes.bodies, step.h);
        done("trees");
        let mut movers = Movers::of(&mut lanes.bodies, ALL);
        movers.each::<R>(|block| {
            block.advance::<R>(&sums, &lanes.joints, &step);
            if kicks {
                block.kick::<R>(&[], &lanes.joints, &step);
            }
        });
        done("bodies");
    }
}

/// What held the bodies in the last step.
fn start<R: Real>(lanes: &mut Lanes<R>, sums: &mut [Gathered], h: f32) {
    let bodies = &lanes.bodies;
    lanes.pairs.each(ALL, &PressAgain { bodies, h });
    gather(lanes, sums);
    let sums = Sums::at(sums, lanes.regions.spots());
    for row in 0..lanes.bodies.rows() {
        let sum = sums.row(row);
        lanes.bodies.held[row] = sum.stays;
        lanes.bodies.motion[row].shares = sum.counts.max(1.0);
    }
}

/// Every body sums what its pairs, limits and loops did to it.
fn gather<R: Real>(lanes: &Lanes<R>, sums: &mut [Gathered]) {
    let runs = lanes.bodies.runs();
    let more = |row: usize, sum: &mut Gathered| lanes.joints.gather(row, sum);
    lanes.pairs.gather((&lanes.regions, runs), ALL, sums, more);
}

/// Additions and multiplications of [`Gathered::add`], which isn't written over a [`Real`]: 24 of either.
const ADDED: u64 = 48;

/// Arithmetic of `gather` in a substep, counted by hand.
pub fn gathered(lanes: &Lanes<Eight>) -> u64 {
    2 * lanes.pairs.bodies.len() as u64 * ADDED
}

/// Size of a row, bytes.
const fn row<T>() -> u64 {
    size_of::<T>() as u64
}

/// What a lane of eight has, bytes.
const fn lane<T>() -> u64 {
    row::<T>() / Eight::LANES as u64
}

/// Place, attitude, motion and spin.
const MOVER: u64 = row::<Place>() + row::<Quat>() + row::<Motion>() + row::<Spin>();

/// The same with the inverse inertia: what a row reads of a body.
const SIDE: u64 = MOVER + row::<Vec3>();

// ANCHOR: bytes
/// Bytes that a pass reads and writes in a substep, by the sizes of its rows. A row that two read counts
/// twice, wherever it is found.
pub fn bytes(pass: &str, lanes: &Lanes<Eight>) -> u64 {
    let (bodies, pairs) = (lanes.bodies.rows() as u64, lanes.pairs.bodies.len() as u64);
    let (joints, momentum) = (!lanes.joints.is_empty(), row::<Vec3>());
    let limits = lanes.joints.trees.limits.len() as u64;
    let nodes = lanes.joints.trees.nodes.len() as u64;
    let kick = MOVER + momentum + row::<Seen>();
    match pass {
        "pairs" => batches(lanes) + pairs * row::<Press>(),
        "limits" => limits * (lane::<Bounds<Eight>>() + 2 * SIDE + 2 * row::<Turned>()),
        "gather" => {
            let entries = 2 * pairs * (row::<u32>() + row::<Press>());
            bodies * row::<Gathered>() + entries + 2 * limits * row::<Turned>()
        }
        "exchange" => {
            let read = SIDE + momentum + row::<Gathered>() + row::<Held>();
            bodies * (read + MOVER + momentum + row::<Held>() + row::<Push>())
        }
        "trees" => {
            let walked = 2 * lane::<Limb<Eight>>() + MOVER + row::<Held>() + row::<Solved>();
            let applied = row::<Solved>() + row::<Motion>() + row::<Spin>() + momentum;
            nodes * (walked + applied + row::<Push>() + row::<Held>())
        }
        "bodies" if joints => {
            let advance = SIDE + row::<Push>() + row::<Vec3>() + MOVER;
            bodies * (advance + SIDE + momentum + 2 * row::<Held>() + kick)
        }
        _ => {
            let read = SIDE + momentum + row::<Gathered>() + row::<Held>();
            bodies * (read + kick + row::<Held>() + row::<Push>())
        }
    }
}
// ANCHOR_END: bytes

/// What a pair of balls reads of a body: no attitude, and one number of the inverse inertia.
const BALL: u64 = SIDE - row::<Quat>() - 2 * row::<f32>();

/// Bytes of the pairs' own rows and of their bodies': all of a batch is read, and its impulses are written.
fn batches(lanes: &Lanes<Eight>) -> u64 {
    let each = |points: u32| match points {
        1 => of_pair::<1>(),
        2 => of_pair::<2>(),
        3 => of_pair::<3>(),
        _ => of_pair::<4>(),
    };
    let all = lanes.pairs.manifold.iter();
    let sides = |kind: u32| if kind == TWO_BALLS { BALL } else { SIDE };
    all.map(|manifold| each(manifold.points) + 2 * sides(manifold.kind))
        .sum()
}

const fn of_pair<const P: usize>() -> u64 {
    lane::<Batch<Eight, P>>() + lane::<Impulses<Eight, P>>() + lane::<[Eight; P]>()
}

/// Whether two runs have the same bodies, in every bit.
pub fn same_bits(one: &Bodies, other: &Bodies) -> bool {
    one.place == other.place
        && one.motion == other.motion
        && one.spin == other.spin
        && one.attitude == other.attitude
}
