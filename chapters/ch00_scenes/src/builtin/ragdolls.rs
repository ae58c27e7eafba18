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
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::{Penetration, escaped, joint_separation, limit_excess};

    fn reference() -> Scene {
        let text = include_str!("../../../../tests/reference/scenes/ragdolls_5.json");
        Scene::from_json(text, "ragdolls_5.json").unwrap()
    }

    #[test]
    fn five_ragdolls_have_the_shapes_and_masses_of_the_reference() {
        let (ours, theirs) = (build(5, 1), reference());
        assert_eq!(ours.bodies.len(), theirs.bodies.len());
        for (i, (a, b)) in ours.bodies.iter().zip(&theirs.bodies).enumerate() {
            // The file's masses are rounded to 1e-6.
            assert!((a.mass - b.mass).abs() < 1e-6, "body {i}: {}", a.mass);
            assert_eq!((a.restitution, a.friction), (b.restitution, b.friction));
            if i >= FIRST {
                assert_eq!(a.shape, b.shape, "body {i}");
            }
        }
    }

    #[test]
    fn five_ragdolls_have_the_joints_of_the_reference() {
        assert_eq!(build(5, 1).joints, reference().joints);
    }

    #[test]
    fn the_box_of_five_ragdolls_is_that_of_the_reference() {
        let (ours, theirs) = (build(5, 1), reference());
        for (a, b) in ours.bodies[..FIRST].iter().zip(&theirs.bodies) {
            let (Shape::Box { half_extents: c }, Shape::Box { half_extents: d }) =
                (a.shape, b.shape)
            else {
                panic!("the first five bodies are the box");
            };
            assert!((c - d).abs().max_element() < 1e-12, "{c} {d}");
            assert!(a.position.distance(b.position) < 1e-12);
        }
        assert_eq!(
            ours.meta_pair("inner_half_extents"),
            theirs.meta_pair("inner_half_extents")
        );
        let height = ours.meta["wall_height"].as_f64().unwrap();
        assert!((height - 13.35).abs() < 1e-12, "{height}");
    }

    /// Where the bones of a ragdoll are, seen from its hips.
    fn as_seen_from_hips(scene: &Scene, ragdoll: usize) -> Vec<DVec3> {
        let hips = &scene.bodies[body(ragdoll, HIPS)];
        (0..BONES.len())
            .map(|bone| {
                let there = scene.bodies[body(ragdoll, bone)].position;
                hips.orientation.conjugate() * (there - hips.position)
            })
            .collect()
    }

    #[test]
    fn every_ragdoll_of_the_reference_is_put_together_as_ours() {
        let ours = as_seen_from_hips(&build(1, 1), 0);
        for ragdoll in 0..5 {
            for (a, b) in ours.iter().zip(as_seen_from_hips(&reference(), ragdoll)) {
                // The file is rounded to 1e-6.
                assert!(a.distance(b) < 4e-6, "{a} {b}");
            }
        }
    }

    /// The point that a ragdoll is turned about, from where its hips are.
    fn pivot(scene: &Scene, ragdoll: usize) -> DVec3 {
        let hips = &scene.bodies[body(ragdoll, HIPS)];
        hips.position - hips.orientation * DVec3::Y * HIPS_ABOVE_PIVOT
    }

    #[test]
    fn ragdolls_hang_above_one_another_where_the_reference_has_them() {
        let (ours, theirs) = (build(5, 1), reference());
        for ragdoll in 0..5 {
            let (a, b) = (pivot(&ours, ragdoll), pivot(&theirs, ragdoll));
            assert!(a.distance(DVec3::Y * (1.52 + 2.15 * ragdoll as f64)) < 1e-14);
            assert!(a.distance(b) < 2e-6, "{a} {b}");
        }
    }

    #[test]
    fn turns_tilts_and_speeds_are_as_large_as_in_the_reference() {
        for scene in [reference(), build(1000, 1)] {
            for bones in scene.bodies[FIRST..].chunks_exact(BONES.len()) {
                let upright = (bones[HIPS].orientation * DVec3::Y).angle_between(DVec3::Y);
                assert!(upright < 0.15, "{upright}");
                let velocity = bones[HIPS].linear_velocity;
                assert!(velocity.abs().max_element() <= 0.5, "{velocity}");
            }
        }
    }

    #[test]
    fn ragdolls_start_in_one_piece_within_their_limits_and_touch_nothing() {
        for count in [0, 1, 8, 80, 200, 1000] {
            let scene = build(count, 3);
            let start = State::start_of(&scene);
            let touching = Penetration::of(&scene, &start).pairs_touching;
            assert_eq!(touching, 0, "{count} ragdolls");
            assert_eq!(escaped(&scene, &start), Some(0));
            assert!(joint_separation(&scene, &start).unwrap_or(0.0) < 1e-14);
            assert!(limit_excess(&scene, &start).unwrap_or(0.0) < 1e-14);
        }
    }

    #[test]
    fn no_ragdolls_make_an_empty_box() {
        let scene = build(0, 1);
        assert_eq!((scene.bodies.len(), scene.joints.len()), (5, 0));
    }

    #[test]
    fn up_to_twenty_stand_in_one_stack_and_no_stack_is_higher() {
        let widths = [20, 21, 80, 81, 200, 1000].map(stacks_a_side);
        assert_eq!(widths, [1, 2, 2, 3, 4, 8]);
        for count in [20, 200, 1000] {
            let highest = build(count, 1)
                .bodies
                .iter()
                .skip(FIRST)
                .fold(0.0, |y, b| b.position.y.max(y));
            assert!(highest < 0.6 + 20.0 * 2.15, "{highest}");
        }
    }

    #[test]
    fn a_bones_joint_leads_from_its_parent_to_it() {
        let scene = build(3, 1);
        for ragdoll in 0..3 {
            for (bone, parent) in PARENTS.into_iter().enumerate().skip(1) {
                let ends = scene.joints[joint(ragdoll, bone)].bodies();
                let parent = parent.expect("only the hips have no parent");
                assert_eq!(ends, (body(ragdoll, parent), body(ragdoll, bone)));
            }
        }
    }

    #[test]
    fn left_is_at_positive_x_and_the_head_on_top() {
        let centres = centres();
        for (name, centre) in BONES.iter().zip(centres) {
            let side = if name.starts_with("left") {
                1.0
            } else if name.starts_with("right") {
                -1.0
            } else {
                0.0
            };
            assert_eq!(
                centre.x.signum() * f64::from(centre.x != 0.0),
                side,
                "{name}"
            );
        }
        assert!((centres[3].y + 0.13 - (1.83 - PIVOT)).abs() < 1e-15);
    }

    #[test]
    fn the_same_seed_gives_the_same_ragdolls_and_another_seed_others() {
        assert_eq!(build(2, 5), build(2, 5));
        assert_ne!(build(2, 5).bodies, build(2, 6).bodies);
    }
}
