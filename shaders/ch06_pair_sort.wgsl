// Bodies in the order of the grid: slot by slot, and within a slot by row, so that equal inputs give
// equal bits. What the search needs of them is copied into that order. Needs common/index, rows.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> slots: array<u32>;
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> order: array<u32>;
@group(0) @binding(5) var<storage, read> bounds: array<Bound>;
@group(0) @binding(6) var<storage, read_write> sorted: array<Bound>;
@group(0) @binding(7) var<storage, read> status: array<u32>;

// ANCHOR: scatter
// Each body finds a place among those of its slot. Which of them comes first differs from run to run.
// The counts go down to zero again, ready for the next step.
@compute @workgroup_size(WORKGROUP)
fn pair_scatter(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    let slot = slots[row];
    let behind = atomicSub(&counts[slot], 1u) - 1u;
    order[starts[slot] + behind] = row;
}
// ANCHOR_END: scatter

// ANCHOR: sort
// A body's place is where its slot starts plus how many in the slot have smaller rows.
@compute @workgroup_size(WORKGROUP)
fn pair_sort(@builtin(global_invocation_id) id: vec3u) {
    let at = row_index(id);
    if at >= grid.rows || status[HALTED] != 0u {
        return;
    }
    let row = order[at];
    let slot = slots[row];
    let first = starts[slot];
    let end = starts[slot + 1u];
    var rank = 0u;
    for (var other = first; other < end; other++) {
        if order[other] < row {
            rank += 1u;
        }
    }
    sorted[first + rank] = bounds[row];
}
// ANCHOR_END: sort
