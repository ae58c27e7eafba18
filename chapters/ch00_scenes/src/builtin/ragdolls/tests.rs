use super::*;
use crate::State;
use crate::measures::{Penetration, escaped, joint_separation, limit_excess};

fn reference() -> Scene {
    let text = include_str!("../../../../../tests/reference/scenes/ragdolls_5.json");
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
        let (Shape::Box { half_extents: c }, Shape::Box { half_extents: d }) = (a.shape, b.shape)
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
