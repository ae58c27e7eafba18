//! The step: all systems in order, which columns each reads and writes, and without which parts of the
//! plan it has nothing to do.

use super::Part::{
    self, Bouncing, Collisions, Corrected, FixedPoints, Forces, Joints, Printed, Resolution,
    Turning,
};
use crate::world::World;

/// A system: a part of a step.
pub struct System {
    /// As the overlay's times call it.
    pub name: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// It runs if the plan has all of these.
    pub needs: &'static [Part],
    /// Columns that it reads and doesn't write: `table.column`, `table.{some, columns}` or `table.*`.
    pub reads: &'static [&'static str],
    /// Columns that it writes.
    pub writes: &'static [&'static str],
    /// Whether it also runs once before the first step.
    pub also_at_start: bool,
    /// What it does.
    pub run: fn(&mut World),
}

const IN_A_STEP: bool = false;
const ALSO_AT_START: bool = true;

/// What the narrow phase finds.
const FOUND: &str = "contacts.{a, b, feature, normal, depth, point}";
/// What stays the same while contacts are resolved.
const PREPARED: &str = "contacts.{arm_a, arm_b, excess, gap_speed, closing, slowest_impact, response, \
    response_across, restitution, friction, static_friction}";
/// Who is joined.
const JOINTS: &str =
    "joints.{parent, child, scene_joint, kind, part, limit, anchor_parent, anchor_child}";
/// Where joints take hold.
const ARMS: &str = "joints.{arm_parent, arm_child}";
const LIMITS: &str = "limits.*";
const TURNS: &str = "turns.*";
const POLES: &str = "poles.*";
const PUSHES: &str = "pushes.*";
const HELD: &str = "fixed_points.*";
const SPRINGS: &str = "springs.*";

/// One line of the list.
macro_rules! system {
    ($name:literal, $about:literal, $when:expr, $needs:expr, $run:path,
     reads $reads:expr, writes $writes:expr) => {
        System {
            name: $name,
            about: $about,
            needs: &$needs,
            reads: &$reads,
            writes: &$writes,
            also_at_start: $when,
            run: $run,
        }
    };
}

// ANCHOR: first
/// All systems, in the order of a step.
pub const SYSTEMS: &[System] = &[
    system!("advance positions", "p by velocity-less Verlet", IN_A_STEP, [],
        World::advance_positions,
        reads ["bodies.inverse_mass", "bodies.acceleration"],
        writes ["bodies.position", "bodies.last_position", "bodies.held_velocity", "bodies.held_spin"]),
    system!("advance orientations", "q by the free turn of the angular momentum", IN_A_STEP, [Turning],
        World::advance_orientations,
        reads ["bodies.inverse_mass", "bodies.inertia", "bodies.inverse_inertia", "bodies.torque"],
        writes ["bodies.orientation", "bodies.last_orientation"]),
    // ANCHOR_END: first
    system!("hold fixed points", "p from q", IN_A_STEP, [FixedPoints],
        World::place_held,
        reads ["fixed_points.body", "fixed_points.point", "fixed_points.arm",
            "bodies.orientation", "bodies.last_orientation"],
        writes ["bodies.position", "bodies.last_position"]),
    system!("correct joints", "the report's constraint update", IN_A_STEP, [Joints],
        World::correct_joints,
        reads [JOINTS, "trees.first", "trees.end", "pins.left", "rods.length", "rods.left", LIMITS,
            "turns.left", "bodies.inverse_mass", "bodies.inverse_inertia"],
        writes ["bodies.position", "bodies.orientation", "motions.{inverse_inertia, changed}", ARMS,
            "joints.seen", "pins.yielding", "rods.along", "rods.response"]),
    system!("gather forces", "magnets, fixed points, constant forces and the mouse, and gravity", IN_A_STEP, [Forces],
        World::gather,
        reads ["bodies.position", "bodies.orientation", "bodies.inverse_mass", POLES, HELD, PUSHES, SPRINGS],
        writes ["bodies.acceleration", "bodies.torque"]),
    system!("broad phase", "boxes in a KD-tree, and the pairs that overlap", ALSO_AT_START, [Collisions],
        World::broad_phase,
        reads ["bodies.position", "bodies.last_position", "bodies.orientation", "bodies.last_orientation",
            "bodies.shape", "bodies.size", "bodies.inverse_mass", "bodies.restitution"],
        writes []),
    system!("narrow phase", "where the pairs touch", ALSO_AT_START, [Collisions],
        World::narrow_phase,
        reads ["bodies.position", "bodies.last_position", "bodies.orientation", "bodies.last_orientation",
            "bodies.shape", "bodies.size", "bodies.inverse_mass", "bodies.restitution"],
        writes [FOUND, "contacts.support", "contacts.rub"]),
    system!("resolve as printed", "every contact once", IN_A_STEP, [Printed, Collisions],
        World::resolve_printed,
        reads [FOUND, "bodies.inverse_mass", "bodies.inverse_inertia", "bodies.restitution"],
        writes ["bodies.position", "bodies.last_position", "bodies.orientation",
            "bodies.last_orientation", "contacts.impact"]),
    system!(
        "list touches",
        "contacts of the same two bodies together",
        ALSO_AT_START,
        [Corrected, Collisions],
        World::list_touches,
        reads["contacts.{a, b}"],
        writes["touches.*"]
    ),
    system!("read velocities", "of the bodies that touch or are joined", ALSO_AT_START,
        [Corrected, Resolution], World::read_velocities,
        reads ["bodies.position", "bodies.last_position", "bodies.orientation", "bodies.last_orientation",
            "bodies.inverse_mass", "bodies.inertia", "bodies.inverse_inertia", "bodies.acceleration",
            "bodies.torque", "bodies.held_velocity", "bodies.held_spin", HELD],
        writes ["motions.velocity", "motions.spin", "motions.shift", "motions.turn",
            "motions.{inverse_inertia, inverse_moment}"]),
    system!("prepare contacts", "what stays the same during all sweeps", ALSO_AT_START,
        [Corrected, Collisions], World::prepare_contacts,
        reads [FOUND, "bodies.position", "bodies.shape", "bodies.inverse_mass", "bodies.restitution",
            "bodies.friction", "bodies.static_friction", "bodies.acceleration", "motions.velocity",
            "motions.spin", "motions.{inverse_inertia, inverse_moment}"],
        writes [PREPARED, "contacts.support", "contacts.rub"]),
    system!("prepare joints", "the same for joints", ALSO_AT_START, [Corrected, Joints],
        World::prepare_joints,
        reads [JOINTS, LIMITS, "bodies.position", "bodies.orientation", "bodies.last_position",
            "bodies.last_orientation", "motions.{inverse_inertia, inverse_moment}"],
        writes [ARMS, "pins.yielding", "pins.parted", "pins.impulse", "rods.along", "rods.response",
            "rods.parted", "rods.impulse", TURNS]),
    system!("push apart", "nudges until none overlap", ALSO_AT_START, [Corrected, Resolution],
        World::push_apart,
        reads [FOUND, PREPARED, JOINTS, ARMS, LIMITS, "pins.yielding", "rods.length", "bodies.position",
            "bodies.orientation"],
        writes ["contacts.pushed", "turns.nudged", "motions.{shift, turn, changed}", "touches.seen",
            "joints.{seen, off}"]),
    system!("pay for lifts", "what is lifted pays with speed", ALSO_AT_START,
        [Corrected, Collisions, Bouncing], World::pay_for_lifts,
        reads [FOUND, PREPARED, "contacts.pushed", "bodies.inverse_mass"],
        writes ["motions.velocity"]),
    system!("bounce", "impacts, until nobody approaches fast", ALSO_AT_START,
        [Corrected, Collisions, Bouncing], World::bounce,
        reads [FOUND, PREPARED, "contacts.pushed", "bodies.inverse_mass", "motions.{inverse_inertia, inverse_moment}"],
        writes ["motions.{velocity, spin, changed}", "contacts.impact", "touches.seen"]),
    system!("rest", "supports, friction and joints, until nothing changes", ALSO_AT_START,
        [Corrected, Resolution], World::rest,
        reads [FOUND, PREPARED, JOINTS, ARMS, "pins.yielding", "pins.parted", "rods.along",
            "rods.response", "rods.parted", TURNS, "bodies.inverse_mass", "bodies.inertia",
            "bodies.orientation", "bodies.acceleration", "bodies.torque", "motions.{inverse_inertia, inverse_moment}"],
        writes ["motions.{velocity, spin, spin_kick, changed}", "touches.seen", "joints.seen",
            "bodies.held_velocity", "bodies.held_spin", "contacts.support", "contacts.rub", "pins.impulse", "rods.impulse",
            "turns.impulse"]),
    system!("place bodies", "nudges into p and q, velocities into p* and q*", ALSO_AT_START,
        [Corrected, Resolution], World::place_bodies,
        reads ["motions.velocity", "motions.spin", "motions.shift", "motions.turn", "motions.spin_kick",
            "bodies.inverse_mass", "bodies.inertia", "bodies.inverse_inertia", "bodies.acceleration",
            "bodies.torque", HELD],
        writes ["bodies.position", "bodies.last_position", "bodies.orientation",
            "bodies.last_orientation", "bodies.held_velocity", "bodies.held_spin"]),
    system!("finish joints", "how far they are off", ALSO_AT_START, [Corrected, Joints],
        World::finish_joints,
        reads [JOINTS, LIMITS, "rods.length", "bodies.position", "bodies.orientation"],
        writes [ARMS, "pins.left", "rods.left", "turns.left"]),
];

impl System {
    /// The columns that it reads or writes, by table and name.
    pub fn columns(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.reads
            .iter()
            .chain(self.writes)
            .flat_map(|names| expand(names))
    }
}

/// The columns that a pattern names; `*` stands for itself.
pub(super) fn expand(names: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let (table, columns) = names.split_once('.').expect("a table and a dot");
    let columns = columns.trim_matches(['{', '}']).split(", ");
    columns.map(move |column| (table, column))
}
