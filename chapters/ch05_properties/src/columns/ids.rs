//! IDs of rows: a number and a generation that name a row for as long as it lives, while the rows
//! themselves stay dense and in order.
//!
//! As long as nothing was ever removed, the ID of a row is its place, and nothing is stored.

use ch00_scenes::RowId;

/// Marks a slot without a row.
const NOWHERE: u32 = u32::MAX;

// ANCHOR: ids
/// Which row has which ID.
#[derive(Clone, Debug, Default)]
pub struct Ids {
    rows: usize,
    /// None while every ID is its row's place.
    moved: Option<Moved>,
}

#[derive(Clone, Debug, Default)]
struct Moved {
    slots: Vec<Slot>,
    /// By row.
    slot_of_row: Vec<u32>,
    /// Slots without a row, the one to be used next at the end.
    free: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    row: u32,
    /// How many rows it had before this one.
    generation: u32,
}
// ANCHOR_END: ids

impl Ids {
    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// A new row at the end; gives its ID.
    ///
    /// # Panics
    /// With 2³² rows.
    pub fn push(&mut self) -> RowId {
        let row = u32::try_from(self.rows).expect("a table has fewer than 2³² rows");
        self.rows += 1;
        let Some(moved) = &mut self.moved else {
            return RowId::first(row);
        };
        let slot = moved.free.pop().unwrap_or_else(|| {
            moved.slots.push(Slot {
                row: NOWHERE,
                generation: 0,
            });
            moved.slots.len() as u32 - 1
        });
        moved.slots[slot as usize].row = row;
        moved.slot_of_row.push(slot);
        RowId {
            slot,
            generation: moved.slots[slot as usize].generation,
        }
    }

    // ANCHOR: row
    /// Where the row with this ID is; None once it is gone.
    #[inline]
    #[must_use]
    pub fn row(&self, id: RowId) -> Option<usize> {
        match &self.moved {
            None => (id.generation == 0).then_some(id.slot as usize),
            Some(moved) => {
                let slot = moved.slots.get(id.slot as usize)?;
                let lives = slot.generation == id.generation && slot.row != NOWHERE;
                lives.then_some(slot.row as usize)
            }
        }
        .filter(|&row| row < self.rows)
    }
    // ANCHOR_END: row

    /// The ID of a row; None if there is no such row.
    #[inline]
    #[must_use]
    pub fn id(&self, row: usize) -> Option<RowId> {
        if row >= self.rows {
            return None;
        }
        Some(match &self.moved {
            None => RowId::first(row as u32),
            Some(moved) => {
                let slot = moved.slot_of_row[row];
                RowId {
                    slot,
                    generation: moved.slots[slot as usize].generation,
                }
            }
        })
    }

    // ANCHOR: retain
    /// Keeps the rows that are marked, in their order; a mark a row. The IDs of the others name nothing
    /// from now on.
    pub fn retain(&mut self, keep: &[bool]) {
        let moved = self.moved.get_or_insert_with(|| Moved {
            slots: (0..self.rows as u32)
                .map(|row| Slot { row, generation: 0 })
                .collect(),
            slot_of_row: (0..self.rows as u32).collect(),
            free: Vec::new(),
        });
        let mut kept = 0;
        for (row, &stays) in keep.iter().enumerate() {
            let slot = moved.slot_of_row[row];
            if stays {
                moved.slots[slot as usize].row = kept;
                moved.slot_of_row[kept as usize] = slot;
                kept += 1;
            } else {
                let gone = &mut moved.slots[slot as usize];
                gone.row = NOWHERE;
                // A slot whose generations are used up is never used again.
                if gone.generation < u32::MAX {
                    gone.generation += 1;
                    moved.free.push(slot);
                }
            }
        }
        moved.slot_of_row.truncate(kept as usize);
        self.rows = kept as usize;
    }
    // ANCHOR_END: retain

    /// Forgets all rows: IDs start at 0 again.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Sets the number of rows of a table whose rows have no lives of their own, such as contacts.
    pub fn set_rows(&mut self, rows: usize) {
        self.moved = None;
        self.rows = rows;
    }

    /// Bytes that it needs beside the columns.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.moved.as_ref().map_or(0, |moved| {
            size_of_val(&moved.slots[..])
                + size_of_val(&moved.slot_of_row[..])
                + size_of_val(&moved.free[..])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn three() -> (Ids, [RowId; 3]) {
        let mut ids = Ids::default();
        let all = [ids.push(), ids.push(), ids.push()];
        (ids, all)
    }

    #[test]
    fn as_long_as_nothing_is_removed_an_id_is_a_place_and_costs_nothing() {
        let (ids, all) = three();
        assert_eq!(all.map(|id| ids.row(id)), [Some(0), Some(1), Some(2)]);
        assert_eq!(ids.bytes(), 0);
        assert_eq!(ids.row(RowId::first(3)), None);
    }

    #[test]
    fn the_ids_of_the_rows_that_stay_go_on_naming_them() {
        let (mut ids, [a, b, c]) = three();
        ids.retain(&[false, true, true]);
        assert_eq!([a, b, c].map(|id| ids.row(id)), [None, Some(0), Some(1)]);
        assert_eq!(ids.id(1), Some(c));
        assert_eq!(ids.id(2), None);
    }

    #[test]
    fn a_new_row_in_an_old_slot_is_another_generation() {
        let (mut ids, [a, ..]) = three();
        ids.retain(&[false, true, true]);
        let new = ids.push();
        assert_eq!((new.slot, new.generation), (0, 1));
        assert_eq!((ids.row(a), ids.row(new)), (None, Some(2)));
        assert_eq!(new.to_string(), "0.1");
    }

    #[test]
    fn many_rounds_of_removing_and_adding_agree_with_a_list() {
        let mut random = ch00_scenes::random::SplitMix64::new(5);
        let (mut ids, mut list, mut gone) = (Ids::default(), Vec::new(), Vec::new());
        for _ in 0..200 {
            for _ in 0..(4.0 * random.unit()) as usize {
                list.push(ids.push());
            }
            let keep: Vec<bool> = list.iter().map(|_| random.unit() < 0.8).collect();
            ids.retain(&keep);
            let mut marks = keep.iter();
            list.retain(|&id| {
                let kept = *marks.next().expect("a mark a row");
                gone.extend((!kept).then_some(id));
                kept
            });
            for (row, &id) in list.iter().enumerate() {
                assert_eq!((ids.row(id), ids.id(row)), (Some(row), Some(id)));
            }
            assert!(gone.iter().all(|&id| ids.row(id).is_none()));
        }
    }
}
