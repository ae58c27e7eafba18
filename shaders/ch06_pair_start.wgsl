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
@group(0) @binding(10) var<storage, read> status: array<u32>;
@group(0) @binding(11) var<storage, read> totals: array<Total>;
@group(0) @binding(12) var<storage, read_write> befores: array<Before>;

// The plan: whether any pair bounces, whether any large body moves, and whether what pulls is summed in a
// pass of its own.
override BOUNCES: bool = true;
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
    return NOBODY;
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
        let count = groups_for(status[LIVE]);
        groups[0] = count.x;
        groups[1] = count.y;
        groups[2] = count.z;
    }
    var rigid = rigids[row];
    if is_static(rigid) {
        return;
    }
    var sum: Total;
    if MOVING_LARGE && rigid.large != NOBODY {
        sum = totals[rigid.large];
    }
    let count = partners[row].body;
    var live = 0u;
    for (var k = 1u; k <= count; k++) {
        let entry = partners[k * grid.capacity + row];
        let pair = pair_with(row, entry);
        if pair != NOBODY && touches[pair].points > 0u {
            live += 1u;
            let side = select(0u, 1u, (entry.body & BODY) < row);
            incidents[live * grid.capacity + row] = 2u * pair + side;
            add_pair(&sum, pair, side);
        }
    }
    incidents[row] = live;
    var holding = Holding(sum.linear, 0.0, sum.angular, 0.0, holdings[row].momentum, 0.0);
    rigid.shares = max(sum.counts, 1.0);
    if BOUNCES {
        befores[row] = Before(rigid.velocity, 0.0, rigid.angular_velocity, 0.0);
    }
    if !PULLS {
        var pull: Pull;
        if mouse.body == row {
            pull = drag(rigid, mouse);
        }
        kick(&rigid, &holding, pull, step);
    }
    holdings[row] = holding;
    rigids[row].velocity = rigid.velocity;
    rigids[row].shares = rigid.shares;
    rigids[row].angular_velocity = rigid.angular_velocity;
}
// ANCHOR_END: start

fn add_pair(sum: ptr<function, Total>, pair: u32, side: u32) {
    var given: Given;
    given.linear = vec4f(presses[pair].linear, presses[pair].counts);
    given.angular = presses[pair].turning[2u * side];
    given.sign = select(-1.0, 1.0, side == 1u);
    add(sum, given);
}
