//! No more than the scene needs, and nothing less.

use ch00_scenes::{Engine, Scene, Settings, builtin};
use ch05_properties::PropertiesEngine;
use ch05_properties::columns::AnyTable;
use ch05_properties::plan::{Part, Plan, SYSTEMS, System, needs_of};
use ch05_properties::world::Method;
use glam::DVec3;

const METHODS: [(&str, Method); 2] = [
    ("corrected", Method::Corrected),
    ("printed", Method::Printed),
];

fn open(name: &str) -> Scene {
    Scene::open(name, None, None).expect("a built-in")
}

fn scenes() -> impl Iterator<Item = Scene> {
    let all = builtin::NAMES.iter().map(|name| open(name));
    all.filter(|scene| scene.orbits.is_empty())
}

fn load(scene: &Scene) -> PropertiesEngine {
    PropertiesEngine::load(scene, &Settings::defaults()).expect("it runs")
}

/// Balls on a floor without friction or spin.
fn smooth_balls() -> Scene {
    let mut scene = open("balls");
    for body in &mut scene.bodies {
        body.friction = 0.0;
        body.static_friction = None;
        body.angular_velocity = DVec3::ZERO;
    }
    scene
}

fn left_out(scene: &Scene) -> Vec<Part> {
    Plan::of(scene, Method::Corrected).left_out().collect()
}

#[test]
fn every_column_that_is_kept_is_read_or_written_by_a_system_that_runs() {
    for scene in scenes() {
        for (name, method) in METHODS {
            let settings = Settings::defaults().with_method(name);
            let engine = PropertiesEngine::load(&scene, &settings).expect("it runs");
            let plan = Plan::of(&scene, method);
            let named: Vec<_> = plan.systems().flat_map(System::columns).collect();
            for table in engine.world().data.tables() {
                for (place, spec) in table.specs().iter().enumerate() {
                    let is_it = |&&(of, column): &&(&str, &str)| {
                        of == table.name() && (column == spec.name || column == "*")
                    };
                    let used = named.iter().find(is_it).is_some();
                    let kept = table.column(place).is_kept();
                    assert!(
                        used || !kept,
                        "{} {name}: nobody uses {}.{}",
                        scene.name,
                        table.name(),
                        spec.name
                    );
                }
            }
        }
    }
}

#[test]
fn systems_name_columns_that_there_are() {
    let engine = load(&open("pair"));
    for system in SYSTEMS {
        for (table, column) in system.columns() {
            let found = engine.world().data.table(table).expect("a table");
            assert!(
                column == "*" || found.place_of(column).is_some(),
                "{}: {table}.{column}",
                system.name
            );
        }
    }
}

#[test]
fn a_frictionless_ball_has_60_bytes_of_state() {
    let engine = load(&smooth_balls());
    let bodies = &engine.world().data.bodies;
    assert_eq!(bodies.row_bytes(), 60);
    assert_eq!(bodies.ids().bytes(), 0);
    assert!(bodies.orientation.is_empty());
    assert!(engine.explain().contains("A body has 60 bytes of state"));
}

#[test]
fn what_can_turn_a_ball_brings_back_its_turning() {
    assert!(left_out(&smooth_balls()).contains(&Part::Turning));
    let changed = |change: fn(&mut Scene)| {
        let mut scene = smooth_balls();
        change(&mut scene);
        left_out(&scene).contains(&Part::Turning)
    };
    assert!(!changed(|scene| scene.bodies[9].friction = 0.1));
    assert!(!changed(|scene| scene.bodies[9].static_friction = Some(0.1)));
    assert!(!changed(|scene| scene.bodies[9].angular_velocity = DVec3::X));
    assert!(!changed(
        |scene| scene.bodies[9].shape = open("stack").bodies[1].shape
    ));
    // A rough floor alone rubs nobody: a pair has the geometric mean.
    assert!(changed(|scene| scene.bodies[0].friction = 0.5));
}

#[test]
fn each_scene_leaves_out_what_it_does_not_have() {
    let has = |name: &str, part| !left_out(&open(name)).contains(&part);
    assert!(has("chain", Part::Joints) && has("ragdolls", Part::Limits));
    assert!(!has("ragdolls", Part::Rods) && has("cradle", Part::Rods));
    assert!(!has("balls", Part::Axes) && has("stack", Part::Axes));
    assert!(has("magnets", Part::Forces) && !has("stack", Part::Forces));
    assert!(has("bounce", Part::Bouncing) && !has("stack", Part::Bouncing));
    assert!(has("slopes", Part::Orientations) && has("slopes", Part::Friction));
}

#[test]
fn a_plan_is_the_same_whatever_was_asked_before() {
    let scene = open("ragdolls");
    let plan = Plan::of(&scene, Method::Corrected);
    assert_eq!(
        plan.joined(&Plan::of(&open("balls"), Method::Corrected)),
        plan.clone().with(Part::Bouncing)
    );
    for part in plan.left_out() {
        assert!(plan.clone().with(part).has(part));
    }
}

#[test]
fn columns_that_are_kept_have_the_bits_of_the_full_plan() {
    let full = |_: &Scene, method| Plan::full(method);
    let smooth = smooth_balls();
    for scene in scenes().chain([smooth]) {
        for (name, _) in METHODS {
            let settings = Settings::defaults().with_method(name);
            let mut full = PropertiesEngine::load_with(&scene, &settings, full).expect("it runs");
            let mut planned = PropertiesEngine::load(&scene, &settings).expect("it runs");
            for step in 0..300 {
                if step % 20 == 0 {
                    same_columns(&scene.name, step, &planned, &full);
                }
                full.step(scene.dt as f32);
                planned.step(scene.dt as f32);
            }
        }
    }
}

/// All columns of the first have the memory of those of the second.
#[track_caller]
fn same_columns(scene: &str, step: u32, planned: &PropertiesEngine, full: &PropertiesEngine) {
    let tables = planned.world().data.tables().into_iter();
    for (one, two) in tables.zip(full.world().data.tables()) {
        for (place, spec) in one.specs().iter().enumerate() {
            let (one_column, two_column) = (one.column(place), two.column(place));
            // Inertia in one number has no like in the full plan, and notes of visits differ where visits do.
            let notes = matches!(spec.name, "seen" | "changed") || one.name() == "touches";
            let has_like = !notes && !needs_of(one.name(), spec.name).contains(&Part::Round);
            if one_column.is_kept() && has_like {
                assert_eq!(
                    one_column.memory(),
                    two_column.memory(),
                    "{scene}, step {step}: {}.{}",
                    one.name(),
                    spec.name
                );
            }
        }
    }
}
