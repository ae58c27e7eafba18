//! Eight ragdolls that fall on each other (the report's Table 2): what their joints and limits hold,
//! and that they come to rest.

use ch00_scenes::measures::Measures;
use ch00_scenes::{Scene, Settings, State};
use ch04_ragdolls::ENGINE;

/// What a run of ten seconds showed.
struct Run {
    /// Over all steps.
    widest_joint: f64,
    escaped: usize,
    /// After the last step.
    end: Measures,
}

fn run(seed: u64) -> Run {
    let scene = Scene::open("ragdolls", Some(8), Some(seed)).expect("a built-in");
    let mut engine = (ENGINE.load)(&scene, &Settings::defaults()).expect("it has joints");
    let mut state = State::start_of(&scene);
    let mut end = Measures::of(&scene, &state);
    let (mut widest_joint, mut escaped) = (0.0_f64, 0);
    for step in 0..600 {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        end = Measures::of(&scene, &state);
        assert_eq!(end.not_finite, 0, "seed {seed}, step {step}");
        widest_joint = widest_joint.max(end.joint_separation.unwrap_or(f64::NAN));
        escaped = escaped.max(end.escaped.unwrap_or(usize::MAX));
    }
    Run {
        widest_joint,
        escaped,
        end,
    }
}

#[test]
fn eight_ragdolls_hold_together_and_come_to_rest() {
    for seed in 1..=3 {
        let run = run(seed);
        assert!(run.widest_joint < 0.05, "seed {seed}: {}", run.widest_joint);
        assert_eq!(run.escaped, 0, "seed {seed}");
        let at_rest = run.end.joint_separation.expect("it has joints");
        assert!(at_rest < 0.005, "seed {seed}: {at_rest}");
        let beyond = run.end.limit_excess.expect("it has limits");
        assert!(beyond < 5_f64.to_radians(), "seed {seed}: {beyond}");
        let overlap = run.end.penetration;
        assert!(overlap.p99 < 0.01, "seed {seed}: {overlap:?}");
        let each = run.end.conserved.kinetic_energy / 96.0;
        assert!(each < 1e-3, "seed {seed}: {each} J a body");
    }
}

#[test]
fn the_ragdolls_that_other_engines_ran_run_here() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/scenes/ragdolls_5.json"
    );
    let scene = Scene::open(path, None, None).expect("a scene file");
    let end = ENGINE.run(&scene, &Settings::defaults(), 600).unwrap();
    let measures = Measures::of(&scene, &end);
    assert_eq!((measures.escaped, measures.not_finite), (Some(0), 0));
    assert!(measures.joint_separation.unwrap() < 0.005);
    assert!(measures.penetration.p99 < 0.01);
}

#[test]
fn at_five_frames_a_second_limbs_pass_through_the_floor() {
    // What the report saw: at 8 m/s a limb moves 1.6 m in such a frame, and the floor is 1 m thick.
    let mut scene = Scene::open("ragdolls", Some(5), Some(1)).expect("a built-in");
    scene.dt = 0.2;
    let escaped_after = |scene: &Scene, steps: u32| {
        let end = ENGINE.run(scene, &Settings::defaults(), steps).unwrap();
        Measures::of(scene, &end).escaped.unwrap()
    };
    assert!(escaped_after(&scene, 50) > 0);
    scene.dt = 1.0 / 60.0;
    assert_eq!(escaped_after(&scene, 600), 0);
}
