//! Narrow phase: where exactly the pairs touch, by chapter 3's functions over shapes and poses.

use ch03_collision::Margins;
use ch03_collision::narrow::{Placed, touch};
use glam::{Quat, Vec3};

use super::broad_phase::ahead_of;
use super::or_zero;
use crate::columns::{AnyTable, Column};
use crate::data::{Bodies, Contacts, shape_of};

/// What the contacts of the last step carried, in order of body 1, body 2 and feature.
#[derive(Clone, Debug, Default)]
pub struct Carried {
    a: Column<u32>,
    b: Column<u32>,
    feature: Column<u32>,
    support: Column<f32>,
    rub: Column<Vec3>,
}

// ANCHOR: find
/// Fills the table with the contacts of these pairs; what a step notes of them comes later. Gives how many
/// touches the iterations did not get to the end of.
pub fn find(
    bodies: &Bodies,
    pairs: &[(usize, usize)],
    margins: Margins,
    contacts: &mut Contacts,
) -> usize {
    contacts.clear();
    let mut unsure = 0;
    for &(a, b) in pairs {
        let shapes = [a, b].map(|row| shape_of(bodies.shape[row], bodies.size[row]));
        let one = placed(bodies, a, &shapes[0]);
        let two = placed(bodies, b, &shapes[1]);
        let Some(touch) = touch(&one, &two, margin(bodies, a, b, margins)) else {
            continue;
        };
        unsure += usize::from(!touch.converged);
        let mut spots = [0, 1, 2, 3];
        let spots = &mut spots[..touch.spots().len()];
        spots.sort_unstable_by_key(|&spot| touch.spots()[spot].feature);
        for &spot in &*spots {
            let spot = touch.spots()[spot];
            contacts.a.push(a as u32);
            contacts.b.push(b as u32);
            contacts.feature.push(spot.feature);
            contacts.normal.push(touch.normal);
            contacts.depth.push(spot.depth);
            contacts.point.push(spot.point);
        }
    }
    let rows = contacts.a.len();
    contacts.support.fill_rows(rows, 0.0);
    contacts.rub.fill_rows(rows, Vec3::ZERO);
    contacts.ids_mut().set_rows(rows);
    unsure
}
// ANCHOR_END: find

/// A body as the narrow phase sees it.
#[must_use]
pub fn placed<'a>(
    bodies: &Bodies,
    row: usize,
    shape: &'a ch00_maths::f32::shape::Shape,
) -> Placed<'a> {
    let q: Quat = or_zero(&bodies.orientation, row);
    Placed {
        shape,
        p: bodies.position[row],
        q,
        p_before: bodies.last_position[row],
    }
}

/// How far from touching a pair may be and still make a contact, m.
fn margin(bodies: &Bodies, a: usize, b: usize, margins: Margins) -> f32 {
    let is_static = |row: usize| bodies.inverse_mass[row] == 0.0;
    if is_static(a) || is_static(b) {
        margins.obstacle
    } else {
        margins.moving + ahead_of(bodies, a, margins) + ahead_of(bodies, b, margins)
    }
}

// ANCHOR: carry
/// Takes what the contacts carry out of the table, before the next ones come in.
pub fn carry(contacts: &mut Contacts, carried: &mut Carried) {
    contacts.a.trade(&mut carried.a);
    contacts.b.trade(&mut carried.b);
    contacts.feature.trade(&mut carried.feature);
    contacts.support.trade(&mut carried.support);
    contacts.rub.trade(&mut carried.rub);
}

/// Hands it on to those that are still there. Both lists are in order, so one walk finds them.
pub fn remember(
    Contacts {
        a,
        b,
        feature,
        support,
        rub,
        ..
    }: &mut Contacts,
    carried: &Carried,
) {
    let old_key = |old: usize| (carried.a[old], carried.b[old], carried.feature[old]);
    let count = carried.a.len();
    let mut old = 0;
    for i in 0..a.len() {
        let key = (a[i], b[i], feature[i]);
        while old < count && old_key(old) < key {
            old += 1;
        }
        if old < count && old_key(old) == key {
            support[i] = carried.support[old];
            if let Some(rub) = rub.get_mut(i) {
                *rub = carried.rub[old];
            }
            old += 1;
        }
    }
}
// ANCHOR_END: carry
