//! What the balls' driver does with a scene, in words.

use std::fmt::Write as _;

use super::Balls;

/// Passes, columns, and bytes a body.
#[must_use]
pub fn explain(balls: &Balls) -> String {
    let mut text = String::new();
    let ([x, y, z], edge) = balls.grid();
    let _ = writeln!(
        text,
        "balls only: a ball is a row, solves all of its contacts and writes itself; {} invocation(s) a ball",
        balls.kernels().team()
    );
    let _ = writeln!(text, "grid: cells of {edge:.3} m in {x} × {y} × {z} slots");
    let _ = writeln!(
        text,
        "passes of a step: {}",
        balls.kernels().names().join(", ")
    );
    if let Some((first, rows)) = balls.not_finite() {
        let _ = writeln!(
            text,
            "body {first} is not finite; it stands aside and the rest goes on ({rows} rows in all steps)"
        );
    }
    let _ = writeln!(
        text,
        "room: {} balls with {} neighbours each; more was made {} time(s)",
        balls.rows(),
        balls.room(),
        balls.grown()
    );
    if balls.fast() > 0 {
        let _ = writeln!(
            text,
            "{} row(s) in all steps moved farther than the grid looks",
            balls.fast()
        );
    }
    let columns = balls.columns();
    let bytes = columns.bytes() as usize / balls.rows().max(1);
    let _ = writeln!(
        text,
        "columns: {bytes} bytes a ball, room for {} neighbours each among them",
        balls.room()
    );
    for info in columns.list() {
        let _ = writeln!(
            text,
            "  {:<22} {:>8} × {:>3} B  {}",
            info.name, info.capacity, info.row_bytes, info.row
        );
    }
    text
}
