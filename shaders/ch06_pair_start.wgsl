// A body looks up its pairs and takes up what pressed it in the last step, where its points are now; then
// the first kick of the step.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/body.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<uniform> mouse: Mouse;
@group(0) @binding(3) var<storage, read_write> rigids: array<Rigid>;
@group(0) @binding(4) var<storage, read_write> holdings: array<Holding>;
@group(0) @binding(5) var<storage, read> partners: array<Partner>;
@group(0) @binding(6) var<storage, read> touches: array<Contact>;
@group(0) @binding(7) var<storage, read> presses: array<Pressed>;
@group(0) @binding(8) var<storage, read_write> incidents: array<u32>;
@group(0) @binding(9) var<storage, read_write> groups: array<u32>;
@group(0) @binding(10) var<storage, read_write> status: array<u32>;
@group(0) @binding(11) var<storage, read> totals: array<Total>;
@group(0) @binding(12) var<storage, read_write> befores: array<Before>;
@group(0) @binding(13) var<storage, read> joined: array<Held>;
@group(0) @binding(14) var<uniform> pairs_of: PairsOf;
@group(0) @binding(15) var<storage, read> turned: array<Turned>;

// The plan: whether any pair bounces, whether there are joints, whether any large body moves, and whether
// what pulls is summed in a pass of its own.
override BOUNCES: bool = true;
override JOINTS: bool = true;
override MOVING_LARGE: bool = true;
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

// ANCHOR: start
@compute @workgroup_size(WORKGROUP)
fn pair_start(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    if row == 0u {
        // Limits have workgroups of their own, before those of the pairs.
        let limits = (pairs_of.limits + WORKGROUP - 1u) / WORKGROUP * WORKGROUP;
        let count = groups_for(limits + status[LIVE]);
        groups[0] = count.x;
        groups[1] = count.y;
        groups[2] = count.z;
        status[STEPS] += 1u;
    }
    var rigid = rigids[row];
    if is_static(rigid) {
        return;
    }
    var sum: Total;
    if MOVING_LARGE && rigid.large != NONE {
        sum = totals[rigid.large];
    }
    // Limits and loops end at the same bodies always: they stand first in the list.
    var live = select(0u, rigid.ends, JOINTS);
    for (var k = 1u; k <= live; k++) {
        let entry = incidents[k * grid.capacity + row];
        if (entry & OF_LIMIT) != 0u {
            let sign = select(-1.0, 1.0, (entry & 1u) == 1u);
            add_turned(&sum, turned[(entry & ~OF_LIMIT) >> 1u], sign);
        } else {
            add_loop(&sum, entry >> 1u, entry & 1u);
        }
    }
    let count = partners[row].body;
    for (var k = 1u; k <= count; k++) {
        let entry = partners[k * grid.capacity + row];
        let pair = pair_with(row, entry);
        if pair != NONE && touches[pair].points > 0u {
            live += 1u;
            let side = select(0u, 1u, (entry.body & BODY) < row);
            incidents[live * grid.capacity + row] = 2u * (pairs_of.before + pair) + side;
            add_pair(&sum, pairs_of.before + pair, side);
        }
    }
    incidents[row] = live;
    var holding = Holding(sum.stays_linear, 0.0, sum.stays_angular, 0.0, holdings[row].momentum, 0.0);
    rigid.shares = max(sum.counts, 1.0);
    if BOUNCES {
        befores[row] = Before(rigid.velocity, 0.0, rigid.angular_velocity, 0.0);
    }
    if !PULLS {
        var pull: Pull;
        if mouse.body == row {
            pull = drag(rigid, mouse);
        }
        var of_tree: Held;
        if JOINTS && in_tree(rigid) {
            of_tree = joined[rigid.seat];
        }
        kick(&rigid, &holding, of_tree, pull, step);
    }
    holdings[row] = holding;
    rigids[row].velocity = rigid.velocity;
    rigids[row].shares = rigid.shares;
    rigids[row].angular_velocity = rigid.angular_velocity;
}
// ANCHOR_END: start

// Adds what a joint that closes a loop gave in the last substep.
fn add_loop(sum: ptr<function, Total>, row: u32, side: u32) {
    var given: Given;
    given.linear = vec4f(presses[row].linear, 1.0);
    given.angular = vec4f(presses[row].turning[2u * side].xyz, 1.0);
    given.sign = select(-1.0, 1.0, side == 1u);
    add(sum, given);
}

// Adds what a pair pressed in the last step, where its points are now.
fn add_pair(sum: ptr<function, Total>, row: u32, side: u32) {
    var given: Given;
    given.linear = vec4f(presses[row].linear, presses[row].counts);
    given.angular = presses[row].turning[2u * side];
    given.sign = select(-1.0, 1.0, side == 1u);
    add(sum, given);
}
