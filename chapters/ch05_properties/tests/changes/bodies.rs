//! Bodies that come and go in mid-run.

use ch00_scenes::{Body, Cell, Engine, RemoveError, RowId, Shape, TableError};
use ch05_properties::columns::AnyTable;
use ch05_properties::world::ChangeError;
use glam::DVec3;

use crate::{edit, hash, load, lone_ball, objects, open, run, smooth_balls};

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
