//! Which part each column belongs to. A column is allocated if the plan has all of its parts.

use super::Part::{
    self, Axes, Bouncing, Collisions, Corrected, FixedPoints, Forces, Friction, Joints, Limits,
    Mouse, Orientations, Resolution, Rods, Round, Turning,
};

// ANCHOR: needs_of
/// The parts without which nobody reads a column.
#[must_use]
pub fn needs_of(table: &str, column: &str) -> &'static [Part] {
    match (table, column) {
        ("bodies", column) => needs_of_bodies(column),
        ("touches", _) => &[Collisions, Corrected],
        ("motions", "velocity" | "shift" | "changed") => &[Resolution, Corrected],
        ("motions", "inverse_inertia") => &[Resolution, Turning, Axes],
        ("motions", "inverse_moment") => &[Resolution, Corrected, Round],
        ("motions", _) => &[Resolution, Turning, Corrected],
        ("contacts", column) => needs_of_contacts(column),
        ("joints", "arm_parent" | "arm_child" | "seen" | "off") | ("pins" | "trees", _) => {
            &[Joints, Corrected]
        }
        ("joints", _) => &[Joints],
        ("rods", "length") => &[Rods],
        ("rods", _) => &[Rods, Corrected],
        ("limits", _) => &[Limits],
        ("turns", _) => &[Limits, Corrected],
        ("poles" | "pushes", _) => &[Forces],
        ("fixed_points", _) => &[FixedPoints],
        ("springs", _) => &[Mouse],
        _ => &[],
    }
}
// ANCHOR_END: needs_of

fn needs_of_bodies(column: &str) -> &'static [Part] {
    match column {
        "orientation" => &[Orientations],
        "last_orientation" | "inertia" | "inverse_inertia" => &[Turning],
        "shape" | "size" => &[Collisions],
        "restitution" => &[Bouncing],
        "friction" | "static_friction" => &[Friction],
        "acceleration" | "torque" => &[Forces],
        "held_velocity" => &[Resolution, Corrected],
        "held_spin" => &[Resolution, Turning, Corrected],
        _ => &[],
    }
}

fn needs_of_contacts(column: &str) -> &'static [Part] {
    match column {
        "a" | "b" | "feature" | "normal" | "depth" | "point" => &[Collisions],
        "impact" => &[Collisions, Bouncing],
        "restitution" => &[Collisions, Corrected, Bouncing],
        "rub" | "response_across" | "friction" | "static_friction" => &[Collisions, Friction],
        _ => &[Collisions, Corrected],
    }
}
