//! What rapier is told of a scene is what the scene says.

use ch00_scenes::measures::{joint_separation, limit_excess};

use super::*;

fn setup(cone: Cone) -> Setup {
    Setup {
        threads: 1,
        iterations: 4,
        cone,
        tolerant: true,
        ccd: false,
    }
}

/// Makes so many steps.
fn step(engine: &mut Rapier, steps: u32) {
    engine.inside(|world| (0..steps).for_each(|_| world.step()));
}

/// After so many steps.
fn after(scene: &Scene, setup: Setup, steps: u32) -> State {
    let mut engine = Rapier::load(scene, setup).unwrap();
    step(&mut engine, steps);
    let mut state = State::default();
    engine.read(&mut state);
    state
}

/// A rod that stands on the origin, held by this joint to a ball that nothing moves.
fn rod(joint: Joint, start: DQuat) -> Scene {
    let mut scene = Scene::new("rod");
    scene.drag = 1.0;
    let ball = Shape::Sphere { radius: 0.1 };
    let rod = Shape::Capsule {
        radius: 0.1,
        half_height: 0.5,
    };
    scene.bodies = vec![
        Body::new(ball, 0.0, DVec3::ZERO),
        Body {
            orientation: start,
            ..Body::new(rod, 10.0, start * DVec3::Y)
        },
    ];
    scene.joints = vec![joint];
    scene
}

/// A ball joint at the origin whose rest is upright.
fn ball_joint(cone: Option<f64>, twist: Option<[f64; 2]>, limits: Option<EulerLimits>) -> Joint {
    Joint::Ball {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: -DVec3::Y,
        cone,
        twist,
        limits,
        rest: Some(DQuat::IDENTITY),
    }
}

/// Ten seconds.
const LONG: u32 = 600;

#[test]
fn the_start_is_the_scenes() {
    for name in ["mixed", "ragdolls", "balls"] {
        let scene = Scene::open(name, None, None).unwrap();
        let (start, state) = (
            State::start_of(&scene),
            after(&scene, setup(Cone::Coupled), 0),
        );
        for i in 0..start.len() {
            assert!(start.position[i].distance(state.position[i]) < 1e-5);
            assert!(start.orientation[i].angle_between(state.orientation[i]) < 1e-3);
            assert!(start.linear_velocity[i].distance(state.linear_velocity[i]) < 1e-6);
            assert!(start.angular_velocity[i].distance(state.angular_velocity[i]) < 1e-6);
        }
    }
}

#[test]
fn masses_and_moments_of_inertia_are_ours_once_it_has_taken_them_up() {
    let scene = Scene::open("mixed", None, None).unwrap();
    let mut engine = Rapier::load(&scene, setup(Cone::Coupled)).unwrap();
    step(&mut engine, 1);
    for (body, handle) in scene.bodies.iter().zip(&engine.handles) {
        if body.is_static() {
            continue;
        }
        let theirs = engine.world.bodies[*handle].mass_properties().local_mprops;
        assert!((f64::from(theirs.mass()) / body.mass - 1.0).abs() < 1e-6);
        let off = of_vector(theirs.principal_inertia()) / body.shape.inertia(body.mass);
        assert!((off - 1.0).abs().max_element() < 1e-5, "{off}");
    }
}

#[test]
fn a_rod_leans_at_its_cone() {
    for cone in [Cone::Coupled, Cone::Ranges] {
        let scene = rod(
            ball_joint(Some(0.5), None, None),
            DQuat::from_rotation_x(0.1),
        );
        let state = after(&scene, setup(cone), LONG);
        let angle = (state.orientation[1] * DVec3::Y).angle_between(DVec3::Y);
        assert!((angle - 0.5).abs() < 1e-3, "{cone:?}: {angle}");
        assert!(joint_separation(&scene, &state).unwrap() < 1e-4);
    }
}

#[test]
fn a_rod_leans_at_its_pitch_and_at_its_roll() {
    let limits = EulerLimits {
        pitch: [-0.2, 0.4],
        yaw: [-0.1, 0.1],
        roll: [-0.3, 0.6],
    };
    for (start, leans) in [
        (DQuat::from_rotation_x(0.1), 0.4),
        (DQuat::from_rotation_x(-0.1), 0.2),
        (DQuat::from_rotation_z(0.1), 0.6),
        (DQuat::from_rotation_z(-0.1), 0.3),
    ] {
        let scene = rod(ball_joint(None, None, Some(limits)), start);
        let state = after(&scene, setup(Cone::Coupled), LONG);
        let angle = (state.orientation[1] * DVec3::Y).angle_between(DVec3::Y);
        assert!((angle - leans).abs() < 1e-3, "{leans}: {angle}");
    }
}

#[test]
fn a_spinning_rod_is_stopped_by_its_twist() {
    for (spin, stops) in [(3.0, 0.7), (-3.0, -0.2)] {
        let joint = ball_joint(Some(0.1), Some([-0.2, 0.7]), None);
        let mut scene = rod(joint, DQuat::IDENTITY);
        scene.drag = 0.0;
        scene.gravity = DVec3::ZERO;
        scene.bodies[1].angular_velocity = DVec3::Y * spin;
        let state = after(&scene, setup(Cone::Coupled), LONG);
        let q = state.orientation[1];
        let twist = 2.0 * q.y.atan2(q.w);
        assert!((twist - stops).abs() < 0.05, "{stops}: {twist}");
    }
}

#[test]
fn a_rod_on_a_hinge_turns_about_its_axis_to_the_end_of_its_range() {
    let start = DQuat::from_rotation_y(0.3) * DQuat::from_rotation_z(0.1);
    let axis = DQuat::from_rotation_y(0.3) * DVec3::Z;
    let hinge = Joint::Hinge {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: -DVec3::Y,
        axis_a: axis,
        axis_b: start.conjugate() * axis,
        range: Some([-0.2, 0.5]),
    };
    let scene = rod(hinge, start);
    let state = after(&scene, setup(Cone::Coupled), LONG);
    let leans = (state.orientation[1] * DVec3::Y).angle_between(DVec3::Y);
    assert!((leans - 0.6).abs() < 1e-3, "{leans}");
    assert!(limit_excess(&scene, &state).unwrap() < 1e-3);
}

#[test]
fn a_distance_holds_what_hangs_from_it() {
    let distance = Joint::Distance {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: DVec3::Y * 0.5,
        length: 0.8,
    };
    let mut scene = rod(distance, DQuat::IDENTITY);
    scene.bodies[1].position = DVec3::NEG_Y * 1.3;
    let state = after(&scene, setup(Cone::Coupled), LONG);
    assert!(joint_separation(&scene, &state).unwrap() < 1e-3);
}

/// A ball at 100 m/s and a wall of 0.1 m that nothing moves, at 60 Hz.
#[test]
fn continuous_detection_holds_a_fast_ball_at_a_wall() {
    let mut scene = Scene::new("wall");
    scene.gravity = DVec3::ZERO;
    let wall = Shape::Box {
        half_extents: DVec3::new(0.05, 2.0, 2.0),
    };
    let mut ball = Body::new(
        Shape::Sphere { radius: 0.1 },
        1.0,
        DVec3::new(-1.0, 0.0, 0.0),
    );
    ball.linear_velocity = DVec3::X * 100.0;
    scene.bodies = vec![Body::new(wall, 0.0, DVec3::ZERO), ball];
    let passes = |ccd| {
        let setup = Setup {
            ccd,
            ..setup(Cone::Coupled)
        };
        after(&scene, setup, 30).position[1].x > 0.0
    };
    assert!(passes(false) && !passes(true));
}

/// What its four iterations leave, ten times as many don't: the limits are ours, the error is its own.
#[test]
fn with_many_iterations_a_ragdoll_keeps_its_limits() {
    let scene = Scene::open("ragdolls", Some(1), None).unwrap();
    let excess = |iterations| {
        let setup = Setup {
            iterations,
            ..setup(Cone::Coupled)
        };
        limit_excess(&scene, &after(&scene, setup, LONG)).unwrap()
    };
    let (few, many) = (excess(4), excess(40));
    assert!(many < 0.01 && few > many, "{few} {many}");
}
