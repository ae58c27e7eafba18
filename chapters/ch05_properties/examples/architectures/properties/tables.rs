//! The tables, and all their properties.

use ch05_properties::table;
use glam::{Quat, Vec3};

/// The parent of a thing that has none.
pub const ROOT: u32 = u32::MAX;

// ANCHOR: tables
table! {
    /// Where everything is; each thing after its parent.
    pub struct Things of
    /// A thing.
    Thing in "things" {
        /// Row of the thing in whose frame it is.
        parent: u32, "i_1", "";
        /// Where it is in its parent.
        local_position: Vec3, "p_2", "m";
        /// How it is turned in its parent.
        local_orientation: Quat, "q_2", "";
        /// Where it is in the world.
        position: Vec3, "p", "m", editable;
        /// How it is turned in the world.
        orientation: Quat, "q", "", editable;
    }
}

table! {
    /// The circles on which things travel.
    pub struct Circles of
    /// A circle.
    Circle in "circles" {
        /// Row of the thing that travels.
        thing: u32, "i", "";
        /// From the parent.
        radius: f32, "r", "m";
        /// Along the circle.
        angle: f32, "φ", "rad";
        /// Of travelling.
        rate: f32, "φ'", "rad/s";
    }
}
// ANCHOR_END: tables

// ANCHOR: spinning
table! {
    /// What turns on its own axis.
    pub struct Spins of
    /// A spin.
    Spin in "spins" {
        /// Row of the thing that turns.
        thing: u32, "i", "";
        /// By how much it is turned.
        angle: f32, "θ", "rad";
        /// Of turning.
        rate: f32, "θ'", "rad/s";
        // ANCHOR: glow
        /// Brightness.
        glow: f32, "g", "rad/s";
        // ANCHOR_END: glow
    }
}
// ANCHOR_END: spinning
