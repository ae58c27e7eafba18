// Each body looks for those that it may touch in the step, in the cells about its own and among those that
// the grid doesn't hold, and lists them in the order of their rows. Of two bodies one lists the pair: the
// one that isn't large, else the one with the smaller row.
// Needs common/index, rows, common/grid, common/pairing.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> pairs_of: PairsOf;
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read> sorted: array<Bound>;
@group(0) @binding(4) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(5) var<storage, read> ignored: array<u32>;
@group(0) @binding(6) var<storage, read_write> partners: array<Partner>;
@group(0) @binding(7) var<storage, read_write> pair_counts: array<u32>;
@group(0) @binding(8) var<storage, read_write> status: array<atomic<u32>>;

// The plan: whether any bodies pass through each other, and whether any large body moves.
override IGNORES: bool = true;
override MOVING_LARGE: bool = true;

// What an invocation knows while it looks.
struct Search {
    row: u32,
    own: Bound,
    // Where the bodies begin that it passes through, and how many they are.
    ignored: u32,
    ignored_count: u32,
    // How many partners it has by now.
    count: u32,
}

fn place_in_list(k: u32, row: u32) -> u32 {
    return (k + 1u) * grid.capacity + row;
}

// Whether two bodies may touch in the step, and one of them can move.
fn may_touch(a: Bound, b: Bound) -> bool {
    let idle = (a.body & b.body & STATIC) != 0u;
    return !idle && all(a.low <= b.high) && all(b.low <= a.high);
}

fn is_ignored(search: ptr<function, Search>, other: u32) -> bool {
    for (var k = 0u; k < (*search).ignored_count; k++) {
        if ignored[(*search).ignored + k] == other {
            return true;
        }
    }
    return false;
}

// ANCHOR: add
// Adds a partner to the list, behind those with smaller rows, if there is room.
fn add(search: ptr<function, Search>, other: Bound) {
    let row = other.body & BODY;
    if IGNORES && is_ignored(search, row) {
        return;
    }
    let own = (*search).own.body;
    let slot = slot_of_pair(pairs_of, (own >> KIND_SHIFT) & 3u, (other.body >> KIND_SHIFT) & 3u);
    let own_is_large = ((*search).own.flags & OVERSIZED) != 0u;
    let other_is_large = (other.flags & OVERSIZED) != 0u;
    let lists = select(row > (*search).row, other_is_large, own_is_large != other_is_large);
    let entry = row | (slot << SLOT_SHIFT) | select(0u, LISTED, lists);
    var k = (*search).count;
    (*search).count = k + 1u;
    if k >= grid.room {
        return;
    }
    while k > 0u {
        let before = partners[place_in_list(k - 1u, (*search).row)].body;
        if (before & BODY) < row {
            break;
        }
        partners[place_in_list(k, (*search).row)].body = before;
        k -= 1u;
    }
    partners[place_in_list(k, (*search).row)].body = entry;
}
// ANCHOR_END: add

// ANCHOR: look_around
// Looks through all cells in which a body may be whose box meets the own one: lines along x, whose slots
// follow each other, except where a line wraps round. As far as one of two looks, so far does the other:
// both find each other.
fn look_around(search: ptr<function, Search>, ahead: f32) {
    let own = (*search).own;
    let others = vec3f(pairs_of.widest + ahead + grid.margin);
    let slots = vec3u(grid.slots_x, grid.slots_y, grid.slots_z);
    let low = cell_of(grid, own.low - others);
    let high = cell_of(grid, own.high + others);
    let cells = min(vec3u(high - low) + 1u, slots);
    let first = wrap(low, slots).x;
    let to_end = min(cells.x, slots.x - first);
    for (var line = 0u; line < cells.y * cells.z; line++) {
        let cell = low + vec3i(0, i32(line % cells.y), i32(line / cells.y));
        let slot = slot_of(grid, cell);
        look(search, starts[slot], starts[slot + to_end]);
        if to_end < cells.x {
            let line_start = slot - first;
            look(search, starts[line_start], starts[line_start + cells.x - to_end]);
        }
    }
}

// Four are asked for at once: what waits for memory waits once for all.
fn look(search: ptr<function, Search>, first: u32, end: u32) {
    for (var at = first; at < end; at += 4u) {
        let last = end - 1u;
        let one = sorted[at];
        let two = sorted[min(at + 1u, last)];
        let three = sorted[min(at + 2u, last)];
        let four = sorted[min(at + 3u, last)];
        consider(search, one, true);
        consider(search, two, at + 1u < end);
        consider(search, three, at + 2u < end);
        consider(search, four, at + 3u < end);
    }
}

fn consider(search: ptr<function, Search>, other: Bound, is_one: bool) {
    if is_one && may_touch((*search).own, other) && (other.body & BODY) != (*search).row {
        add(search, other);
    }
}

// Those that the grid doesn't hold stand behind all slots.
fn look_behind(search: ptr<function, Search>) {
    look(search, starts[slot_of_lost(grid)], grid.rows);
}
// ANCHOR_END: look_around

// ANCHOR: find
@compute @workgroup_size(WORKGROUP)
fn pair_find(@builtin(global_invocation_id) id: vec3u) {
    let at = row_index(id);
    if at >= grid.rows || atomicLoad(&status[HALTED]) != 0u {
        return;
    }
    var search: Search;
    search.own = sorted[at];
    search.row = search.own.body & BODY;
    if IGNORES {
        search.ignored = rigids[search.row].ignored;
        search.ignored_count = rigids[search.row].ignored_count;
    }
    // What touches nothing has a box that holds nothing. Large ones leave it to others to look into the grid.
    look_behind(&search);
    if search.own.flags != OVERSIZED && all(search.own.low <= search.own.high) {
        look_around(&search, bitcast<f32>(atomicLoad(&status[AHEAD])));
    }
    if search.count > grid.room {
        atomicMax(&status[NEEDED], search.count);
    }
    let count = min(search.count, grid.room);
    partners[search.row] = Partner(count, 0u);
    count_kinds(search.row, count);
}
// ANCHOR_END: find

// ANCHOR: count_kinds
// How many pairs of each kind the body lists; and for each large body that moves, whether it has a pair
// with it.
fn count_kinds(row: u32, count: u32) {
    for (var slot = 0u; slot < pairs_of.kinds; slot++) {
        var listed = 0u;
        for (var k = 0u; k < count; k++) {
            let entry = partners[place_in_list(k, row)].body;
            let is_one = (entry & LISTED) != 0u && ((entry >> SLOT_SHIFT) & 15u) == slot;
            listed += select(0u, 1u, is_one);
        }
        pair_counts[slot * grid.rows + row] = listed;
    }
    if !MOVING_LARGE {
        return;
    }
    for (var large = 0u; large < pairs_of.larges; large++) {
        pair_counts[(pairs_of.kinds + large) * grid.rows + row] = 0u;
    }
    let own_is_large = rigids[row].role == LARGE;
    for (var k = 0u; k < count && !own_is_large; k++) {
        let large = rigids[partners[place_in_list(k, row)].body & BODY].large;
        if large != NONE {
            pair_counts[(pairs_of.kinds + large) * grid.rows + row] = 1u;
        }
    }
}
// ANCHOR_END: count_kinds
