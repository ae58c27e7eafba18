//! The scene as properties: a table of things and a table for each behaviour, whose rows say which
//! thing they move. What is done to them is functions, in [`systems`].

pub mod systems;
pub mod tables;

use ch01_hierarchy::Transform;
use ch01_hierarchy::styles::items::{Item, Kind};
use ch01_hierarchy::styles::living::Living;
use ch01_hierarchy::styles::{Bytes, Style, formulas};
use ch05_properties::columns::{AnyTable, RowId, Table};
use glam::{Quat, Vec3};

use tables::{Circle, Circles, ROOT, Thing, Things};
// ANCHOR: spinning
use tables::{Spin, Spins};
// ANCHOR_END: spinning

// ANCHOR: world
/// The scene: three tables, and nothing else.
#[derive(Default)]
pub struct World {
    things: Things,
    circles: Circles,
    // ANCHOR: spinning
    spins: Spins,
    // ANCHOR_END: spinning
}
// ANCHOR_END: world

impl World {
    // ANCHOR: make
    /// A thing at the end of its table, which is after its parent, and its behaviours' rows.
    fn add(&mut self, item: &Item, parent: u32) -> RowId {
        let thing = self.things.rows() as u32;
        if item.kind != Kind::Spinner {
            self.circles.push(Circle {
                thing,
                radius: item.radius,
                angle: item.phase,
                rate: item.rate,
            });
        }
        // ANCHOR: spinning
        if item.kind.spins() {
            self.spins.push(Spin {
                thing,
                rate: item.spin,
                ..Spin::default()
            });
        }
        // ANCHOR_END: spinning
        let place = formulas::circle(item.radius, item.phase);
        self.things.push(Thing {
            parent,
            local_position: place,
            local_orientation: Quat::IDENTITY,
            position: place,
            orientation: Quat::IDENTITY,
        })
    }
    // ANCHOR_END: make

    #[inline]
    fn row(&self, id: RowId) -> Option<usize> {
        self.things.ids().row(id)
    }

    #[inline]
    fn pose(&self, row: usize) -> Transform {
        Transform::new(self.things.position[row], self.things.orientation[row])
    }
}

impl Style for World {
    const NAME: &'static str = "properties";

    fn build(items: &[Item]) -> Self {
        Self::populate(items).0
    }

    // ANCHOR: update
    fn update(&mut self, dt: f32) {
        systems::circle(&mut self.circles, &mut self.things.local_position, dt);
        // ANCHOR: spinning
        systems::spin(&mut self.spins, &mut self.things.local_orientation, dt);
        // ANCHOR_END: spinning
        // ANCHOR: glow
        systems::glow(&self.spins.rate, &mut self.spins.glow, dt);
        // ANCHOR_END: glow
        systems::follow_parents(&mut self.things);
    }
    // ANCHOR_END: update

    // ANCHOR: gather
    fn gather_positions(&self, column: &mut Vec<[f32; 3]>) {
        column.clear();
        column.extend_from_slice(bytemuck::cast_slice(self.things.position.bytes()));
    }
    // ANCHOR_END: gather

    fn gather_poses(&self, column: &mut Vec<Transform>) {
        column.clear();
        column.extend((0..self.things.rows()).map(|row| self.pose(row)));
    }

    // ANCHOR: glow
    fn gather_glow(&self, column: &mut Vec<f32>) {
        column.clear();
        column.resize(self.things.rows(), 0.0);
        for (&thing, &glow) in self.spins.thing.iter().zip(self.spins.glow.iter()) {
            column[thing as usize] = glow;
        }
    }
    // ANCHOR_END: glow

    fn bytes(items: &[Item]) -> Bytes {
        let (vector, quaternion) = (size_of::<Vec3>(), size_of::<Quat>());
        Bytes::sum(items, |item| {
            let mut update = size_of::<Thing>();
            if item.kind != Kind::Spinner {
                update += size_of::<Circle>() + vector;
            }
            if item.kind.spins() {
                // The rate is read by two systems.
                update += size_of::<Spin>() + size_of::<f32>() + quaternion;
            }
            Bytes {
                update,
                gather: vector,
            }
        })
    }
}

impl Living for World {
    type Id = RowId;

    fn populate(items: &[Item]) -> (Self, Vec<RowId>) {
        let mut world = Self::default();
        let ids = items.iter().map(|item| {
            // Nothing was removed yet: the row is the item's index.
            let parent = item.parent.map_or(ROOT, |parent| parent as u32);
            world.add(item, parent)
        });
        let ids = ids.collect();
        (world, ids)
    }

    #[inline]
    fn frames(&self, id: RowId) -> Option<(Transform, Transform)> {
        let row = self.row(id)?;
        let things = &self.things;
        let local = Transform::new(things.local_position[row], things.local_orientation[row]);
        Some((local, self.pose(row)))
    }

    #[inline]
    fn position(&self, id: RowId) -> Option<Vec3> {
        Some(self.things.position[self.row(id)?])
    }

    // ANCHOR: count
    fn count_brighter(&self, threshold: f32) -> usize {
        let glows = self.spins.glow.iter();
        glows.filter(|glow| **glow > threshold).count()
    }
    // ANCHOR_END: count

    fn insert(&mut self, item: &Item, parent: RowId) -> RowId {
        let parent = self.row(parent).expect("the parent was removed");
        self.add(item, parent as u32)
    }

    // ANCHOR: remove
    fn remove(&mut self, ids: &[RowId]) {
        let mut keep = vec![true; self.things.rows()];
        for row in ids.iter().filter_map(|id| self.row(*id)) {
            keep[row] = false;
        }
        let moved = systems::rows_after(&keep);
        self.things.retain_rows(&keep);
        systems::rename(&mut self.things.parent, &moved);

        let circles = systems::keep_with(&self.circles.thing, &keep);
        self.circles.retain_rows(&circles);
        systems::rename(&mut self.circles.thing, &moved);
        // ANCHOR: spinning

        let spins = systems::keep_with(&self.spins.thing, &keep);
        self.spins.retain_rows(&spins);
        systems::rename(&mut self.spins.thing, &moved);
        // ANCHOR_END: spinning
    }
    // ANCHOR_END: remove

    fn bytes_to_count(items: &[Item]) -> usize {
        let spins = items.iter().filter(|item| item.kind.spins());
        spins.count() * size_of::<f32>()
    }
}
