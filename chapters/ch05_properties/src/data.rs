//! All state, in one nested container: `data.bodies.position[i]`, `data.joints.parent[j]`.
//!
//! A table is stated in a file of its own. Some columns are state, which the next step needs; the others
//! are notes that a step makes for itself.

mod bodies;
mod contacts;
mod forces;
mod joints;
mod motions;

pub use bodies::{BALL, Bodies, Body, shape_columns, shape_of};
pub use contacts::{Contact, Contacts, Touch, Touches};
pub use forces::{FixedPoint, FixedPoints, Pole, Poles, Push, Pushes, Spring, Springs};
pub use joints::{
    Joint, Joints, Limit, Limits, NONE, Pin, Pins, Rod, Rods, Tree, Trees, Turn, Turns, bound_code,
    bound_of, limit_columns, limits_of,
};
pub use motions::{Motion, Motions};

use ch00_scenes::TableError;

use crate::columns::AnyTable;

// ANCHOR: data
/// The container.
#[derive(Clone, Debug, Default)]
pub struct Data {
    /// What moves, and what it moves against.
    pub bodies: Bodies,
    /// The bodies again, row by row: what they go through while contacts and joints are resolved.
    pub motions: Motions,
    /// Where bodies touch.
    pub contacts: Contacts,
    /// The contacts again, by pairs of bodies.
    pub touches: Touches,
    /// What joins bodies, in the order in which a step visits it.
    pub joints: Joints,
    /// Joints that are a point.
    pub pins: Pins,
    /// Joints that are a distance.
    pub rods: Rods,
    /// Joints that limit angles.
    pub limits: Limits,
    /// The turns that these limit, three each.
    pub turns: Turns,
    /// Which joints make a tree.
    pub trees: Trees,
    /// Ends of magnets.
    pub poles: Poles,
    /// Bodies that hang on a point.
    pub fixed_points: FixedPoints,
    /// Forces that stay the same.
    pub pushes: Pushes,
    /// The mouse.
    pub springs: Springs,
}
// ANCHOR_END: data

impl Data {
    /// All tables, in order.
    #[must_use]
    pub fn tables(&self) -> [&dyn AnyTable; 14] {
        [
            &self.bodies,
            &self.motions,
            &self.contacts,
            &self.touches,
            &self.joints,
            &self.pins,
            &self.rods,
            &self.limits,
            &self.turns,
            &self.trees,
            &self.poles,
            &self.fixed_points,
            &self.pushes,
            &self.springs,
        ]
    }

    /// The same, to be changed.
    pub fn tables_mut(&mut self) -> [&mut dyn AnyTable; 14] {
        [
            &mut self.bodies,
            &mut self.motions,
            &mut self.contacts,
            &mut self.touches,
            &mut self.joints,
            &mut self.pins,
            &mut self.rods,
            &mut self.limits,
            &mut self.turns,
            &mut self.trees,
            &mut self.poles,
            &mut self.fixed_points,
            &mut self.pushes,
            &mut self.springs,
        ]
    }

    /// A table by its name.
    ///
    /// # Errors
    /// [`TableError::UnknownTable`] that lists the known ones.
    pub fn table(&self, name: &str) -> Result<&dyn AnyTable, TableError> {
        let tables = self.tables();
        let names = tables.map(AnyTable::name);
        let found = tables.into_iter().find(|table| table.name() == name);
        found.ok_or_else(|| TableError::unknown_table(name, names))
    }

    /// The same, to be changed.
    ///
    /// # Errors
    /// [`TableError::UnknownTable`] that lists the known ones.
    pub fn table_mut(&mut self, name: &str) -> Result<&mut dyn AnyTable, TableError> {
        let names = self.tables().map(AnyTable::name);
        let mut tables = self.tables_mut().into_iter();
        tables
            .find(|table| table.name() == name)
            .ok_or_else(|| TableError::unknown_table(name, names))
    }
}

/// Where a table has a column.
pub(crate) fn place_of(table: &dyn AnyTable, column: &str) -> Result<usize, TableError> {
    table.place_of(column).ok_or_else(|| {
        let known = table.specs().iter().map(|spec| spec.name);
        TableError::unknown_column(table.name(), column, known)
    })
}
