//! Step 6, systems: behaviour is free functions that name the columns which they read and write.
//! At last a property is added. What it takes stands between the marks named `glow`.

use std::fmt::Write;

use ch00_maths::f32::verlet;
use ch01_hierarchy::styles::cost;
use ch05_properties::columns::{AnyTable, Table};
use ch05_properties::table;
use glam::{Quat, Vec3};

use crate::DT;
use crate::ball::{Ball, above_floor, balls, fly, properties};
use crate::world::{Span, World};

table! {
    /// Balls that fly, bounce and glow.
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
        // ANCHOR: glow
        /// How bright it shines.
        glow: f32, "glow", "m/s";
        // ANCHOR_END: glow
    }
}

/// All there is.
#[derive(Default)]
pub struct Data {
    pub balls: Balls,
}

// ANCHOR: systems
/// A step, system by system.
pub fn step(data: &mut Data, dt: f32) {
    let balls = &mut data.balls;
    let (p, p_last) = (&mut balls.position, &mut balls.last_position);
    integrate(p, p_last, dt);
    bounce(p, p_last, &balls.radius, &balls.restitution, dt);
    // ANCHOR: glow
    shine(&mut balls.glow, p, p_last, dt);
    // ANCHOR_END: glow
}

/// Every ball flies.
fn integrate(position: &mut [Vec3], last_position: &mut [Vec3], dt: f32) {
    for (p, p_last) in position.iter_mut().zip(last_position) {
        (*p, *p_last) = fly(*p, *p_last, dt);
    }
}

/// What has sunk into the floor goes up again.
fn bounce(
    position: &mut [Vec3],
    last_position: &mut [Vec3],
    radius: &[f32],
    restitution: &[f32],
    dt: f32,
) {
    let surfaces = radius.iter().zip(restitution);
    let places = position.iter_mut().zip(last_position);
    for ((p, p_last), (radius, restitution)) in places.zip(surfaces) {
        (*p, *p_last) = above_floor(*p, *p_last, *radius, *restitution, dt);
    }
}
// ANCHOR_END: systems

// ANCHOR: shine
// ANCHOR: glow
/// The faster, the brighter.
fn shine(glow: &mut [f32], position: &[Vec3], last_position: &[Vec3], dt: f32) {
    for (glow, (p, p_last)) in glow.iter_mut().zip(position.iter().zip(last_position)) {
        *glow = verlet::velocity(*p, *p_last, dt).length();
    }
}
// ANCHOR_END: glow
// ANCHOR_END: shine

impl Data {
    pub fn new(balls: &[Ball]) -> Self {
        let mut data = Self::default();
        for ball in balls {
            // ANCHOR: glow
            data.balls.push(properties!(Row of ball, glow: 0.0));
            // ANCHOR_END: glow
        }
        data
    }
}

impl World for Data {
    fn integrate(&mut self, dt: f32) {
        integrate(&mut self.balls.position, &mut self.balls.last_position, dt);
    }

    fn bounce(&mut self, dt: f32) {
        let balls = &mut self.balls;
        let (p, p_last) = (&mut balls.position, &mut balls.last_position);
        bounce(p, p_last, &balls.radius, &balls.restitution, dt);
    }

    fn step(&mut self, dt: f32) {
        step(self, dt);
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

/// What the new property took, and that it works.
pub fn story() -> String {
    let cost = cost::marked([include_str!("step_6_systems.rs")], "glow", None);
    let mut data = Data::new(&balls(3, DT));
    let mut text = format!(
        "the property `glow`: {} lines in {} places of {} file\n",
        cost.lines, cost.places, cost.changed
    );
    for frame in 0..=60 {
        if frame % 30 == 0 {
            let _ = writeln!(text, "  step {frame:2}: glow {:.2?}", &data.balls.glow[..]);
        }
        step(&mut data, DT);
    }
    text
}
