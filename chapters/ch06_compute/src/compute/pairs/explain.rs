//! What the driver for pairs does with a scene, in words.

use std::fmt::Write as _;

use super::Pairs;

/// The names of the kinds of pairs.
const KINDS: [&str; 10] = [
    "ball–ball",
    "ball–box",
    "ball–capsule",
    "ball–cylinder",
    "box–box",
    "box–capsule",
    "box–cylinder",
    "capsule–capsule",
    "capsule–cylinder",
    "cylinder–cylinder",
];

/// Passes, columns, and bytes a body and a pair.
#[must_use]
pub fn explain(pairs: &Pairs) -> String {
    let mut text = String::new();
    let plan = pairs.plan();
    let kinds: Vec<_> = plan
        .kinds
        .iter()
        .map(|&kind| KINDS[kind as usize])
        .collect();
    let ([x, y, z], edge) = pairs.grid();
    let _ = writeln!(
        text,
        "a pair is a row and a body is a row: {}",
        kinds.join(", ")
    );
    let _ = writeln!(
        text,
        "grid: cells of {edge:.3} m in {x} × {y} × {z} slots; {} large bodies that move",
        plan.larges.len()
    );
    let _ = writeln!(text, "passes of a step: {}", pairs.passes().join(", "));
    if let Some((first, rows)) = pairs.not_finite() {
        let _ = writeln!(
            text,
            "body {first} is not finite; it stands aside and the rest goes on ({rows} rows in all steps)"
        );
    }
    let room = pairs.room();
    let _ = writeln!(
        text,
        "columns: {} bytes in all, room for {} partners a body and {} pairs",
        pairs.columns().bytes(),
        room.partners,
        room.pairs
    );
    let _ = writeln!(
        text,
        "needed, as it last came down: {} partners, {} pairs, {} pairs of large bodies of {}; room was made {} time(s)",
        pairs.says("NEEDED"),
        pairs.says("PAIRS_NEEDED"),
        pairs.says("LARGE_NEEDED"),
        room.large_pairs,
        pairs.grown()
    );
    for info in pairs.columns().list() {
        let _ = writeln!(
            text,
            "  {:<22} {:>8} × {:>3} B  {}",
            info.name, info.capacity, info.row_bytes, info.row
        );
    }
    text
}
