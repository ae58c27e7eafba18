//! What engine `lanes` does with a scene, in words.

use std::fmt::Write as _;

use ch00_scenes::Scene;

use super::Lanes;
use super::broad_phase::{BroadPhase, UNEQUAL, Way};
use super::sleep::{DISTANCE, TIME};
use crate::rows::{Held, Impulse, Manifold, Material, Motion, Place, Press, Push, Solid, Spin};
use crate::rules::Method;
use crate::simd::{Real, Widest};

/// Passes, substeps, grid, and bytes a row.
#[must_use]
pub fn explain(scene: &Scene, lanes: &Lanes) -> String {
    let mut text = String::new();
    let moving = scene.dynamic_count();
    let _ = writeln!(
        text,
        "scene `{}` by {} on the CPU, {} at a time on {} thread(s): {moving} bodies that move, {} that don't, {} joints; {} substeps a step",
        scene.name,
        match lanes.rules.method {
            Method::OwnRow => "own rows",
            Method::Coloured => "colours",
        },
        Widest::LANES,
        lanes.threads.count(),
        scene.bodies.len() - moving,
        scene.joints.len(),
        lanes.rules.substeps
    );
    if lanes.rules.method == Method::Coloured {
        text += &explain_colours(lanes);
    }
    text += &explain_plan(lanes);
    text += &explain_broad_phase(&lanes.broad);
    if lanes.rules.sleeping {
        let _ = writeln!(
            text,
            "islands of bodies that come no farther than {} mm in {} s sleep until something touches them: {} bodies now, in {} islands",
            1e3 * DISTANCE,
            TIME,
            lanes.sleep.asleep(),
            lanes.sleep.islands()
        );
    }
    let body = size_of::<Place>()
        + size_of::<glam::Quat>()
        + size_of::<Motion>()
        + size_of::<Spin>()
        + size_of::<Solid>()
        + size_of::<Material>()
        + size_of::<Held>()
        + size_of::<Push>();
    let pair = size_of::<Manifold>()
        + size_of::<Material>()
        + size_of::<Impulse>()
        + 16
        + size_of::<Press>();
    let _ = writeln!(text, "{body} bytes a body, {pair} bytes a pair");
    text
}

/// What the colours of the last step are.
fn explain_colours(lanes: &Lanes) -> String {
    let way = if lanes.rules.back {
        "forth and back in each substep, so that bodies with several contact points come to rest"
    } else {
        "forth in each substep: balls come to rest without a way back"
    };
    format!(
        "{} colour(s) for {} pairs, gone through {way}; {} contacts have no colour and are solved one by one\n",
        lanes.pairs.colours(),
        lanes.pairs.bodies.len(),
        lanes.pairs.without_colour()
    )
}

/// What is left out where nothing needs it.
fn explain_plan(lanes: &Lanes) -> String {
    let [rough, smooth] = lanes.pairs.counts();
    let all = |sets: &[usize]| sets.iter().sum::<usize>();
    let joints = if lanes.is_plain() {
        "no joint, nothing pulls but gravity: bodies move in one pass a substep"
    } else {
        "joints or forces: bodies move in several passes a substep"
    };
    let batches = all(&rough) + all(&smooth);
    let mut text = joints.to_owned() + "\n";
    if batches > 0 {
        let _ = writeln!(
            text,
            "of {batches} batches of pairs {} leave out friction, {} what shapes other than balls need, {} all points but the first",
            all(&smooth),
            all(&rough[..2]) + all(&smooth[..2]),
            all(&rough[..3]) + all(&smooth[..3]),
        );
    }
    text
}

/// How it is found who may touch, and why so.
fn explain_broad_phase(broad: &BroadPhase) -> String {
    let mut text = String::new();
    let steps = broad.rebuilds + broad.reuses;
    let (way, spread, chosen) = broad.way();
    let large = broad.large().len();
    let why = if chosen {
        format!(
            "of ten boxes the widest is {spread:.1} times as wide as the narrowest, and from {UNEQUAL} on a tree is the quicker one (--example broad_phases)"
        )
    } else {
        "since it was told to".to_owned()
    };
    match way {
        Way::Grids => {
            for (edge, bodies) in broad.grids() {
                let _ = writeln!(text, "grid: cells of {edge:.3} m for {bodies} bodies");
            }
            let _ = writeln!(text, "broad phase: grids by size: {why}");
        }
        Way::Tree => {
            let (bodies, leaves) = broad.tree();
            if steps > 0 {
                let _ = writeln!(text, "tree: {leaves} leaves for {bodies} bodies");
            }
            let _ = writeln!(text, "broad phase: a bounding volume hierarchy: {why}");
        }
    }
    if steps == 0 {
        return text;
    }
    let _ = writeln!(text, "{large} bodies on the short list of large ones");
    let _ = writeln!(
        text,
        "in {} of {steps} steps all were sorted anew; in the others only those who had left their boxes were looked for",
        broad.rebuilds
    );
    text
}
