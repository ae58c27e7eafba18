// Which slot of the grid each ball is in, how many are in each, and how fast the fastest is. That needs
// atomic sums and maxima, of numbers and not of state: they have the same value in any order.
// Needs common/index, rows, common/grid.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> places: array<Place>;
@group(0) @binding(2) var<storage, read> movers: array<Mover>;
@group(0) @binding(3) var<storage, read> balls: array<Ball>;
@group(0) @binding(4) var<storage, read_write> slots: array<u32>;
@group(0) @binding(5) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> status: array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> fastest: array<atomic<u32>, 2>;

const GROUP: u32 = 256u;

// The fastest of the workgroup, so that not every row asks for the same number in memory.
var<workgroup> fastest_here: atomic<u32>;

// ANCHOR: cells
@compute @workgroup_size(GROUP)
fn cells(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) own: u32) {
    let row = group_index(group) * GROUP + own;
    if own == 0u {
        atomicStore(&fastest_here, 0u);
    }
    workgroupBarrier();
    let turn = atomicLoad(&status[STEPS]) & 1u;
    if row < grid.rows && atomicLoad(&status[NEEDED]) <= grid.room {
        count_row(row);
    }
    workgroupBarrier();
    if own == 0u {
        atomicMax(&fastest[turn], atomicLoad(&fastest_here));
    }
    if row == 0u {
        atomicStore(&fastest[1u - turn], 0u);
    }
}

fn count_row(row: u32) {
    let position = places[row].position;
    let velocity = movers[row].velocity;
    var slot = slot_of_lost(grid);
    if all_finite(position) && all_finite(velocity) {
        slot = slot_of(grid, cell_of(grid, position));
        // Numbers that aren't negative are in the order of their bits.
        atomicMax(&fastest_here, bitcast<u32>(length(velocity)));
    } else {
        atomicAdd(&status[NOT_FINITE], 1u);
        atomicMin(&status[FIRST_NOT_FINITE], balls[row].id);
    }
    slots[row] = slot;
    atomicAdd(&counts[slot], 1u);
}
// ANCHOR_END: cells
