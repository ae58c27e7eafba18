//! Step 5, a container: the same columns, stated once for the `table!` macro.

use std::fmt::Write;

use ch05_properties::columns::{AnyTable, Table};
use ch05_properties::table;
use glam::{Quat, Vec3};

use crate::ball::{Ball, above_floor, fly, properties};
use crate::world::{Span, World};

// ANCHOR: table
table! {
    /// Balls that fly and bounce.
    pub struct Balls of
    /// All properties of a ball.
    Row in "balls" {
        /// Where its centre is.
        position: Vec3, "p", "m", editable;
        /// Where its centre was a step ago.
        last_position: Vec3, "p*", "m";
        /// How it is turned.
        orientation: Quat, "q", "";
        /// How it was turned a step ago.
        last_orientation: Quat, "q*", "";
        /// What it weighs.
        mass: f32, "m", "kg";
        /// Its principal moments.
        inertia: Vec3, "I", "kg m²";
        /// Of its sphere.
        radius: f32, "r", "m";
        /// 0 stays, 1 bounces for ever.
        restitution: f32, "e", "", editable;
        /// Before it slides.
        static_friction: f32, "μ_s", "";
        /// While it slides.
        friction: f32, "μ_k", "";
        /// Red, green and blue.
        colour: Vec3, "rgb", "", editable;
    }
}

/// All there is.
#[derive(Default)]
pub struct Data {
    pub balls: Balls,
}
// ANCHOR_END: table

impl Data {
    pub fn new(balls: &[Ball]) -> Self {
        let mut data = Self::default();
        for ball in balls {
            data.balls.push(properties!(Row of ball));
        }
        data
    }
}

impl World for Data {
    // ANCHOR: integrate
    fn integrate(&mut self, dt: f32) {
        let balls = &mut self.balls;
        for (p, p_last) in balls.position.iter_mut().zip(&mut balls.last_position[..]) {
            (*p, *p_last) = fly(*p, *p_last, dt);
        }
    }
    // ANCHOR_END: integrate

    fn bounce(&mut self, dt: f32) {
        let balls = &mut self.balls;
        let places = balls.position.iter_mut().zip(&mut balls.last_position[..]);
        let surfaces = balls.radius.iter().zip(&balls.restitution[..]);
        for ((p, p_last), (radius, restitution)) in places.zip(surfaces) {
            (*p, *p_last) = above_floor(*p, *p_last, *radius, *restitution, dt);
        }
    }

    fn ball(&self, number: usize) -> Ball {
        let row = self.balls.row(number).expect("a row a ball");
        properties!(Ball of row)
    }

    fn bytes(&self) -> usize {
        self.balls.row_bytes()
    }

    fn visits(&self, number: usize) -> Vec<Span> {
        let balls = &self.balls;
        Span::of_places(&balls.position[number], &balls.last_position[number])
    }
}

// ANCHOR: schema
/// What the table says of itself, a line a column.
pub fn schema(table: &dyn AnyTable) -> String {
    let mut text = format!("{}: {}\n", table.name(), table.about());
    for spec in table.specs() {
        let (name, symbol, unit, about) = (spec.name, spec.symbol, spec.unit, spec.about);
        let (kind, bytes) = (format!("{:?}", spec.kind), spec.kind.size());
        let _ = writeln!(
            text,
            "  {name:16} {symbol:4} {unit:6} {kind:10} {bytes:2} bytes  {about}"
        );
    }
    text
}
// ANCHOR_END: schema

/// The schema of this step's table.
pub fn story() -> String {
    schema(&Balls::default())
}
