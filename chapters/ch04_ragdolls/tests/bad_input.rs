//! What could be in a scene by mistake or by malice: a clear error, or a simulation that stays
//! finite and bounded.

use ch00_scenes::measures::Measures;
use ch00_scenes::{Body, Joint, Scene, Settings, Shape, State};
use ch04_ragdolls::ENGINE;
use glam::{DQuat, DVec3};

const LIMB: Shape = Shape::Capsule {
    radius: 0.05,
    half_height: 0.1,
};

/// A floor, and these bodies.
fn on_a_floor(bodies: Vec<Body>) -> Scene {
    let mut scene = Scene::new("bad input");
    let floor = Shape::Box {
        half_extents: DVec3::new(50.0, 0.5, 50.0),
    };
    scene.bodies = vec![Body::new(floor, 0.0, -0.5 * DVec3::Y)];
    scene.bodies.extend(bodies);
    scene
}

/// What `validate` says about the scene.
fn refusal(scene: &Scene) -> String {
    scene.validate("file.json").unwrap_err().to_string()
}

/// Runs ten seconds; every state must be finite and no body further away than `reach`, m.
fn run_bounded(scene: &Scene, reach: f64) -> (State, Measures) {
    scene.validate("file.json").unwrap();
    let mut engine = (ENGINE.load)(scene, &Settings::defaults()).unwrap();
    let mut state = State::start_of(scene);
    for step in 0..600 {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        assert_eq!(state.not_finite(), 0, "step {step}");
        for p in &state.position {
            assert!(p.length() < reach, "step {step}: {p}");
        }
    }
    let measures = Measures::of(scene, &state);
    (state, measures)
}

#[test]
fn a_joint_to_itself_names_the_joint_and_the_field() {
    let mut scene = on_a_floor(vec![Body::new(LIMB, 1.0, DVec3::Y)]);
    scene.joints = vec![Joint::pin(1, 1, DVec3::ZERO, DVec3::ZERO)];
    let message = refusal(&scene);
    assert!(
        message.contains("file.json: joints[0].ball.b = 1"),
        "{message}"
    );
}

#[test]
fn a_joint_to_a_missing_body_names_the_number_of_bodies() {
    let mut scene = on_a_floor(vec![Body::new(LIMB, 1.0, DVec3::Y)]);
    scene.joints = vec![Joint::pin(1, 7, DVec3::ZERO, DVec3::ZERO)];
    let message = refusal(&scene);
    assert!(
        message.contains("joints[0].ball.b = 7 (of 2 bodies)"),
        "{message}"
    );
}

#[test]
fn limits_with_low_above_high_are_refused() {
    let mut scene = on_a_floor(vec![
        Body::new(LIMB, 1.0, DVec3::Y),
        Body::new(LIMB, 1.0, DVec3::new(0.0, 1.3, 0.0)),
    ]);
    let mut joint = Joint::pin(1, 2, 0.15 * DVec3::Y, -0.15 * DVec3::Y);
    if let Joint::Ball { twist, .. } = &mut joint {
        *twist = Some([0.5, -0.5]);
    }
    scene.joints = vec![joint];
    let message = refusal(&scene);
    assert!(
        message.contains("joints[0].ball.twist = [0.5, -0.5]"),
        "{message}"
    );
}

#[test]
fn a_ring_of_bones_is_no_tree_and_still_holds_together() {
    // Four limbs, each the next one's parent and the last one the first one's.
    let quarter = DQuat::from_axis_angle(DVec3::Z, std::f64::consts::FRAC_PI_2);
    let corner = |i: usize| match i {
        0 => (DVec3::new(-0.15, 1.0, 0.0), DQuat::IDENTITY),
        1 => (DVec3::new(0.0, 1.15, 0.0), quarter),
        2 => (DVec3::new(0.15, 1.0, 0.0), DQuat::IDENTITY),
        _ => (DVec3::new(0.0, 0.85, 0.0), quarter),
    };
    let limbs = (0..4).map(|i| {
        let (p, q) = corner(i);
        let mut body = Body::new(LIMB, 1.0, p);
        body.orientation = q;
        body
    });
    let mut scene = on_a_floor(limbs.collect());
    let ends = [
        (1, 2, DVec3::new(-0.15, 1.15, 0.0)),
        (2, 3, DVec3::new(0.15, 1.15, 0.0)),
        (3, 4, DVec3::new(0.15, 0.85, 0.0)),
        (4, 1, DVec3::new(-0.15, 0.85, 0.0)),
    ];
    scene.joints = ends
        .map(|(a, b, at)| {
            let local = |i: usize| {
                let body = &scene.bodies[i];
                body.orientation.conjugate() * (at - body.position)
            };
            Joint::pin(a, b, local(a), local(b))
        })
        .to_vec();
    let (_, measures) = run_bounded(&scene, 20.0);
    let gap = measures.joint_separation.unwrap();
    assert!(gap < 0.005, "{gap}");
}

#[test]
fn a_capsule_without_height_is_a_ball() {
    let capsule = Shape::Capsule {
        radius: 0.2,
        half_height: 0.0,
    };
    let (state, _) = run_bounded(&on_a_floor(vec![Body::new(capsule, 1.0, DVec3::Y)]), 20.0);
    assert!(
        (state.position[1].y - 0.2).abs() < 0.0015,
        "{}",
        state.position[1]
    );
}

#[test]
fn a_needle_comes_to_rest_on_its_side() {
    let needle = Shape::Box {
        half_extents: DVec3::new(0.001, 1.0, 0.001),
    };
    let mut body = Body::new(needle, 0.01, 1.5 * DVec3::Y);
    body.orientation = DQuat::from_axis_angle(DVec3::Z, 0.4);
    let (state, measures) = run_bounded(&on_a_floor(vec![body]), 50.0);
    let up = (state.orientation[1] * DVec3::Y).y.abs();
    assert!(up < 0.02, "{up}");
    assert!(measures.conserved.kinetic_energy < 1e-3);
}

#[test]
fn bodies_of_every_shape_at_one_place_part() {
    let at = DVec3::new(0.0, 2.0, 0.0);
    let shapes = [
        Shape::Sphere { radius: 0.2 },
        LIMB,
        Shape::Box {
            half_extents: DVec3::splat(0.15),
        },
        Shape::Cylinder {
            radius: 0.15,
            half_height: 0.15,
        },
    ];
    let twice = shapes.iter().chain(&shapes);
    let scene = on_a_floor(twice.map(|&shape| Body::new(shape, 1.0, at)).collect());
    // What falls from two metres rolls less than 60 m in what is left of ten seconds.
    let (_, measures) = run_bounded(&scene, 60.0);
    assert!(
        measures.penetration.deepest < 0.01,
        "{:?}",
        measures.penetration
    );
}

#[test]
fn a_milligram_on_a_thousand_tonnes_stays_where_it_is() {
    let cube = |half: f64| Shape::Box {
        half_extents: DVec3::splat(half),
    };
    let heavy = Body::new(cube(1.0), 1e6, DVec3::Y);
    let light = Body::new(cube(0.1), 1e-6, 2.1 * DVec3::Y);
    let (state, _) = run_bounded(&on_a_floor(vec![heavy, light]), 20.0);
    assert!(
        (state.position[2].y - 2.1).abs() < 0.005,
        "{}",
        state.position[2]
    );
}

#[test]
fn a_thousand_tonnes_on_a_milligram_fall_but_stay_finite() {
    let cube = |half: f64| Shape::Box {
        half_extents: DVec3::splat(half),
    };
    let light = Body::new(cube(0.1), 1e-6, 0.1 * DVec3::Y);
    let heavy = Body::new(cube(1.0), 1e6, 1.2 * DVec3::Y);
    run_bounded(&on_a_floor(vec![light, heavy]), 100.0);
}

#[test]
fn a_limb_joined_to_a_milligram_holds() {
    let mut scene = on_a_floor(vec![
        Body::new(LIMB, 1e3, 2.0 * DVec3::Y),
        Body::new(LIMB, 1e-3, 2.3 * DVec3::Y),
    ]);
    scene.joints = vec![Joint::pin(1, 2, 0.15 * DVec3::Y, -0.15 * DVec3::Y)];
    let (_, measures) = run_bounded(&scene, 20.0);
    assert!(measures.joint_separation.unwrap() < 0.005);
}
