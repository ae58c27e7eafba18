// Rows move into grid order: slot by slot, and within a slot by ID, so that equal inputs give equal
// bits. A ball's new row is where its slot starts plus how many in the slot have smaller IDs.
// Needs common/index, rows.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> slots: array<u32>;
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read> order: array<u32>;
@group(0) @binding(4) var<storage, read> places: array<Place>;
@group(0) @binding(5) var<storage, read> movers: array<Mover>;
@group(0) @binding(6) var<storage, read> attitudes: array<vec4f>;
@group(0) @binding(7) var<storage, read> balls: array<Ball>;
@group(0) @binding(8) var<storage, read_write> places_next: array<Place>;
@group(0) @binding(9) var<storage, read_write> movers_next: array<Mover>;
@group(0) @binding(10) var<storage, read_write> attitudes_next: array<vec4f>;
@group(0) @binding(11) var<storage, read_write> balls_next: array<Ball>;
@group(0) @binding(12) var<storage, read_write> old_rows: array<u32>;
@group(0) @binding(13) var<storage, read_write> status: array<atomic<u32>>;

// ANCHOR: sort
@compute @workgroup_size(WORKGROUP)
fn sort(@builtin(global_invocation_id) id: vec3u) {
    let at = row_index(id);
    if at >= grid.rows || atomicLoad(&status[NEEDED]) > grid.room {
        return;
    }
    let row = order[at];
    let slot = slots[row];
    let own = balls[row].id;
    let first = starts[slot];
    let end = starts[slot + 1u];
    var rank = 0u;
    for (var other = first; other < end; other++) {
        if balls[order[other]].id < own {
            rank += 1u;
        }
    }
    let next = first + rank;
    places_next[next] = places[row];
    movers_next[next] = movers[row];
    attitudes_next[next] = attitudes[row];
    balls_next[next] = balls[row];
    old_rows[next] = row;
}
// ANCHOR_END: sort
