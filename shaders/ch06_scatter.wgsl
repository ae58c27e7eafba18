// Each ball finds a place among those of its slot. Which of them comes first differs from run to run;
// the next pass puts them in order. Needs common/index, rows.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> slots: array<u32>;
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> order: array<u32>;
@group(0) @binding(5) var<storage, read_write> status: array<atomic<u32>>;

// ANCHOR: scatter
// The counts go down to zero again, ready for the next step.
@compute @workgroup_size(WORKGROUP)
fn scatter(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || atomicLoad(&status[NEEDED]) > grid.room {
        return;
    }
    let slot = slots[row];
    let behind = atomicSub(&counts[slot], 1u) - 1u;
    order[starts[slot] + behind] = row;
}
// ANCHOR_END: scatter
