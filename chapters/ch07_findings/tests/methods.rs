//! The usual methods do what the field says of them: the figures are of the reference, where others measured
//! the same methods on the same body.

use ch00_scenes::{EngineEntry, LoadError, Scene, Settings, State};
use ch07_findings::laboratory::{SCENARIOS, Scenario};
use ch07_findings::methods::{double, single};

const DOUBLE: EngineEntry = double::engine::ENGINE;
const SINGLE: EngineEntry = single::engine::ENGINE;

fn scenario(name: &str) -> &'static Scenario {
    let found = SCENARIOS.iter().find(|known| known.name == name);
    found.expect("there is such a scenario")
}

fn scene(name: &str) -> Scene {
    let scenes = (scenario(name).scenes)(60, true).expect("it can be built");
    scenes.into_iter().next().expect("there is one")
}

fn settings(method: &str, substeps: Option<u32>) -> Settings {
    Settings {
        substeps,
        ..Settings::defaults().with_method(method)
    }
}

fn end(engine: EngineEntry, scene: &Scene, settings: &Settings) -> State {
    engine.run(scene, settings, scene.steps).expect("it runs")
}

/// The angle by which scenario 4 is off after 10 s, rad.
fn off(engine: EngineEntry, method: &str, substeps: Option<u32>) -> f64 {
    let state = end(engine, &scene("free_top"), &settings(method, substeps));
    let exact = glam::DQuat::from_xyzw(
        -0.106_057_607_8,
        -0.035_904_831_18,
        -0.914_239_544_2,
        0.389_395_278_3,
    );
    let turn = state.orientation[0] * exact.conjugate();
    2.0 * turn.xyz().length().atan2(turn.w.abs())
}

#[test]
fn the_integrators_err_on_the_free_top_as_the_reference_measured() {
    for (method, wanted) in [
        ("constant-spin", 2.1050),
        ("explicit-gyro", 2.1174),
        ("implicit-gyro", 1.2909),
        ("splitting", 3.145e-4),
    ] {
        let found = off(DOUBLE, method, None);
        assert!((found / wanted - 1.0).abs() < 2e-4, "{method}: {found}");
    }
}

#[test]
fn xpbd_errs_on_the_free_top_as_the_reference_measured() {
    for (substeps, wanted) in [(1, 3.0204), (4, 0.994), (20, 0.205)] {
        let found = off(DOUBLE, "xpbd", Some(substeps));
        assert!((found / wanted - 1.0).abs() < 3e-3, "{substeps}: {found}");
    }
}

#[test]
fn runge_kutta_is_of_the_fourth_order_and_the_splitting_of_the_second() {
    for (method, order) in [("runge-kutta", 4.0), ("splitting", 2.0)] {
        let [coarse, fine] = [1, 2].map(|substeps| off(DOUBLE, method, Some(substeps)));
        let found = (coarse / fine).log2();
        assert!((found - order).abs() < 0.3, "{method}: {found}");
    }
}

#[test]
fn xpbd_loses_spin_by_its_law() {
    let state = end(DOUBLE, &scene("spin_kept"), &settings("xpbd", Some(1)));
    let found = state.angular_velocity[0].y;
    assert!((found - 8.401_680_504).abs() < 1e-8, "{found}");
}

#[test]
fn single_precision_adds_its_rounding_and_no_more() {
    for method in ["constant-spin", "splitting"] {
        let apart = (off(DOUBLE, method, None) - off(SINGLE, method, None)).abs();
        // ω is made L and back in every step: the splitting loses 2e-3 rad by it in 600.
        assert!(apart > 0.0 && apart < 5e-3, "{method}: {apart}");
    }
}

#[test]
fn a_pair_of_balls_keeps_its_momentum_with_every_solver() {
    let scene = ch00_scenes::builtin::build("pair", None, None).expect("built in");
    let before = ch00_scenes::measures::Conserved::of(&scene, &State::start_of(&scene));
    for method in ["sequential-impulses", "soft-step", "xpbd", "direct-joints"] {
        let state = end(DOUBLE, &scene, &settings(method, None));
        let after = ch00_scenes::measures::Conserved::of(&scene, &state);
        let lost = after.momentum.distance(before.momentum);
        assert!(lost < 1e-12, "{method}: {lost}");
    }
}

#[test]
fn joints_that_are_solved_at_once_hold_together() {
    let scene = scene("hanging_chain");
    for (method, most) in [("direct-joints", 1e-9), ("xpbd", 1e-3)] {
        let state = end(DOUBLE, &scene, &settings(method, None));
        let apart = ch00_scenes::measures::joint_separation(&scene, &state).expect("it has joints");
        assert!(apart < most, "{method}: {apart}");
    }
}

fn refused(method: &str, scene: &str, change: impl Fn(&mut Settings)) -> String {
    let scene = ch00_scenes::builtin::build(scene, None, None).expect("built in");
    let mut settings = settings(method, None);
    change(&mut settings);
    let outcome: Result<_, LoadError> = (DOUBLE.load)(&scene, &settings);
    outcome.err().expect("it is refused").to_string()
}

#[test]
fn what_a_method_does_not_model_is_told_before_the_first_step() {
    for (method, scene, words) in [
        ("runge-kutta", "chain", "joints"),
        ("splitting", "balls", "contacts"),
        ("xpbd", "magnets", "magnets"),
        ("soft-step", "orrery", "prescribed motions"),
    ] {
        let message = refused(method, scene, |_| {});
        assert!(
            message.contains(method) && message.contains(words),
            "{message}"
        );
    }
}

#[test]
fn settings_that_make_no_sense_are_told() {
    for (method, words, change) in [
        (
            "xpbd",
            "substeps 0",
            (|s| s.substeps = Some(0)) as fn(&mut Settings),
        ),
        ("xpbd", "sweeps 0", |s| s.sweeps = Some(0)),
        ("splitting", "sweeps 3", |s| s.sweeps = Some(3)),
        ("xpbd", "threads 2", |s| s.threads = Some(2)),
        ("xpdb", "xpbd", |_| {}),
    ] {
        let scene = if method == "splitting" {
            "tops"
        } else {
            "bounce"
        };
        let message = refused(method, scene, change);
        assert!(message.contains(words), "{message}");
    }
}
