//! What the panel says of pairs that are apart, touch, and overlap, and that its drawings follow.

use ch00_maths::f32::shape::Shape;
use glam::Quat;

use super::*;

const CUBE: Shape = Shape::Box {
    half_extents: Vec3::splat(0.5),
};
const CAPSULE: Shape = Shape::Capsule {
    radius: 0.2,
    half_height: 0.5,
};
const BALL: Shape = Shape::Sphere { radius: 0.4 };
const CYLINDER: Shape = Shape::Cylinder {
    radius: 0.4,
    half_height: 0.5,
};

/// The two shapes, the first one this far above the second and turned a little.
fn above(one: &Shape, two: &Shape, height: f32, step: usize) -> Dissection {
    let p = Vec3::new(0.0, height, 0.0);
    let a = Placed {
        shape: one,
        p,
        q: Quat::from_rotation_z(0.3),
        p_before: p,
    };
    let b = Placed {
        shape: two,
        p: Vec3::ZERO,
        q: Quat::from_rotation_x(0.2),
        p_before: Vec3::ZERO,
    };
    dissect(&a, &b, step)
}

fn names(dissection: &Dissection) -> Vec<&'static str> {
    dissection.phases.iter().map(|phase| phase.name).collect()
}

/// The text of the last iteration of a phase.
fn end_of(one: &Shape, two: &Shape, height: f32, phase: &str) -> String {
    let all = above(one, two, height, 0);
    let mut step = 0;
    for next in &all.phases {
        step += next.steps;
        if next.name == phase {
            return above(one, two, height, step - 1).text;
        }
    }
    format!("no {phase} in {:?}", names(&all))
}

fn assert_says(text: &str, part: &str) {
    assert!(text.contains(part), "{text}");
}

#[test]
fn solids_that_are_apart_need_no_more_than_the_faces_and_gjk() {
    let end = above(&CUBE, &CUBE, 2.0, usize::MAX);
    assert_eq!(names(&end), ["Faces", "GJK", "Touch"]);
    let [low, high] = end.bounds[end.steps() - 2];
    assert!(low > 0.3 && high - low < 1e-4, "{low} … {high}");
    assert!(end.bounds[0][0] > 0.3 && end.bounds[0][0] <= high);
    assert_says(&above(&CUBE, &CUBE, 2.0, 0).text, "at least that far apart");
    assert_says(&end.text, "GJK decided");
    assert_says(&end.text, "the faces alone end it");
}

#[test]
fn a_corner_a_little_way_in_a_face_is_settled_by_the_skin() {
    let corner_down = Quat::from_rotation_arc(Vec3::ONE.normalize(), Vec3::NEG_Y);
    let p = Vec3::new(0.1, 0.5 + 0.75_f32.sqrt() - 0.02, 0.0);
    let a = Placed {
        shape: &CUBE,
        p,
        q: corner_down,
        p_before: p,
    };
    let b = Placed {
        shape: &CUBE,
        p: Vec3::ZERO,
        q: Quat::IDENTITY,
        p_before: Vec3::ZERO,
    };
    let end = dissect(&a, &b, usize::MAX);
    assert_eq!(names(&end), ["Faces", "GJK", "Skin", "Touch"]);
    assert_says(
        &end.text,
        "The skin decided: the normal is that of b's leading face",
    );
    let bounds = &end.bounds[end.steps() - 2..];
    for bound in bounds.iter().flatten() {
        assert!((bound + 0.02).abs() < 1e-4, "{bounds:?}");
    }
    let gjk_end = dissect(&a, &b, end.phases[1].steps).text;
    assert_says(&gjk_end, "Next is the skin");
    let skin_end = dissect(&a, &b, end.steps() - 2).text;
    assert_says(&skin_end, "no need for EPA");
}

#[test]
fn what_is_too_deep_for_the_skin_goes_to_epa() {
    let end = above(&CUBE, &CUBE, 0.8, usize::MAX);
    assert_eq!(names(&end), ["Faces", "GJK", "Skin", "EPA", "Touch"]);
    assert_eq!(end.bounds.len(), end.steps());
    let [low, high] = end.bounds[end.steps() - 1];
    assert!(low == high && low < -0.1, "{low} … {high}");
    let epa = end.bounds[end.steps() - 2];
    assert!((epa[0] - low).abs() < 1e-3 && (epa[1] - low).abs() < 1e-3);
    assert_says(&end_of(&CUBE, &CUBE, 0.8, "Skin"), "even without the skin");
    assert_says(&end.text, "EPA decided");
}

#[test]
fn edges_that_cross_are_not_settled_by_the_skin() {
    let on_edge = |p, q| Placed {
        shape: &CUBE,
        p,
        q,
        p_before: p,
    };
    let quarter = std::f32::consts::FRAC_PI_4;
    let a = on_edge(
        Vec3::new(0.0, 2.0_f32.sqrt() - 0.01, 0.0),
        Quat::from_rotation_z(quarter),
    );
    let b = on_edge(Vec3::ZERO, Quat::from_rotation_x(quarter));
    let end = dissect(&a, &b, usize::MAX);
    assert_eq!(names(&end), ["Faces", "GJK", "Skin", "EPA", "Touch"]);
    assert_says(
        &end.text,
        "EPA decided: the normal isn't the leading face's",
    );
    let before_epa: usize = end.phases[..3].iter().map(|phase| phase.steps).sum();
    assert_says(
        &dissect(&a, &b, before_epa - 1).text,
        "another normal may do better: EPA must tell",
    );
}

#[test]
fn solids_that_just_touch_are_taken_for_overlapping() {
    let at = |p| Placed {
        shape: &CUBE,
        p,
        q: Quat::IDENTITY,
        p_before: p,
    };
    for gap in [-1e-5, 0.0, 1e-5] {
        let end = dissect(&at(Vec3::Y * (1.0 + gap)), &at(Vec3::ZERO), usize::MAX);
        assert_eq!(names(&end), ["Faces", "GJK", "Skin", "Touch"], "{gap}");
        assert_says(&end.text, "The skin decided");
    }
}

#[test]
fn a_capsules_radius_spares_the_skin() {
    for height in [1.1, 1.2] {
        let end = above(&CAPSULE, &CUBE, height, usize::MAX);
        assert_eq!(names(&end), ["Faces", "GJK", "Touch"]);
        assert_says(&end.text, "GJK decided");
    }
    let end = above(&CAPSULE, &CUBE, 0.2, usize::MAX);
    assert_eq!(names(&end), ["Faces", "GJK", "Skin", "EPA", "Touch"]);
}

#[test]
fn pairs_with_a_closed_form_have_gjk_for_study() {
    for (one, two) in [
        (&BALL, &BALL),
        (&BALL, &CUBE),
        (&CUBE, &BALL),
        (&CAPSULE, &BALL),
        (&BALL, &CYLINDER),
        (&CAPSULE, &CAPSULE),
    ] {
        let end = above(one, two, 0.65, usize::MAX);
        assert_eq!(names(&end)[0], "GJK");
        assert_says(&end.text, "closed form");
        let first = above(one, two, 0.65, 0);
        assert!(first.title.starts_with("GJK for study"), "{}", first.title);
        assert_says(&end_of(one, two, 0.65, "GJK"), "closed form");
    }
}

#[test]
fn a_body_that_came_through_a_floor_goes_the_way_back() {
    let slab = Shape::Box {
        half_extents: Vec3::new(4.0, 0.3, 4.0),
    };
    let p = Vec3::new(0.0, -0.2, 0.0);
    let falling = Placed {
        shape: &CYLINDER,
        p,
        q: Quat::IDENTITY,
        p_before: Vec3::Y,
    };
    let floor = Placed {
        shape: &slab,
        p: Vec3::ZERO,
        q: Quat::IDENTITY,
        p_before: Vec3::ZERO,
    };
    let end = dissect(&falling, &floor, usize::MAX);
    assert_says(&end.text, "The way back decided");
}

/// The part that decides has found the depth which the touch has.
#[test]
fn whoever_decides_agrees_with_the_touch() {
    for one in [CUBE, CAPSULE, CYLINDER] {
        for two in [CUBE, CYLINDER] {
            for height in [1.6, 1.3, 1.1, 0.95, 0.7, 0.3, 0.05] {
                let end = above(&one, &two, height, usize::MAX);
                let phase = names(&end)[end.phases.len() - 2];
                assert_says(&end.text, &format!("{phase} decided").replace('S', "The s"));
                let [low, high] = end.bounds[end.steps() - 2];
                let found = end.bounds[end.steps() - 1][0];
                assert!(
                    low - 2e-3 < found && found < high + 2e-3,
                    "{height}: {found} not in {low} … {high}, {}",
                    end.text
                );
            }
        }
    }
}

#[test]
fn purple_are_exactly_the_faces_that_are_gone_next() {
    let all = above(&CYLINDER, &CUBE, 0.5, 0);
    let before_epa: usize = all.phases[..3].iter().map(|phase| phase.steps).sum();
    let shown = |step| above(&CYLINDER, &CUBE, 0.5, step);
    let opacities = |d: &Dissection| -> Vec<([Vec3; 3], f32)> {
        let faces = d.difference.faces.iter();
        faces
            .map(|f| (f.corners.map(Vec3::from), f.color[3]))
            .collect()
    };
    for step in before_epa..before_epa + all.phases[3].steps - 1 {
        let (now, next) = (opacities(&shown(step)), opacities(&shown(step + 1)));
        for (corners, opacity) in now {
            let stays = next.iter().any(|(others, _)| *others == corners);
            assert_eq!(stays, opacity < 0.2, "{step}");
        }
    }
}

#[test]
fn capsules_overlap_without_their_cores_meeting() {
    let end = above(&CAPSULE, &CAPSULE, 1.3, usize::MAX);
    assert_eq!(names(&end), ["GJK", "Touch"]);
    assert!(end.bounds[end.steps() - 1][1] < 0.0);
    let last = above(&CAPSULE, &CAPSULE, 1.3, end.steps() - 2);
    assert_says(&last.text, "the solids overlap by");
    assert!(!last.core.is_empty() && !last.surface.is_empty());
}

#[test]
fn every_iteration_has_a_title_words_and_a_drawing() {
    for (one, two, height) in [
        (CUBE, CUBE, 0.8),
        (CUBE, CUBE, 1.2),
        (CAPSULE, CUBE, 0.9),
        (BALL, CUBE, 0.6),
        (CYLINDER, CYLINDER, 0.9),
        (CUBE, CUBE, 3.0),
    ] {
        let steps = above(&one, &two, height, 0).steps();
        for step in 0..steps {
            let shown = above(&one, &two, height, step);
            assert_eq!(shown.step, step);
            assert!(!shown.text.is_empty() && !shown.difference.key.is_empty());
            assert!(!shown.world.marks.is_empty(), "{}", shown.title);
        }
        assert_eq!(above(&one, &two, height, usize::MAX).step, steps - 1);
    }
}

#[test]
fn bounds_only_close_in_while_an_algorithm_runs() {
    let end = above(&CUBE, &CUBE, 0.8, 0);
    let mut first = 0;
    for phase in &end.phases {
        let run = &end.bounds[first..first + phase.steps];
        assert!(run.iter().all(|[low, high]| low <= high));
        assert!(
            run.windows(2)
                .all(|b| b[0][0] <= b[1][0] && b[1][1] <= b[0][1])
        );
        first += phase.steps;
    }
}

#[test]
fn vertices_have_the_letters_of_their_arrival() {
    let shown = above(&CUBE, &CUBE, 0.8, 1);
    let marks: Vec<&str> = shown
        .difference
        .marks
        .iter()
        .map(|m| m.text.as_str())
        .collect();
    assert_eq!(marks, ["A", "v", "w = B"]);
}
