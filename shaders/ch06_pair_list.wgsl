// Pairs get their rows: sorted by kind, then by the body that lists them, then by partner, so that
// invocations side by side meet pairs of one kind. Needs common/index, rows, common/pairing.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> pairs_of: PairsOf;
@group(0) @binding(2) var<storage, read> pair_starts: array<u32>;
@group(0) @binding(3) var<storage, read_write> partners: array<Partner>;
@group(0) @binding(4) var<storage, read_write> touches: array<Contact>;
@group(0) @binding(5) var<storage, read_write> groups: array<u32>;
@group(0) @binding(6) var<storage, read_write> status: array<u32>;
@group(0) @binding(7) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(8) var<storage, read_write> large_pairs: array<u32>;

// The plan: whether any large body moves.
override MOVING_LARGE: bool = true;

// Most bodies that are too fast for the grid, if they can be helped.
const MOST_RUSHING: u32 = 32u;

fn set_groups(place: u32, rows: u32) {
    let count = groups_for(rows);
    groups[3u * place] = count.x;
    groups[3u * place + 1u] = count.y;
    groups[3u * place + 2u] = count.z;
}

// ANCHOR: plan
// How many workgroups each kind needs, and what closes joints. A step whose pairs have no room isn't made: nothing of the state is
// written until there is more.
@compute @workgroup_size(1)
fn pair_plan() {
    let kinds = pairs_of.kinds;
    let all = pair_starts[kinds * grid.rows];
    let of_large = pair_starts[(kinds + pairs_of.larges) * grid.rows] - all;
    let is_full = status[NEEDED] > grid.room || all > pairs_of.room || of_large > pairs_of.large_room;
    status[PAIRS_NEEDED] = max(status[PAIRS_NEEDED], all);
    status[LARGE_NEEDED] = max(status[LARGE_NEEDED], of_large);
    if is_full {
        status[HALTED] = 1u;
    }
    let halted = status[HALTED] != 0u;
    for (var slot = 0u; slot < kinds; slot++) {
        let first = pair_starts[slot * grid.rows];
        let end = pair_starts[(slot + 1u) * grid.rows];
        status[KIND_FIRST + slot] = first;
        status[KIND_FIRST + slot + 1u] = end;
        set_groups(slot + 1u, select(end - first, 0u, halted));
    }
    status[LIVE] = 0u;
    look_next();
    set_groups(0u, 0u);
    set_groups(kinds + 1u, select(pairs_of.before, 0u, halted));
}

// How far a body may look ahead in the next step and still be found in the grid. All look as far as the one
// that looks farthest; so the few that are faster than all others are not in it, and all others look at
// them wherever they are.
fn look_next() {
    var cells = 4.0;
    for (var k = 3u; k > 0u; k--) {
        if status[HALF_CELL + k - 1u] <= MOST_RUSHING {
            cells = 0.5 * f32(1u << (k - 1u));
        }
        status[HALF_CELL + k - 1u] = 0u;
    }
    status[LOOK] = bitcast<u32>(cells * grid.edge);
    status[AHEAD] = 0u;
}
// ANCHOR_END: plan

// ANCHOR: list
@compute @workgroup_size(WORKGROUP)
fn pair_list(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    let count = partners[row].body;
    for (var slot = 0u; slot < pairs_of.kinds; slot++) {
        var pair = pair_starts[slot * grid.rows + row];
        for (var k = 1u; k <= count; k++) {
            let at = k * grid.capacity + row;
            let entry = partners[at].body;
            if (entry & LISTED) != 0u && ((entry >> SLOT_SHIFT) & 15u) == slot {
                let other = entry & BODY;
                partners[at].pair = pair;
                touches[pair].a = min(row, other);
                touches[pair].b = max(row, other);
                if MOVING_LARGE {
                    note_large(row, other, pair);
                }
                pair += 1u;
            }
        }
    }
}
// ANCHOR_END: list

// A large body that moves has a list of its own, in the order of its partners' rows.
fn note_large(row: u32, other: u32, pair: u32) {
    let large = rigids[other].large;
    if large != NONE && rigids[row].role != LARGE {
        let before = pair_starts[pairs_of.kinds * grid.rows];
        let at = pair_starts[(pairs_of.kinds + large) * grid.rows + row] - before;
        large_pairs[at] = 2u * pair + select(0u, 1u, other > row);
    }
}
