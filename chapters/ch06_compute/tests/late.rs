//! What the overlay sees of a run on the device: columns by name, some frames late, and only while somebody
//! looks at them. Rows for drawing are written for a window's device alone.
#![cfg(feature = "window")]

use std::time::{Duration, Instant};

use ch00_scenes::{BODIES, ColumnData, Engine, Layer, Scene, Settings, State, TableError};
use ch06_compute::compute::ComputeEngine;

const DT: f32 = 1.0 / 60.0;

fn engine(name: &str, count: u64) -> ComputeEngine {
    let scene = Scene::open(name, Some(count), None).expect("a built-in scene");
    ComputeEngine::load(&scene, &Settings::defaults())
        .expect("a graphics device, or package mesa-vulkan-drivers")
}

/// Glances until the state is there, as frames do.
fn look(engine: &mut ComputeEngine) -> State {
    let end = Instant::now() + Duration::from_mins(5);
    let mut state = State::default();
    while Instant::now() < end {
        if engine.glance(&mut state).is_some() {
            return state;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    panic!("no state has come");
}

fn is_on_the_way(cells: &Result<ColumnData, TableError>) -> bool {
    matches!(cells, Err(TableError::OnTheWay { .. }))
}

#[test]
fn a_column_comes_down_with_the_state_of_its_step_once_somebody_has_asked_for_it() {
    let mut engine = engine("stack", 3);
    for _ in 0..4 {
        engine.step(DT);
    }
    let cells = |engine: &ComputeEngine| engine.cells("rigids", "position", &[1, 2]);
    assert!(!engine.lacks_cells());
    assert!(is_on_the_way(&cells(&engine)));
    assert!(engine.lacks_cells());
    let state = look(&mut engine);
    let of = |row: usize| state.position[row].as_vec3().to_array();
    let expected = ColumnData::Vector(vec![of(1), of(2)]);
    assert_eq!(cells(&engine), Ok(expected));
    assert!(!engine.lacks_cells());
}

#[test]
fn a_column_that_nobody_looks_at_any_more_stays_on_the_device() {
    let mut engine = engine("pile", 20);
    let cells = |engine: &ComputeEngine| engine.cells("walls", "restitution", &[0]);
    assert!(is_on_the_way(&cells(&engine)));
    look(&mut engine);
    assert!(cells(&engine).is_ok());
    for _ in 0..6 {
        engine.step(DT);
        look(&mut engine);
    }
    assert!(!engine.lacks_cells());
    assert!(
        is_on_the_way(&cells(&engine)),
        "its rows are of an older step"
    );
}

#[test]
fn all_columns_can_be_looked_at_by_name() {
    for (scene, count) in [("pile", 20), ("ragdoll_field", 1)] {
        let mut engine = engine(scene, count);
        engine.step(DT);
        let tables = engine.tables();
        let names: Vec<_> = tables.iter().map(|table| table.name).collect();
        assert_eq!(names[0], BODIES);
        assert!(names.len() > 10, "{names:?}");
        let ask = |engine: &ComputeEngine| {
            let columns = tables.iter().flat_map(|table| {
                let of = move |column: &ch00_scenes::ColumnInfo| (table, column.name);
                table.columns.iter().map(of)
            });
            let cells: Vec<_> = columns
                .map(|(table, column)| engine.cells(table.name, column, &[0]))
                .collect();
            cells
        };
        ask(&engine);
        look(&mut engine);
        for cells in ask(&engine) {
            assert_eq!(cells.map(|cells| cells.len()), Ok(1));
        }
    }
}

#[test]
fn an_unknown_table_is_answered_with_those_that_there_are() {
    let error = engine("pile", 5)
        .cells("rigids", "position", &[0])
        .unwrap_err();
    let text = error.to_string();
    assert!(
        text.contains("there are: bodies, ") && text.contains("movers_a"),
        "{text}"
    );
}

#[test]
fn cells_of_the_grid_and_frames_are_drawn_from_the_state_that_came_down() {
    let mut engine = engine("pile", 20);
    engine.step(DT);
    look(&mut engine);
    for &layer in engine.layers() {
        assert!(!engine.layer(layer).lines.is_empty(), "{layer:?}");
    }
    assert!(engine.layer(Layer::Limits).lines.is_empty());
}

#[test]
fn what_there_is_room_for_and_what_was_refused_is_said() {
    for (scene, what) in [
        ("pile", "neighbours each; more was made 0 time(s)"),
        ("stack", "room was made 0 time(s)"),
    ] {
        let text = engine(scene, 5).explain();
        assert!(text.contains(what), "{text}");
    }
}
