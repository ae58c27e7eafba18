//! What is done to the tables: functions of the columns that they name.

use ch01_hierarchy::Transform;
use ch01_hierarchy::styles::formulas;
use glam::{Quat, Vec3};

// ANCHOR: spinning
use super::tables::Spins;
// ANCHOR_END: spinning
use super::tables::{Circles, ROOT, Things};

// ANCHOR: circle
/// Moves what is on a circle: writes `places`, the positions in the parents' frames.
pub fn circle(circles: &mut Circles, places: &mut [Vec3], dt: f32) {
    let rows = circles.thing.iter().zip(circles.radius.iter());
    let motion = circles.angle.iter_mut().zip(circles.rate.iter());
    for ((&thing, &radius), (angle, &rate)) in rows.zip(motion) {
        *angle = formulas::advance(*angle, rate, dt);
        places[thing as usize] = formulas::circle(radius, *angle);
    }
}
// ANCHOR_END: circle

// ANCHOR: spinning
/// Turns what spins: writes `turns`, the orientations in the parents' frames.
pub fn spin(spins: &mut Spins, turns: &mut [Quat], dt: f32) {
    let motion = spins.angle.iter_mut().zip(spins.rate.iter());
    for (&thing, (angle, &rate)) in spins.thing.iter().zip(motion) {
        *angle = formulas::advance(*angle, rate, dt);
        turns[thing as usize] = formulas::turn(*angle);
    }
}
// ANCHOR_END: spinning

// ANCHOR: glow
/// Lets the glow follow the rates of spin.
pub fn glow(rates: &[f32], glows: &mut [f32], dt: f32) {
    for (glow, &rate) in glows.iter_mut().zip(rates) {
        *glow = formulas::follow(*glow, rate, dt);
    }
}
// ANCHOR_END: glow

// ANCHOR: follow
/// World transforms from the parents' and the local ones, which come before them.
pub fn follow_parents(things: &mut Things) {
    let (position, orientation) = (&mut things.position[..], &mut things.orientation[..]);
    let local_place = things.local_position.iter().copied();
    let local = local_place.zip(things.local_orientation.iter().copied());
    for (row, (&parent, (place, turn))) in things.parent.iter().zip(local).enumerate() {
        let local = Transform::new(place, turn);
        let world = match parent {
            ROOT => local,
            _ => Transform::new(position[parent as usize], orientation[parent as usize]) * local,
        };
        position[row] = world.translation;
        orientation[row] = world.rotation;
    }
}
// ANCHOR_END: follow

/// Where each row will be when those that are not kept are gone; of those it says nothing useful.
pub fn rows_after(keep: &[bool]) -> Vec<u32> {
    let mut next = 0;
    let rows = keep.iter().map(|&stays| {
        let row = next;
        next += u32::from(stays);
        row
    });
    rows.collect()
}

/// Which rows of a behaviour stay: those whose thing does.
pub fn keep_with(things: &[u32], keep: &[bool]) -> Vec<bool> {
    things.iter().map(|&thing| keep[thing as usize]).collect()
}

/// Lets a column of rows follow them to where they have moved.
pub fn rename(rows: &mut [u32], moved: &[u32]) {
    for row in rows.iter_mut().filter(|row| **row != ROOT) {
        *row = moved[*row as usize];
    }
}
