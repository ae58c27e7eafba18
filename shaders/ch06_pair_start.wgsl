// A body looks up its pairs and takes up what pressed it in the last step, where its points are now; then
// the first kick of the step.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/mouse, common/body, common/moving.

@group(0) @binding(9) var<storage, read> partners: array<Partner>;
@group(0) @binding(10) var<storage, read> touches: array<Contact>;
@group(0) @binding(11) var<storage, read_write> incidents: array<u32>;
@group(0) @binding(12) var<storage, read_write> groups: array<u32>;
@group(0) @binding(13) var<storage, read_write> status: array<u32>;
@group(0) @binding(14) var<storage, read> joined: array<Held>;
@group(0) @binding(15) var<uniform> pairs_of: PairsOf;

// The plan: whether what pulls is summed in a pass of its own.
override PULLS: bool = false;

// ANCHOR: pair_with
// The pair of two bodies, as the one that lists it has it.
fn pair_with(row: u32, entry: Partner) -> u32 {
    if (entry.body & LISTED) != 0u {
        return entry.pair;
    }
    let other = entry.body & BODY;
    let count = partners[other].body;
    for (var k = 1u; k <= count; k++) {
        let theirs = partners[k * grid.capacity + other];
        if (theirs.body & BODY) == row {
            return theirs.pair;
        }
    }
    return NONE;
}
// ANCHOR_END: pair_with

// ANCHOR: gather_last
// Sums what limits and loops gave a body in the last substep and what its pairs pressed in the last step,
// where their points are now; notes the rows of all of them in the body's list.
fn gather_last(row: u32, rigid: Rigid) -> Total {
    var sum = sum_before(rigid.large);
    // Limits and loops end at the same bodies always: they stand first in the list.
    var live = select(0u, rigid.ends, JOINTS);
    for (var k = 1u; k <= live; k++) {
        add_joint(&sum, incidents[k * grid.capacity + row]);
    }
    let count = partners[row].body;
    for (var k = 1u; k <= count; k++) {
        let entry = partners[k * grid.capacity + row];
        let pair = pair_with(row, entry);
        if pair != NONE && touches[pair].points > 0u {
            live += 1u;
            let side = select(0u, 1u, (entry.body & BODY) < row);
            incidents[live * grid.capacity + row] = 2u * (pairs_of.before + pair) + side;
            add(&sum, given_by(pairs_of.before + pair, side));
        }
    }
    incidents[row] = live;
    return sum;
}
// ANCHOR_END: gather_last

// How many workgroups solve limits and pairs: those of limits come before those of the pairs, in whole
// workgroups.
fn count_groups() {
    let limits = (pairs_of.limits + WORKGROUP - 1u) / WORKGROUP * WORKGROUP;
    let count = groups_for(limits + status[LIVE]);
    groups[0] = count.x;
    groups[1] = count.y;
    groups[2] = count.z;
}

// ANCHOR: start
@compute @workgroup_size(WORKGROUP)
fn pair_start(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    if row == 0u {
        count_groups();
        status[STEPS] += 1u;
    }
    var rigid = rigids[row];
    if is_static(rigid) {
        return;
    }
    let sum = gather_last(row, rigid);
    var holding = Holding(sum.stays_linear, 0.0, sum.stays_angular, 0.0, holdings[row].momentum, 0.0);
    rigid.shares = max(sum.counts, 1.0);
    if !PULLS {
        var of_tree: Held;
        if JOINTS && in_tree(rigid) {
            of_tree = joined[rigid.seat];
        }
        kick_row(row, &rigid, &holding, of_tree, pull_of_mouse(row, rigid));
    }
    holdings[row] = holding;
    rigids[row].velocity = rigid.velocity;
    rigids[row].shares = rigid.shares;
    rigids[row].angular_velocity = rigid.angular_velocity;
}
// ANCHOR_END: start
