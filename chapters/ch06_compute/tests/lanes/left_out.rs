//! Engine `lanes` leaves out what a scene doesn't need, and nothing changes by it.

use ch00_scenes::{Scene, Settings};
use ch06_compute::bodies::Bodies;
use ch06_compute::lanes::Lanes;
use ch06_compute::lanes::plan::{PARTS, Part, Plan};
use ch06_compute::rules::Rules;
use ch06_compute::simd::Four;

const STEPS: u32 = 120;

const METHODS: [&str; 2] = ["own-row", "coloured"];

fn open(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in scene")
}

/// The scene without friction at all bodies, or at each third one.
fn smooth(mut scene: Scene, each: usize) -> Scene {
    for body in scene.bodies.iter_mut().step_by(each) {
        (body.friction, body.static_friction) = (0.0, None);
    }
    scene
}

fn after(scene: &Scene, method: &str, plan: Plan) -> Lanes<Four> {
    let settings = Settings::defaults().with_method(method);
    let rules = Rules::of(scene, &settings).expect("the defaults");
    let mut lanes = Lanes::of(scene, rules).expect("it is supported");
    lanes.plan = plan;
    for _ in 0..STEPS {
        lanes.step(scene.dt as f32, |_| {});
    }
    lanes
}

/// All that bodies are, bit by bit.
fn bits(bodies: &Bodies) -> Vec<u32> {
    let columns: [&[u32]; 4] = [
        bytemuck::cast_slice(&bodies.place),
        bytemuck::cast_slice(&bodies.attitude),
        bytemuck::cast_slice(&bodies.motion),
        bytemuck::cast_slice(&bodies.spin),
    ];
    columns.concat()
}

#[track_caller]
fn has_the_same_bits(scene: &Scene, part: Part) -> Lanes<Four> {
    for method in METHODS {
        let without = after(scene, method, Plan::default());
        let with = after(scene, method, Plan::default().with(part));
        let (one, other) = (bits(&without.bodies), bits(&with.bodies));
        assert!(one == other, "{}, {method}: {}", scene.name, part.name());
    }
    after(scene, METHODS[0], Plan::default())
}

#[test]
fn pairs_without_friction_have_the_bits_of_those_that_compute_it() {
    for (name, count) in [
        ("smooth_balls", Some(300)),
        ("pile", Some(200)),
        ("mixed", Some(60)),
        ("ragdolls", Some(3)),
        ("stack", Some(5)),
    ] {
        let lanes = has_the_same_bits(&smooth(open(name, count), 1), Part::Friction);
        let [rough, smooth] = lanes.pairs.counts();
        assert_eq!(rough.iter().sum::<usize>(), 0, "{name}");
        assert!(smooth.iter().sum::<usize>() > 0, "{name}");
    }
}

#[test]
fn where_some_pairs_have_friction_and_others_none_each_goes_its_way() {
    for (name, count) in [("pile", Some(200)), ("mixed", Some(60))] {
        let lanes = has_the_same_bits(&smooth(open(name, count), 3), Part::Friction);
        for kind in lanes.pairs.counts() {
            assert!(kind.iter().sum::<usize>() > 0, "{name}");
        }
    }
}

#[test]
fn bodies_that_nothing_joins_move_in_one_pass_as_they_do_in_several() {
    for (name, count) in [("balls", Some(300)), ("mixed", Some(60)), ("stack", None)] {
        has_the_same_bits(&open(name, count), Part::Joints);
    }
}

#[test]
fn a_plan_keeps_what_it_is_told_to_and_what_that_cannot_do_without() {
    let plan = Plan::default();
    assert!(!PARTS.into_iter().any(|part| plan.keeps(part)));
    assert!(
        PARTS
            .into_iter()
            .all(|part| plan.with(part).keeps(part) && Plan::full().keeps(part))
    );
    assert!(plan.with(Part::Points).keeps(Part::Shapes));
    assert!(!plan.with(Part::Shapes).keeps(Part::Points));
}
