//! Cells that are edited, and the mouse.

use ch00_scenes::{Cell, Engine, Pull, TableError};
use ch05_properties::PropertiesEngine;
use ch05_properties::columns::AnyColumn;
use ch05_properties::plan::Part;
use glam::{DVec3, Quat, Vec3};

use crate::{edit, hash, load, objects, open, run, smooth_balls};

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
