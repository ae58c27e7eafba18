//! The stacked ragdolls of the report's Table 2: people of twelve capsules that fall upright
//! into an open-lidded box, e = 0, μ = 0.5. Report 9.1 and 10.2.
//!
//! A ragdoll is a tree whose root is the hips; each other bone hangs from its parent by a
//! ball joint with a cone and a twist. Its density is that of a body, 985 kg/m³, which makes
//! 62.6 kg; it is 1.83 m tall. Bones that a joint connects don't collide, all others do.
//!
//! They start above one another, the soles of the lowest at 0.6 m, the others 2.15 m above
//! each other, every one turned and slightly tilted about a point in its waist. More than
//! twenty would fall from higher than is of any use (200 of them from 430 m), so they share
//! out among n × n such stacks, of at most twenty each, and the box is n times as wide.
//!
//! Drag is that of the report's demos. Nothing else brakes an arm that hangs from a joint free of
//! friction: without drag some swing on for a minute.

use ch00_maths::f64::real::PI;
use glam::{DQuat, DVec3};

use super::parts::in_open_box;
use crate::random::SplitMix64;
use crate::{Body, Joint, Scene, Shape};

/// F of the report's demos, 1/s.
pub(super) const DRAG: f64 = 0.25;

/// The names of a ragdoll's bones, in the order of its bodies. Bone b of ragdoll r is body
/// [`body`]`(r, b)` of the scene.
pub const BONES: [&str; 12] = [
    "hips",
    "waist",
    "chest",
    "head",
    "left upper arm",
    "left forearm",
    "right upper arm",
    "right forearm",
    "left thigh",
    "left shin",
    "right thigh",
    "right shin",
];

/// The parent of each bone, as an index into [`BONES`]; the hips have none. The joint of bone
/// b > 0 of ragdoll r, from its parent (the joint's a) to it (b), is joint
/// [`joint`]`(r, b)` of the scene.
pub const PARENTS: [Option<usize>; 12] = [
    None,
    Some(HIPS),
    Some(WAIST),
    Some(CHEST),
    Some(CHEST),
    Some(4),
    Some(CHEST),
    Some(6),
    Some(HIPS),
    Some(8),
    Some(HIPS),
    Some(10),
];

/// Bodies before the first ragdoll: the box.
const FIRST: usize = 5;
const HIPS: usize = 0;
const WAIST: usize = 1;
const CHEST: usize = 2;

/// Index in the scene of a bone's body.
#[must_use]
pub fn body(ragdoll: usize, bone: usize) -> usize {
    FIRST + BONES.len() * ragdoll + bone
}

/// Index in the scene of the joint between a bone, which is not the hips, and its parent.
#[must_use]
pub fn joint(ragdoll: usize, bone: usize) -> usize {
    (BONES.len() - 1) * ragdoll + bone - 1
}

/// Density of all bones, kg/m³.
const DENSITY: f64 = 985.0;

/// Radius and half of the straight part of each bone's capsule, m.
const CAPSULES: [[f64; 2]; 12] = [
    [0.11, 0.02],
    [0.1, 0.02],
    [0.14, 0.06],
    [0.09, 0.04],
    [0.05, 0.11],
    [0.045, 0.1],
    [0.05, 0.11],
    [0.045, 0.1],
    [0.07, 0.15],
    [0.055, 0.15],
    [0.07, 0.15],
    [0.055, 0.15],
];

/// The joint of a bone to its parent. All bones stand upright at rest.
struct Link {
    /// Where it is in the parent, x and y, m; z is 0.
    in_parent: [f64; 2],
    /// Where it is along the bone's y, m.
    along: f64,
    /// Largest angle between the bone and where it rests, rad.
    cone: f64,
    /// Largest turn about the bone either way, rad.
    twist: f64,
}

const fn link(in_parent: [f64; 2], along: f64, cone: f64, twist: f64) -> Link {
    Link {
        in_parent,
        along,
        cone,
        twist,
    }
}

/// The joints of the bones after the hips.
const LINKS: [Link; 11] = [
    link([0.0, 0.1], -0.09, 0.45, 0.35),
    link([0.0, 0.085], -0.165, 0.45, 0.35),
    link([0.0, 0.185], -0.115, 0.6, 0.8),
    link([0.27, 0.07], 0.11, 1.4, 0.8),
    link([0.0, -0.16], 0.145, 1.1, 0.3),
    link([-0.27, 0.07], 0.11, 1.4, 0.8),
    link([0.0, -0.16], 0.145, 1.1, 0.3),
    link([0.1, -0.11], 0.22, 1.0, 0.4),
    link([0.0, -0.22], 0.205, 1.1, 0.2),
    link([-0.1, -0.11], 0.22, 1.0, 0.4),
    link([0.0, -0.22], 0.205, 1.1, 0.2),
];

impl Link {
    fn in_parent(&self) -> DVec3 {
        DVec3::new(self.in_parent[0], self.in_parent[1], 0.0)
    }

    fn in_bone(&self) -> DVec3 {
        DVec3::Y * self.along
    }
}

/// What the ragdolls of a stack share: half of the box's width for one stack, between a
/// ragdoll and the next above, and heights above the soles, m.
pub(super) const INNER: f64 = 0.85;
pub(super) const SPACING: f64 = 2.15;
const LOWEST_SOLES: f64 = 0.6;
/// Of the point that a ragdoll is turned about, above its soles, and of the hips above that.
pub(super) const PIVOT: f64 = 0.92;
const HIPS_ABOVE_PIVOT: f64 = 0.04;
/// Ragdolls in a stack at most.
const HIGHEST_STACK: u64 = 20;

/// The scene with `count` ragdolls.
pub(super) fn build(count: u64, seed: u64) -> Scene {
    let stacks = stacks_a_side(count);
    let layers = count.div_ceil(stacks * stacks);
    let inner = INNER * stacks as f64;
    let wall_height = LOWEST_SOLES + SPACING * layers as f64 + 2.0;

    let mut scene = in_open_box("ragdolls", [inner, inner], wall_height, seed);
    scene.drag = DRAG;
    let mut random = SplitMix64::new(seed);
    for ragdoll in 0..count {
        let (layer, stack) = (ragdoll / (stacks * stacks), ragdoll % (stacks * stacks));
        let middle = |k: u64| INNER * (2.0 * k as f64 + 1.0) - inner;
        let pivot = DVec3::new(
            middle(stack % stacks),
            LOWEST_SOLES + PIVOT + SPACING * layer as f64,
            middle(stack / stacks),
        );
        add_ragdoll(&mut scene, pivot, &mut random);
    }
    scene
}

/// The least n for which n × n stacks of at most twenty hold `count` ragdolls.
fn stacks_a_side(count: u64) -> u64 {
    let stacks = count.div_ceil(HIGHEST_STACK).max(1);
    let side = stacks.isqrt();
    side + u64::from(side * side < stacks)
}

/// A ragdoll at rest in itself, upright but for a random turn about the vertical (any), a
/// tilt about x and z (±0.1 rad each) before it, and a velocity (±0.5 m/s a component),
/// drawn in this order.
pub(super) fn add_ragdoll(scene: &mut Scene, pivot: DVec3, random: &mut SplitMix64) {
    let turn = DQuat::from_rotation_y(random.between(0.0, 2.0 * PI));
    let tilt_x = random.between(-0.1, 0.1);
    let tilt_z = random.between(-0.1, 0.1);
    let orientation = turn * DQuat::from_rotation_x(tilt_x) * DQuat::from_rotation_z(tilt_z);
    let linear_velocity = random.vector(0.5);
    let hips = scene.bodies.len();
    for (centre, [radius, half_height]) in centres().into_iter().zip(CAPSULES) {
        let shape = Shape::Capsule {
            radius,
            half_height,
        };
        let mass = DENSITY * shape.volume();
        scene.bodies.push(Body {
            orientation,
            linear_velocity,
            ..Body::new(shape, mass, pivot + orientation * centre)
        });
    }
    scene
        .joints
        .extend(bonds().map(|(parent, bone, link)| Joint::Ball {
            a: hips + parent,
            b: hips + bone,
            anchor_a: link.in_parent(),
            anchor_b: link.in_bone(),
            cone: Some(link.cone),
            twist: Some([-link.twist, link.twist]),
            limits: None,
            rest: None,
        }));
}

/// Parent, bone and joint of each bone after the hips.
fn bonds() -> impl Iterator<Item = (usize, usize, &'static Link)> {
    let bones = PARENTS.into_iter().enumerate();
    let after_hips = bones.filter_map(|(bone, parent)| Some((parent?, bone)));
    after_hips
        .zip(&LINKS)
        .map(|((parent, bone), link)| (parent, bone, link))
}

/// The bones' centres from the point that the ragdoll is turned about, as it stands, m.
fn centres() -> [DVec3; 12] {
    let mut centres = [DVec3::Y * HIPS_ABOVE_PIVOT; 12];
    for (parent, bone, link) in bonds() {
        centres[bone] = centres[parent] + link.in_parent() - link.in_bone();
    }
    centres
}

#[cfg(test)]
mod tests;
