//! From rows to lanes and back: eight bodies lie anywhere, their numbers shall lie side by side.

use super::Real;

// ANCHOR: gather
/// The rows of `table` that `rows` names, a row a lane: number k of each row becomes number k of the result.
#[inline(always)]
#[must_use]
pub fn gather<R: Real>(table: &[[f32; 4]], rows: &[u32]) -> [R; 4] {
    R::of_rows(|lane| table[rows[lane] as usize])
}
// ANCHOR_END: gather

/// Rows that lie together, a row a lane; lanes behind the last row have the last row.
#[inline(always)]
#[must_use]
pub fn load<R: Real>(table: &[[f32; 4]]) -> [R; 4] {
    let last = table.len() - 1;
    R::of_rows(|lane| table[lane.min(last)])
}

/// Puts lanes back where [`load`] had them from.
#[inline(always)]
pub fn store<R: Real>(columns: [R; 4], table: &mut [[f32; 4]]) {
    for (row, lane) in table.iter_mut().zip(R::to_rows(columns)) {
        *row = lane;
    }
}
