//! Bodies that come and go in mid-run, cells that are edited, the mouse; and everything that must be
//! refused.

use ch00_scenes::{
    Body, Cell, Edit, Engine, Pull, RemoveError, RowId, Scene, Settings, Shape, State, TableError,
};
use ch05_properties::PropertiesEngine;
use ch05_properties::columns::{AnyColumn, AnyTable};
use ch05_properties::plan::Part;
use ch05_properties::world::ChangeError;
use glam::{DVec3, Quat, Vec3};

fn open(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in")
}

fn load(scene: &Scene) -> PropertiesEngine {
    PropertiesEngine::load(scene, &Settings::defaults()).expect("it runs")
}

fn objects(scene: &Scene) -> Box<dyn Engine> {
    (ch04_ragdolls::ENGINE.load)(scene, &Settings::defaults()).expect("chapter 4 runs it")
}

fn run(engine: &mut dyn Engine, scene: &Scene, steps: u32) {
    for _ in 0..steps {
        engine.step(scene.dt as f32);
    }
}

fn hash(engine: &dyn Engine) -> u64 {
    let mut state = State::default();
    engine.read_state(&mut state);
    state.hash()
}

/// A ball without friction or spin, far from everything.
fn lone_ball() -> Body {
    let mut ball = Body::new(
        Shape::Sphere { radius: 0.2 },
        3.0,
        DVec3::new(80.0, 5.0, 0.0),
    );
    ball.friction = 0.0;
    ball
}

fn smooth_balls() -> Scene {
    let mut scene = open("balls", Some(20));
    for body in &mut scene.bodies {
        body.friction = 0.0;
        body.angular_velocity = DVec3::ZERO;
    }
    scene
}

fn edit(table: &str, column: &str, slot: u32, value: Cell) -> Edit {
    Edit {
        table: table.to_owned(),
        column: column.to_owned(),
        row: RowId::first(slot),
        value,
    }
}

#[test]
fn a_ball_thrown_in_flies_as_in_chapter_4() {
    let scene = open("balls", Some(30));
    let mut engines: [Box<dyn Engine>; 2] = [objects(&scene), Box::new(load(&scene))];
    for engine in &mut engines {
        run(engine.as_mut(), &scene, 90);
        let mut ball = Body::new(
            Shape::Sphere { radius: 0.3 },
            9.0,
            DVec3::new(0.0, 6.0, 0.0),
        );
        ball.linear_velocity = DVec3::new(1.0, -9.0, 0.5);
        ball.restitution = 0.5;
        assert_eq!(engine.add_body(&ball, scene.dt as f32), Ok(35));
        run(engine.as_mut(), &scene, 200);
    }
    let [one, two] = engines;
    assert_eq!(hash(one.as_ref()), hash(two.as_ref()));
}

#[test]
fn a_box_thrown_among_smooth_balls_brings_its_columns_with_it() {
    let scene = smooth_balls();
    let mut engines: [Box<dyn Engine>; 2] = [objects(&scene), Box::new(load(&scene))];
    for engine in &mut engines {
        run(engine.as_mut(), &scene, 90);
        let half_extents = DVec3::new(0.2, 0.3, 0.1);
        let mut body = Body::new(Shape::Box { half_extents }, 9.0, DVec3::new(0.1, 6.0, 0.0));
        body.angular_velocity = DVec3::new(3.0, 1.0, 2.0);
        engine
            .add_body(&body, scene.dt as f32)
            .expect("there is room");
        run(engine.as_mut(), &scene, 200);
    }
    let [one, two] = engines;
    assert_eq!(hash(one.as_ref()), hash(two.as_ref()));
}

#[test]
fn what_the_mouse_drags_moves_as_in_chapter_4() {
    for scene in [smooth_balls(), open("ragdolls", Some(2))] {
        let mut engines: [Box<dyn Engine>; 2] = [objects(&scene), Box::new(load(&scene))];
        for engine in &mut engines {
            run(engine.as_mut(), &scene, 60);
            for i in 0..60 {
                engine.pull(Some(Pull {
                    body: 7,
                    anchor: DVec3::new(0.05, 0.02, 0.0),
                    target: DVec3::new(0.3, 2.0 + 0.01 * f64::from(i), 0.1),
                }));
                run(engine.as_mut(), &scene, 1);
            }
            engine.pull(None);
            run(engine.as_mut(), &scene, 60);
        }
        let [one, two] = engines;
        assert_eq!(hash(one.as_ref()), hash(two.as_ref()), "{}", scene.name);
    }
}

#[test]
fn a_body_that_nobody_met_leaves_no_trace() {
    for name in ["balls", "stack", "ragdolls"] {
        let alone = open(name, None);
        let mut with_it = alone.clone();
        with_it.bodies.push(lone_ball());
        let (mut one, mut two) = (load(&alone), load(&with_it));
        run(&mut one, &alone, 100);
        run(&mut two, &with_it, 100);
        let last = alone.bodies.len();
        two.remove_body(last).expect("nothing holds it");
        run(&mut one, &alone, 200);
        run(&mut two, &with_it, 200);
        assert_eq!(hash(&one), hash(&two), "{name}");
    }
}

#[test]
fn removing_a_body_in_front_moves_the_others_up_and_changes_none() {
    let behind = open("balls", Some(40));
    let mut scene = behind.clone();
    scene.bodies.insert(0, lone_ball());
    let (mut one, mut two) = (load(&behind), load(&scene));
    run(&mut one, &behind, 150);
    run(&mut two, &scene, 150);
    let ids: Vec<RowId> = (1..46).map(RowId::first).collect();
    two.remove_body(0).expect("nothing holds it");
    assert!(
        ids.iter()
            .enumerate()
            .all(|(row, &id)| two.row_of("bodies", id) == Some(row))
    );
    assert_eq!(hash(&one), hash(&two));
    run(&mut one, &behind, 150);
    run(&mut two, &scene, 150);
    assert_eq!(hash(&one), hash(&two));
}

#[test]
fn a_new_body_in_an_old_slot_is_not_the_old_body() {
    let scene = open("balls", Some(10));
    let mut engine = load(&scene);
    let old = RowId::first(6);
    engine.remove_body(6).expect("nothing holds it");
    let row = engine
        .add_body(&lone_ball(), scene.dt as f32)
        .expect("there is room");
    let new = engine.row_ids("bodies", &[row])[0];
    assert_eq!((new.slot, new.generation), (6, 1));
    assert_eq!(engine.row_of("bodies", old), None);
    assert!(matches!(
        engine.world().row(old),
        Err(TableError::Stale { row, .. }) if row == old
    ));
    assert_eq!(
        engine
            .world_mut()
            .remove(old)
            .expect_err("it is gone")
            .to_string(),
        "table `bodies` has no row 6 any more"
    );
    run(&mut engine, &scene, 60);
}

#[test]
fn a_body_that_a_joint_holds_stays_until_the_joint_is_gone() {
    let scene = open("chain", None);
    let mut engine = load(&scene);
    run(&mut engine, &scene, 10);
    let before = hash(&engine);
    let held = RemoveError::HeldByJoint { body: 3, joint: 2 };
    assert_eq!(engine.remove_body(3), Err(held.clone()));
    assert_eq!(
        engine.world_mut().remove(RowId::first(3)),
        Err(ChangeError::Held(held))
    );
    assert_eq!(hash(&engine), before);

    let world = engine.world_mut();
    for row in (0..world.data.joints.rows()).rev() {
        let ends = [world.data.joints.parent[row], world.data.joints.child[row]];
        if ends.contains(&3) {
            let joint = world.data.joints.ids().id(row).expect("a row");
            world.remove_joint(joint).expect("it is there");
        }
    }
    world.remove(RowId::first(3)).expect("nothing holds it");
    let stale = world.remove_joint(RowId::first(2));
    assert!(
        matches!(stale, Err(ChangeError::Row(TableError::Stale { .. }))),
        "{stale:?}"
    );
    for _ in 0..300 {
        world.step(scene.dt as f32, |_, _| {});
    }
    assert!(world.data.bodies.position.iter().all(|p| p.is_finite()));
    // The ball, before the floor, hangs on nothing now: it lies.
    let ball = world.data.bodies.rows() - 2;
    let radius = world.data.bodies.size[ball].x;
    assert!((world.data.bodies.position[ball].y - radius).abs() < 0.01);
}

#[test]
fn limbs_can_be_cut_off() {
    let scene = open("ragdolls", Some(1));
    let mut engine = load(&scene);
    run(&mut engine, &scene, 30);
    let world = engine.world_mut();
    while world.data.joints.rows() > 0 {
        let row = world.data.joints.rows() / 2;
        let joint = world.data.joints.ids().id(row).expect("a row");
        world.remove_joint(joint).expect("it is there");
        for _ in 0..10 {
            world.step(scene.dt as f32, |_, _| {});
        }
    }
    assert_eq!((world.data.pins.rows(), world.data.turns.rows()), (0, 0));
    assert!(world.data.bodies.position.iter().all(|p| p.is_finite()));
}

#[test]
fn magnets_keep_their_bodies() {
    let mut engine = load(&open("magnets", None));
    let held = RemoveError::HeldByForce { body: 1, force: 0 };
    assert_eq!(engine.remove_body(1), Err(held.clone()));
    assert_eq!(
        engine.world_mut().remove(RowId::first(1)),
        Err(ChangeError::Held(held))
    );
}

#[test]
fn nobody_comes_or_goes_while_a_step_runs() {
    let scene = open("balls", Some(5));
    let mut engine = load(&scene);
    let mut refused = Vec::new();
    engine.world_mut().step(scene.dt as f32, |system, world| {
        let during = ChangeError::DuringStep { system };
        assert_eq!(world.add(&scene, &lone_ball()), Err(during.clone()));
        assert_eq!(world.remove(RowId::first(5)), Err(during.clone()));
        assert_eq!(world.remove_joint(RowId::first(0)), Err(during));
        let value = Cell::Scalar(0.5);
        assert!(
            world
                .edit(&edit("bodies", "restitution", 5, value))
                .is_err()
        );
        refused.push(system);
    });
    assert!(refused.contains(&"broad phase"));
    assert_eq!(engine.world().data.bodies.rows(), 10);
    engine
        .world_mut()
        .add(&scene, &lone_ball())
        .expect("the step is over");
}

#[test]
fn a_column_that_the_plan_left_out_says_why() {
    let engine = load(&smooth_balls());
    let asked = |column| {
        engine
            .world()
            .column("bodies", column)
            .map(AnyColumn::count)
    };
    assert_eq!(asked("position"), Ok(25));
    let error = asked("orientation").expect_err("it was left out");
    assert_eq!(
        error.to_string(),
        "column `bodies.orientation` was left out of this scene's plan: nothing is turned and nothing can turn"
    );
    assert!(matches!(error, TableError::LeftOut { .. }));
    assert!(matches!(
        asked("colour"),
        Err(TableError::UnknownColumn { .. })
    ));
    let table = engine.world().column("planets", "position").map(|_| ());
    assert!(matches!(table, Err(TableError::UnknownTable { .. })));
    assert!(matches!(
        engine.cells("bodies", "orientation", &[0]),
        Err(TableError::LeftOut { .. })
    ));
}

#[test]
fn a_body_that_is_moved_by_hand_keeps_its_velocity_and_an_undo_brings_it_back() {
    let scene = open("balls", Some(10));
    let mut engine = load(&scene);
    run(&mut engine, &scene, 20);
    let before = engine.world().velocity(7);
    let to = Cell::Vector([0.1, 9.0, 0.2]);
    let old = engine
        .edit(&edit("bodies", "position", 7, to))
        .expect("it can be edited");
    assert_eq!(
        engine.world().data.bodies.position[7],
        Vec3::new(0.1, 9.0, 0.2)
    );
    let after = engine.world().velocity(7);
    // Writing p* and reading it back rounds v by 9 m · 2⁻²³ · 60 Hz.
    assert!((after.v - before.v).length() < 1e-4, "{before:?} {after:?}");
    let there = engine
        .edit(&edit("bodies", "position", 7, old))
        .expect("and again");
    assert_eq!(there, to);
    assert_eq!(
        engine.world().data.bodies.position[7]
            .to_array()
            .map(Cell::Scalar),
        {
            let Cell::Vector(old) = old else {
                panic!("a vector")
            };
            old.map(Cell::Scalar)
        }
    );
    run(&mut engine, &scene, 60);
}

#[test]
fn a_floor_that_is_moved_by_hand_is_found_where_it_is() {
    let mut scene = open("bounce", None);
    scene.bodies[1].restitution = 0.0;
    let mut engine = load(&scene);
    run(&mut engine, &scene, 300);
    let static_row = (0..2).find(|&row| engine.world().data.bodies.inverse_mass[row] == 0.0);
    let floor = static_row.expect("a floor");
    let p = engine.world().data.bodies.position[floor] - Vec3::Y;
    let to = Cell::Vector(p.to_array());
    engine
        .edit(&edit("bodies", "position", floor as u32, to))
        .expect("it can be edited");
    let ball = 1 - floor;
    let height = |engine: &PropertiesEngine| engine.world().data.bodies.position[ball].y;
    let lowest = (0..400).fold(height(&engine), |lowest: f32, _| {
        run(&mut engine, &scene, 1);
        lowest.min(height(&engine))
    });
    let radius = engine.world().data.bodies.size[ball].x;
    let top = p.y + engine.world().data.bodies.size[floor].y;
    assert!(
        (lowest - top - radius).abs() < 0.2,
        "{lowest} {top} {radius}"
    );
}

#[test]
fn cells_take_no_nonsense() {
    let scene = open("balls", Some(5));
    let mut engine = load(&scene);
    let before = hash(&engine);
    let mut refused = |column: &str, value: Cell| {
        engine
            .edit(&edit("bodies", column, 5, value))
            .expect_err("it makes no sense")
            .to_string()
    };
    let texts = [
        refused("position", Cell::Vector([f32::NAN, 0.0, 0.0])),
        refused("position", Cell::Scalar(1.0)),
        refused("orientation", Cell::Quaternion([0.0; 4])),
        refused("restitution", Cell::Scalar(1.5)),
        refused("friction", Cell::Scalar(-0.1)),
        refused("inverse_mass", Cell::Scalar(1.0)),
        refused("acceleration", Cell::Vector([0.0; 3])),
    ];
    assert_eq!(
        texts[0],
        "column `bodies.position`: a number must be finite"
    );
    assert_eq!(
        texts[2],
        "column `bodies.orientation`: its length is 0, not 1"
    );
    assert!(texts[5].contains("can't be edited"), "{}", texts[5]);
    assert!(texts[6].contains("left out"), "{}", texts[6]);
    let gone = engine.edit(&edit("bodies", "position", 99, Cell::Vector([0.0; 3])));
    assert!(matches!(gone, Err(TableError::Stale { .. })));
    assert_eq!(hash(&engine), before);
}

#[test]
fn an_orientation_by_hand_is_made_a_unit() {
    let scene = open("stack", None);
    let mut engine = load(&scene);
    let q = Quat::from_rotation_y(0.4) * 1.004;
    let value = Cell::Quaternion(q.to_array());
    engine
        .edit(&edit("bodies", "orientation", 1, value))
        .expect("nearly a unit");
    assert!(engine.world().data.bodies.orientation[1].is_normalized());
    run(&mut engine, &scene, 30);
}

#[test]
fn a_wider_plan_changes_no_bit() {
    let scene = smooth_balls();
    let (mut one, mut two) = (load(&scene), load(&scene));
    run(&mut one, &scene, 100);
    run(&mut two, &scene, 100);
    let plan = two
        .world()
        .plan
        .clone()
        .with(Part::Joints)
        .with(Part::Mouse)
        .with(Part::Friction);
    two.world_mut().widen(&scene, &plan);
    run(&mut one, &scene, 200);
    run(&mut two, &scene, 200);
    assert_eq!(
        one.world().data.bodies.position.bytes(),
        two.world().data.bodies.position.bytes()
    );
}
