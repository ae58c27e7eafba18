//! A table, and the macro that states one.

use ch00_scenes::{Kind, RowId};

use super::column::AnyColumn;
use super::ids::Ids;

// ANCHOR: spec
/// What the schema says of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnSpec {
    /// As the code calls it.
    pub name: &'static str,
    /// As the book's formulas call it.
    pub symbol: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// What a cell is: type and size.
    pub kind: Kind,
    /// Whether a user may change a cell by hand.
    pub editable: bool,
}
// ANCHOR_END: spec

/// A table of known type.
pub trait Table: AnyTable {
    /// Its name in the container.
    const NAME: &'static str;
    /// One sentence.
    const ABOUT: &'static str;
    /// Its columns, in order.
    const COLUMNS: &'static [ColumnSpec];
    /// All values of a row.
    type Row;

    /// Adds a row; gives its ID. Values of columns that the plan left out are dropped.
    fn push(&mut self, row: Self::Row) -> RowId;

    /// Gathers a row; None if it isn't there. Columns that the plan left out give their zero.
    fn row(&self, row: usize) -> Option<Self::Row>;
}

/// A table of any type: what the overlay, the plan and the tests know of it.
pub trait AnyTable {
    /// Its name in the container.
    fn name(&self) -> &'static str;

    /// One sentence.
    fn about(&self) -> &'static str;

    /// Its columns, in order.
    fn specs(&self) -> &'static [ColumnSpec];

    /// Its rows' IDs.
    fn ids(&self) -> &Ids;

    /// The same, to be changed together with the columns.
    fn ids_mut(&mut self) -> &mut Ids;

    /// A column by its place in [`Self::specs`].
    fn column(&self, place: usize) -> &dyn AnyColumn;

    /// The same, to be changed.
    fn column_mut(&mut self, place: usize) -> &mut dyn AnyColumn;

    /// How many rows it has.
    fn rows(&self) -> usize {
        self.ids().rows()
    }

    /// The place of a column.
    fn place_of(&self, column: &str) -> Option<usize> {
        self.specs().iter().position(|spec| spec.name == column)
    }

    /// Bytes of a row in the columns that the plan kept.
    fn row_bytes(&self) -> usize {
        let specs = self.specs().iter().enumerate();
        specs
            .filter(|(place, _)| self.column(*place).is_kept())
            .map(|(_, spec)| spec.kind.size())
            .sum()
    }

    // ANCHOR: retain
    /// Keeps the rows that are marked, in their order, in every column.
    fn retain_rows(&mut self, keep: &[bool]) {
        for place in 0..self.specs().len() {
            self.column_mut(place).retain_rows(keep);
        }
        self.ids_mut().retain(keep);
    }
    // ANCHOR_END: retain

    /// Forgets all rows and keeps the memory.
    fn clear(&mut self) {
        for place in 0..self.specs().len() {
            self.column_mut(place).clear();
        }
        self.ids_mut().clear();
    }
}

// ANCHOR: macro
// ANCHOR: takes
/// States a table's columns once: name, type, symbol, unit, and what each is, as its doc comment.
///
/// Gives the struct of columns, the struct of a row, and the schema.
#[macro_export]
macro_rules! table {
    (
        $(#[doc = $about:literal])+
        pub struct $Table:ident of $(#[$row_doc:meta])* $Row:ident in $name:literal {
            $(
                $(#[doc = $doc:literal])+
                $column:ident: $Value:ty, $symbol:literal, $unit:literal $(, $editable:ident)?;
            )+
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Clone, Debug, Default)]
        pub struct $Table {
            ids: $crate::columns::Ids,
            $($(#[doc = $doc])+ pub $column: $crate::columns::Column<$Value>,)+
        }

        $(#[$row_doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct $Row {
            $($(#[doc = $doc])+ pub $column: $Value,)+
        }

        // ANCHOR_END: takes
        // ANCHOR: gives
        impl $crate::columns::Table for $Table {
            const NAME: &'static str = $name;
            const ABOUT: &'static str = concat!($($about),+).trim_ascii();
            const COLUMNS: &'static [$crate::columns::ColumnSpec] = &[$(
                $crate::columns::ColumnSpec {
                    name: stringify!($column),
                    symbol: $symbol,
                    unit: $unit,
                    about: concat!($($doc),+).trim_ascii(),
                    kind: <$Value as $crate::columns::Value>::KIND,
                    editable: $crate::table!(@editable $($editable)?),
                },
            )+];
            type Row = $Row;

            fn push(&mut self, row: $Row) -> $crate::columns::RowId {
                $(self.$column.push(row.$column);)+
                self.ids.push()
            }

            fn row(&self, row: usize) -> Option<$Row> {
                (row < self.ids.rows()).then(|| $Row {
                    $($column: self.$column.get(row).copied().unwrap_or_default(),)+
                })
            }
        }
        // ANCHOR_END: gives
        // ANCHOR_END: macro

        impl $crate::columns::AnyTable for $Table {
            fn name(&self) -> &'static str {
                <Self as $crate::columns::Table>::NAME
            }

            fn about(&self) -> &'static str {
                <Self as $crate::columns::Table>::ABOUT
            }

            fn specs(&self) -> &'static [$crate::columns::ColumnSpec] {
                <Self as $crate::columns::Table>::COLUMNS
            }

            fn ids(&self) -> &$crate::columns::Ids {
                &self.ids
            }

            fn ids_mut(&mut self) -> &mut $crate::columns::Ids {
                &mut self.ids
            }

            fn column(&self, place: usize) -> &dyn $crate::columns::AnyColumn {
                let columns: &[&dyn $crate::columns::AnyColumn] = &[$(&self.$column),+];
                columns[place]
            }

            fn column_mut(&mut self, place: usize) -> &mut dyn $crate::columns::AnyColumn {
                let columns: [&mut dyn $crate::columns::AnyColumn; _] = [$(&mut self.$column),+];
                columns.into_iter().nth(place).expect("a column of the schema")
            }
        }
    };
    (@editable) => { false };
    (@editable editable) => { true };
}
#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    table! {
        /// Fruit
        /// on a tree.
        pub struct Fruits of
        /// A fruit.
        Fruit in "fruits" {
            /// How heavy.
            mass: f32, "m", "kg", editable;
            /// Where it hangs.
            position: Vec3, "p", "m";
        }
    }

    fn two() -> Fruits {
        let mut fruits = Fruits::default();
        for mass in [0.1, 0.2] {
            fruits.push(Fruit {
                mass,
                position: Vec3::splat(mass),
            });
        }
        fruits
    }

    #[test]
    fn a_table_says_what_its_columns_are() {
        let [mass, position] = Fruits::COLUMNS else {
            panic!("two columns");
        };
        assert_eq!(Fruits::ABOUT, "Fruit on a tree.");
        assert_eq!((mass.name, mass.unit, mass.editable), ("mass", "kg", true));
        assert_eq!(position.about, "Where it hangs.");
        assert_eq!((position.kind, position.editable), (Kind::Vector, false));
    }

    #[test]
    fn a_column_lies_in_memory_as_its_numbers_do() {
        let fruits = two();
        assert_eq!(
            fruits.mass.bytes(),
            bytemuck::cast_slice::<f32, u8>(&[0.1, 0.2])
        );
        assert_eq!(fruits.position.bytes().len(), 24);
    }

    #[test]
    fn what_is_left_out_takes_no_memory_and_reads_as_zero() {
        let mut fruits = two();
        fruits.column_mut(1).set_kept(false, 2);
        let row = fruits.push(Fruit {
            mass: 0.3,
            position: Vec3::ONE,
        });
        assert_eq!((fruits.mass.len(), fruits.position.len()), (3, 0));
        assert_eq!(fruits.row_bytes(), 4);
        let gathered = fruits.row(fruits.ids().row(row).expect("it lives"));
        assert_eq!(
            gathered,
            Some(Fruit {
                mass: 0.3,
                position: Vec3::ZERO
            })
        );
    }

    #[test]
    fn removing_rows_keeps_the_order_of_the_others_in_every_column() {
        let mut fruits = two();
        fruits.push(Fruit {
            mass: 0.3,
            position: Vec3::ONE,
        });
        fruits.retain_rows(&[true, false, true]);
        assert_eq!(&fruits.mass[..], &[0.1, 0.3]);
        assert_eq!(&fruits.position[..], &[Vec3::splat(0.1), Vec3::ONE]);
    }
}
