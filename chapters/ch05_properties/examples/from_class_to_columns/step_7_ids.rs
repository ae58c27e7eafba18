//! Step 7, IDs: balls are removed while someone holds the number of a row and the ID of a ball.

use std::fmt::Write;

use ch05_properties::columns::{AnyTable, RowId, Table};

use crate::ball::{Ball, balls, properties};
use crate::step_1_class;
use crate::step_6_systems::{Data, Row};
use crate::world::{Span, World};
use crate::{COMPARED, DT, FRAMES};

/// The container and the systems of step 6, and balls that may go.
pub struct Level {
    data: Data,
}

impl Level {
    pub fn new(balls: &[Ball]) -> Self {
        Self {
            data: Data::new(balls),
        }
    }

    // ANCHOR: remove
    /// Takes balls out. All rows behind them move up, in all columns.
    fn remove(&mut self, gone: &[RowId]) {
        let ids = self.data.balls.ids();
        let mut keep = vec![true; ids.rows()];
        for row in gone.iter().filter_map(|&id| ids.row(id)) {
            keep[row] = false;
        }
        self.data.balls.retain_rows(&keep);
    }
    // ANCHOR_END: remove

    /// Where a ball is, if it is still there.
    fn row(&self, id: RowId) -> Option<usize> {
        self.data.balls.ids().row(id)
    }
}

impl World for Level {
    fn integrate(&mut self, dt: f32) {
        self.data.integrate(dt);
    }

    fn bounce(&mut self, dt: f32) {
        self.data.bounce(dt);
    }

    fn step(&mut self, dt: f32) {
        self.data.step(dt);
    }

    fn ball(&self, number: usize) -> Ball {
        let row = self.row(RowId::first(number as u32));
        self.data.ball(row.expect("nobody has removed it"))
    }

    fn bytes(&self) -> usize {
        self.data.bytes()
    }

    fn visits(&self, number: usize) -> Vec<Span> {
        self.data.visits(number)
    }
}

/// Removes three balls in mid-run, and then the one that is held.
pub fn story() -> String {
    let balls = balls(COMPARED, DT);
    let mut level = Level::new(&balls);
    let mut text = String::new();

    // ANCHOR: held
    let held_row = 500;
    let held = level.data.balls.ids().id(held_row).expect("it is there");
    for _ in 0..FRAMES / 2 {
        level.step(DT);
    }
    level.remove(&[3, 141, 271].map(RowId::first));
    // ANCHOR_END: held
    let ids = level.data.balls.ids();
    let stranger = ids.id(held_row).expect("there are enough");
    let row = ids.row(held).expect("it lives");
    let _ = writeln!(text, "balls 3, 141 and 271 are removed");
    let _ = writeln!(text, "  row {held_row} is of ball {stranger} now");
    let _ = writeln!(text, "  ball {held} is in row {row}");

    let mut objects = step_1_class::Level::new(&balls);
    for frame in 0..FRAMES {
        objects.step(DT);
        if frame >= FRAMES / 2 {
            level.step(DT);
        }
    }
    let ids = level.data.balls.ids();
    let lives = (0..ids.rows()).filter_map(|row| ids.id(row));
    let as_before = lives.filter(|id| {
        let number = id.slot as usize;
        level.ball(number) == objects.ball(number)
    });
    let (as_before, rows) = (as_before.count(), ids.rows());
    let _ = writeln!(text, "  {as_before} of {rows} are where step 1 has them");

    level.remove(&[held]);
    let new = level
        .data
        .balls
        .push(properties!(Row of balls[0], glow: 0.0));
    let says = |id| match level.row(id) {
        Some(row) => format!("in row {row}"),
        None => "nowhere".to_owned(),
    };
    let _ = writeln!(text, "ball {held} is removed, and a new one comes");
    let _ = writeln!(text, "  ball {held} is {}", says(held));
    let _ = writeln!(text, "  ball {new} is {}", says(new));
    text
}
