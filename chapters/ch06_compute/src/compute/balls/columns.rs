//! The columns of balls: made, and filled.

use ch00_scenes::State;
use glam::{Quat, Vec4};

use super::super::scan::{blocks, scan_of};
use super::ROOM;
use super::sides::Names;
use crate::bodies::Bodies;
use crate::grid::{Grid, margin_of};
use crate::rows::{Ball, Drawn, GridOf, Held, Mouse, Mover, Place, STATUS, Scan, Seen, Step, Wall};
use crate::rules::MARGIN;
use crate::stream::{Columns, StreamError};

/// Edge of a cell, in radii of the widest ball: measured on an H200. Smaller cells hold fewer balls that are
/// too far away, and are more.
const EDGE: f32 = 2.2;

/// The rows of the bodies that move.
#[must_use]
pub fn moving(bodies: &Bodies) -> Vec<usize> {
    (0..bodies.rows())
        .filter(|&row| !bodies.is_static(row))
        .collect()
}

/// The static bodies.
#[must_use]
pub fn walls_of(bodies: &Bodies) -> Vec<Wall> {
    let rows = (0..bodies.rows()).filter(|&row| bodies.is_static(row));
    rows.map(|row| Wall {
        position: bodies.place[row].position,
        kind: bodies.solid[row].kind,
        attitude: bodies.attitude[row],
        size: bodies.solid[row].size,
        restitution: bodies.material[row].restitution,
        friction: bodies.material[row].friction,
        static_friction: bodies.material[row].static_friction,
        id: row as u32,
        spare: 0,
    })
    .collect()
}

/// Whether the surfaces of all bodies that move are alike.
#[must_use]
pub fn is_alike(bodies: &Bodies) -> bool {
    let mut moving = (0..bodies.rows()).filter(|&row| !bodies.is_static(row));
    let first = moving.next().map(|row| bodies.material[row]);
    moving.all(|row| Some(bodies.material[row]) == first)
}

/// The grid of a scene's balls.
#[must_use]
pub fn grid_of(bodies: &Bodies, moving: &[usize], walls: usize) -> GridOf {
    let places: Vec<Place> = moving.iter().map(|&row| bodies.place[row]).collect();
    let widest = places.iter().map(|place| place.reach).fold(0.0, f32::max);
    let grid = Grid::with_edge(EDGE * widest.max(f32::MIN_POSITIVE), &places);
    let [slots_x, slots_y, slots_z] = grid.slots;
    GridOf {
        edge: grid.edge,
        slots_x,
        slots_y,
        slots_z,
        rows: moving.len() as u32,
        capacity: moving.len().max(1) as u32,
        room: ROOM as u32,
        walls: walls as u32,
        starts: grid.count() as u32 + 2,
        margin: MARGIN,
        most_margin: margin_of(widest),
        widest,
        ..GridOf::default()
    }
}

/// The scan of a grid: it writes no starts in a step after one that had no room.
#[must_use]
pub fn scan_in(grid: &GridOf) -> Scan {
    Scan {
        room: grid.room,
        ..scan_of(grid.starts as usize)
    }
}

/// Makes all columns.
///
/// # Errors
/// [`StreamError::TooLarge`], [`StreamError::OutOfMemory`].
pub fn allocate(
    columns: &mut Columns,
    grid: &GridOf,
    walls: &[Wall],
    bodies: usize,
) -> Result<(), StreamError> {
    let (rows, starts) = (grid.capacity as usize, grid.starts as usize);
    for side in ["a", "b"] {
        columns.add::<Place>(&format!("places_{side}"), rows)?;
        columns.add::<Mover>(&format!("movers_{side}"), rows)?;
        columns.add::<Quat>(&format!("attitudes_{side}"), rows)?;
        columns.add::<Ball>(&format!("balls_{side}"), rows)?;
        columns.add::<Held>(&format!("helds_{side}"), rows)?;
        columns.add::<u32>(&format!("neighbour_counts_{side}"), rows)?;
        columns.add::<u32>(&format!("neighbours_{side}"), rows * grid.room as usize)?;
        columns.add::<Vec4>(&format!("impulses_{side}"), rows * grid.room as usize)?;
        for name in ["places", "movers", "attitudes", "balls"] {
            columns.set_rows(&format!("{name}_{side}"), grid.rows as usize)?;
        }
    }
    columns.add::<f32>("approaches", rows * grid.room as usize)?;
    for name in ["slots", "order", "old_rows"] {
        columns.add::<u32>(name, rows)?;
    }
    for name in ["counts", "starts"] {
        columns.add::<u32>(name, starts)?;
    }
    columns.add::<u32>("blocks", blocks(starts))?;
    columns.add::<u32>("fastest", 2)?;
    columns.add::<u32>("status", STATUS.len())?;
    let mut status = [0; STATUS.len()];
    status[2] = u32::MAX;
    columns.write("status", &status)?;
    columns.add::<Wall>("walls", walls.len().max(1))?;
    columns.write("walls", walls)?;
    columns.add::<Drawn>("drawn", bodies)?;
    columns.add::<Seen>("seen", bodies)?;
    columns.add_uniform("mouse", &Mouse::default())?;
    columns.add_uniform("grid", grid)?;
    columns.add_uniform("scan", &scan_in(grid))?;
    columns.add_uniform("step", &Step::default())
}

/// Writes the rows of all balls, in the order of the scene.
///
/// # Errors
/// A lost device.
pub fn write(
    columns: &mut Columns,
    names: Names,
    bodies: &Bodies,
    moving: &[usize],
) -> Result<(), StreamError> {
    let places: Vec<Place> = moving.iter().map(|&row| bodies.place[row]).collect();
    let attitudes: Vec<Quat> = moving.iter().map(|&row| bodies.attitude[row]).collect();
    let movers: Vec<Mover> = moving.iter().map(|&row| mover_of(bodies, row)).collect();
    let balls: Vec<Ball> = moving.iter().map(|&row| ball_of(bodies, row)).collect();
    columns.write(names.places, &places)?;
    columns.write(names.movers, &movers)?;
    columns.write(names.attitudes, &attitudes)?;
    columns.write(names.balls, &balls)
}

fn mover_of(bodies: &Bodies, row: usize) -> Mover {
    Mover {
        velocity: bodies.motion[row].velocity,
        shares: 1.0,
        angular_velocity: bodies.spin[row].angular_velocity,
        inverse_mass: bodies.spin[row].inverse_mass,
    }
}

fn ball_of(bodies: &Bodies, row: usize) -> Ball {
    Ball {
        id: row as u32,
        restitution: bodies.material[row].restitution,
        friction: bodies.material[row].friction,
        static_friction: bodies.material[row].static_friction,
    }
}

/// Writes the rows for drawing as if all had stood still.
///
/// # Errors
/// A lost device.
pub fn write_drawn(columns: &mut Columns, state: &State) -> Result<(), StreamError> {
    let drawn: Vec<Drawn> = (0..state.len()).map(|i| drawn_at(state, i)).collect();
    let seen: Vec<Seen> = (0..state.len()).map(|i| seen_at(state, i)).collect();
    columns.write("drawn", &drawn)?;
    columns.write("seen", &seen)
}

/// A body that stands still, as it is drawn.
fn drawn_at(state: &State, body: usize) -> Drawn {
    let (position, orientation) = (
        state.position[body].as_vec3(),
        state.orientation[body].as_quat(),
    );
    Drawn {
        position,
        orientation,
        position_last: position,
        orientation_last: orientation,
        ..Drawn::default()
    }
}

fn seen_at(state: &State, body: usize) -> Seen {
    Seen {
        velocity: state.linear_velocity[body].as_vec3(),
        angular_velocity: state.angular_velocity[body].as_vec3(),
        ..Seen::default()
    }
}
