//! From rows to lanes and back: eight bodies lie anywhere, their numbers shall lie side by side.

use super::Real;

// ANCHOR: gather
/// The rows of `table` that `rows` names, a row a lane: column k of the table becomes number k of the result.
#[inline]
pub fn gather<R: Real, const N: usize>(table: &[[f32; N]], rows: &[u32]) -> [R; N] {
    let mut columns = [[0.0; 8]; N];
    for lane in 0..R::LANES {
        let row = &table[rows[lane] as usize];
        for column in 0..N {
            columns[column][lane] = row[column];
        }
    }
    std::array::from_fn(|column| R::of(|lane| columns[column][lane]))
}
// ANCHOR_END: gather

/// Puts lanes back where [`gather`] had them from, for the first `count` lanes.
#[inline]
pub fn scatter<R: Real, const N: usize>(
    columns: [R; N],
    table: &mut [[f32; N]],
    rows: &[u32],
    count: usize,
) {
    let lanes = transpose(columns);
    for (row, lane) in rows.iter().zip(lanes).take(count) {
        table[*row as usize] = lane;
    }
}

/// A row a lane, of which those behind [`Real::LANES`] are nothing.
#[inline]
pub fn transpose<R: Real, const N: usize>(columns: [R; N]) -> [[f32; N]; 8] {
    std::array::from_fn(|lane| {
        std::array::from_fn(|column| {
            if lane < R::LANES {
                columns[column].lane(lane)
            } else {
                0.0
            }
        })
    })
}
