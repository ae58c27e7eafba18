// A uniform grid without ends: cells are found by their coordinates modulo the size of a table. Rows that
// are near in space are near in the table. Names as in `ch06_compute::grid`. Needs rows.

// Rows that are not finite are kept here, behind all slots: nobody looks there.
fn slot_of_lost(grid: GridOf) -> u32 {
    return grid.slots_x * grid.slots_y * grid.slots_z;
}

// The cell in which a point is.
fn cell_of(grid: GridOf, position: vec3f) -> vec3i {
    return vec3i(floor(position / grid.edge));
}

// Coordinates modulo the size of the table, never negative.
fn wrap(cell: vec3i, slots: vec3u) -> vec3u {
    let size = vec3i(slots);
    let rest = cell % size;
    return vec3u(select(rest, rest + size, rest < vec3i(0)));
}

// The slot of a cell.
fn slot_of(grid: GridOf, cell: vec3i) -> u32 {
    let slots = vec3u(grid.slots_x, grid.slots_y, grid.slots_z);
    let wrapped = wrap(cell, slots);
    return (wrapped.z * slots.y + wrapped.y) * slots.x + wrapped.x;
}

// ANCHOR: is_finite
// Whether a number is finite, by its bits: a compiler may assume that NaN doesn't occur.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

fn all_finite(v: vec3f) -> bool {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
// ANCHOR_END: is_finite
