// Which slot of the grid each ball is in, and how many are in each. Counting needs an atomic sum, of
// numbers and not of state: a sum of ones has the same value in any order.
// Needs common/index, rows, common/grid.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> places: array<Place>;
@group(0) @binding(2) var<storage, read> movers: array<Mover>;
@group(0) @binding(3) var<storage, read> balls: array<Ball>;
@group(0) @binding(4) var<storage, read_write> slots: array<u32>;
@group(0) @binding(5) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> status: array<atomic<u32>>;

// ANCHOR: cells
@compute @workgroup_size(WORKGROUP)
fn cells(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || atomicLoad(&status[HALTED]) != 0u {
        return;
    }
    let position = places[row].position;
    var slot = slot_of_lost(grid);
    if all_finite(position) && all_finite(movers[row].velocity) {
        slot = slot_of(grid, cell_of(grid, position));
    } else {
        atomicAdd(&status[NOT_FINITE], 1u);
        atomicMin(&status[FIRST_NOT_FINITE], balls[row].id);
    }
    slots[row] = slot;
    atomicAdd(&counts[slot], 1u);
}
// ANCHOR_END: cells
