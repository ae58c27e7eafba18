//! The order of a table's rows: by one column, stable, and what is no number comes last either
//! way.
//!
//! Every cell becomes a whole number that is ordered as the cells are; pairs of that and the row
//! are then all different, so that any sort of them is stable.

use ch00_scenes::{ColumnData, Kind, RowId};

/// What rows are sorted by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sort {
    /// Which column.
    pub by: By,
    /// Which of a cell's numbers.
    pub part: Part,
    /// Whether the largest comes first.
    pub is_descending: bool,
}

/// A column to sort by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The rows' IDs.
    Id,
    /// A column of this name.
    Column(&'static str),
}

/// What of a cell counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it: the number itself, or the length of a vector.
    Whole,
    /// One of its numbers.
    Number(usize),
}

impl Part {
    /// What a column of this kind can be sorted by, the usual one first, and how it is called. All
    /// orientations are equally long, so the first is w: how far from unturned.
    #[must_use]
    pub fn of(kind: Kind) -> Vec<(Self, String)> {
        let whole = |name: &str| (Part::Whole, name.to_owned());
        let numbers = |names: &[(usize, &str)]| {
            let part = |&(i, name): &(usize, &str)| (Part::Number(i), name.to_owned());
            names.iter().map(part).collect::<Vec<_>>()
        };
        match kind {
            Kind::Scalar | Kind::Index => vec![whole("value")],
            Kind::Vector => {
                let mut parts = numbers(&[(0, "x"), (1, "y"), (2, "z")]);
                parts.insert(0, whole("length"));
                parts
            }
            Kind::Quaternion => numbers(&[(3, "w"), (0, "x"), (1, "y"), (2, "z")]),
            Kind::Matrix => (0..9)
                .map(|i| (Part::Number(i), format!("m{}{}", i % 3 + 1, i / 3 + 1)))
                .collect(),
        }
    }
}

impl Sort {
    /// What a click on a header makes of the order: ascending, then descending, then none.
    #[must_use]
    pub fn after_click(now: Option<Self>, by: By, part: Part) -> Option<Self> {
        match now {
            Some(sort) if sort.by == by && !sort.is_descending => Some(Self {
                is_descending: true,
                ..sort
            }),
            Some(sort) if sort.by == by => None,
            _ => Some(Self {
                by,
                part,
                is_descending: false,
            }),
        }
    }
}

/// Sorts rows by their cells, one for each row in the same order.
pub fn sort_by_cells(rows: &mut [usize], cells: &ColumnData, part: Part, is_descending: bool) {
    sort_by_keys(rows, &keys(cells, part), is_descending);
}

/// Sorts rows by their IDs, one for each row in the same order.
pub fn sort_by_ids(rows: &mut [usize], ids: &[RowId], is_descending: bool) {
    let key = |id: &RowId| (u64::from(id.slot) << 32) | u64::from(id.generation);
    let keys: Vec<u64> = ids.iter().map(key).collect();
    sort_by_keys(rows, &keys, is_descending);
}

/// The key of what is no number: after all others, whichever way they run.
const LAST: u64 = u64::MAX;

fn sort_by_keys(rows: &mut [usize], keys: &[u64], is_descending: bool) {
    let turned = |key: u64| match key {
        LAST => LAST,
        _ if is_descending => LAST - 1 - key,
        _ => key,
    };
    // A row without a key comes last, too.
    let all_keys = keys.iter().copied().chain(std::iter::repeat(LAST));
    let mut pairs: Vec<(u64, usize)> = all_keys.map(turned).zip(rows.iter().copied()).collect();
    pairs.sort_unstable();
    for (row, (_, sorted)) in rows.iter_mut().zip(pairs) {
        *row = sorted;
    }
}

fn keys(cells: &ColumnData, part: Part) -> Vec<u64> {
    fn of<const N: usize>(cells: &[[f32; N]], part: Part) -> Vec<u64> {
        cells.iter().map(|cell| key(size(cell, part))).collect()
    }
    match cells {
        ColumnData::Scalar(cells) => cells.iter().map(|&x| key(f64::from(x))).collect(),
        ColumnData::Index(cells) => cells.iter().copied().map(u64::from).collect(),
        ColumnData::Vector(cells) => of(cells, part),
        ColumnData::Quaternion(cells) => of(cells, part),
        ColumnData::Matrix(cells) => of(cells, part),
    }
}

/// In f64, where no square of an f32 overflows.
fn size(numbers: &[f32], part: Part) -> f64 {
    match part {
        Part::Number(i) => numbers.get(i).map_or(f64::NAN, |&x| f64::from(x)),
        Part::Whole => {
            let squares = numbers.iter().map(|&x| f64::from(x).powi(2));
            squares.sum::<f64>().sqrt()
        }
    }
}

/// A whole number that is ordered as the reals are, with −0 = 0: the bits of a positive real are
/// in order once its sign is turned, those of a negative one once all are.
fn key(x: f64) -> u64 {
    const SIGN: u64 = 1 << 63;
    if x.is_nan() {
        return LAST;
    }
    let bits = (x + 0.0).to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sorted(cells: &ColumnData, part: Part, is_descending: bool) -> Vec<usize> {
        let mut rows: Vec<usize> = (0..cells.len()).collect();
        sort_by_cells(&mut rows, cells, part, is_descending);
        rows
    }

    #[test]
    fn numbers_are_sorted_either_way_with_infinities_at_the_ends() {
        let cells = ColumnData::Scalar(vec![2.0, f32::INFINITY, -3.0, f32::NEG_INFINITY, 0.5]);
        assert_eq!(sorted(&cells, Part::Whole, false), [3, 2, 4, 0, 1]);
        assert_eq!(sorted(&cells, Part::Whole, true), [1, 0, 4, 2, 3]);
    }

    #[test]
    fn equal_cells_stay_in_the_tables_order_either_way() {
        let cells = ColumnData::Scalar(vec![1.0, -0.0, 1.0, 0.0, -0.0]);
        assert_eq!(sorted(&cells, Part::Whole, false), [1, 3, 4, 0, 2]);
        assert_eq!(sorted(&cells, Part::Whole, true), [0, 2, 1, 3, 4]);
    }

    #[test]
    fn what_is_no_number_comes_last_either_way() {
        let cells = ColumnData::Scalar(vec![f32::NAN, 1.0, -f32::NAN, f32::INFINITY]);
        assert_eq!(sorted(&cells, Part::Whole, false), [1, 3, 0, 2]);
        assert_eq!(sorted(&cells, Part::Whole, true), [3, 1, 0, 2]);
    }

    #[test]
    fn vectors_are_sorted_by_length_or_by_one_of_their_numbers() {
        let cells = ColumnData::Vector(vec![[3.0, 0.0, 0.0], [-4.0, 1.0, 0.0], [0.0, -2.0, 1.0]]);
        assert_eq!(sorted(&cells, Part::Whole, false), [2, 0, 1]);
        assert_eq!(sorted(&cells, Part::Number(0), false), [1, 2, 0]);
        assert_eq!(sorted(&cells, Part::Number(1), true), [1, 0, 2]);
    }

    #[test]
    fn vectors_whose_squares_overflow_are_still_told_apart() {
        let cells = ColumnData::Vector(vec![[3e38, 0.0, 0.0], [2e38, 0.0, 0.0]]);
        assert_eq!(sorted(&cells, Part::Whole, false), [1, 0]);
    }

    #[test]
    fn whole_numbers_are_told_apart_beyond_what_a_real_can_hold() {
        let cells = ColumnData::Index(vec![u32::MAX, u32::MAX - 1, 0]);
        assert_eq!(sorted(&cells, Part::Whole, false), [2, 1, 0]);
    }

    #[test]
    fn ids_are_sorted_by_number_and_then_by_generation() {
        let ids = [(9, 0), (2, 3), (2, 1)].map(|(slot, generation)| RowId { slot, generation });
        let mut rows = [0, 1, 2];
        sort_by_ids(&mut rows, &ids, false);
        assert_eq!(rows, [2, 1, 0]);
    }

    #[test]
    fn clicks_go_from_ascending_to_descending_to_the_tables_order() {
        let by = By::Column("position");
        let click = |now| Sort::after_click(now, by, Part::Whole);
        let first = click(None);
        assert!(first.is_some_and(|sort| !sort.is_descending));
        let second = click(first);
        assert!(second.is_some_and(|sort| sort.is_descending));
        assert_eq!(click(second), None);
        let other = Sort::after_click(second, By::Id, Part::Whole);
        assert_eq!(
            other.map(|sort| (sort.by, sort.is_descending)),
            Some((By::Id, false))
        );
    }

    #[test]
    fn every_number_of_a_cell_can_be_sorted_by() {
        let names = |kind| {
            Part::of(kind)
                .into_iter()
                .map(|(_, name)| name)
                .collect::<Vec<_>>()
        };
        assert_eq!(names(Kind::Vector), ["length", "x", "y", "z"]);
        assert_eq!(names(Kind::Quaternion), ["w", "x", "y", "z"]);
        assert_eq!(names(Kind::Matrix)[3], "m12");
        assert_eq!(names(Kind::Index), ["value"]);
    }
}
