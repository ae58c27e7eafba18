// A substep of the bodies, an invocation a body: it gathers what its pairs did to it, puts that in the
// place of what it started with, moves, and takes up what pulls and holds it for the next substep.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/body.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<uniform> mouse: Mouse;
@group(0) @binding(3) var<storage, read_write> rigids: array<Rigid>;
@group(0) @binding(4) var<storage, read_write> holdings: array<Holding>;
@group(0) @binding(5) var<storage, read> incidents: array<u32>;
@group(0) @binding(6) var<storage, read> presses: array<Pressed>;
@group(0) @binding(7) var<storage, read_write> status: array<u32>;
@group(0) @binding(8) var<storage, read> totals: array<Total>;
@group(0) @binding(9) var<storage, read> pivots: array<Pivot>;
@group(0) @binding(10) var<storage, read_write> befores: array<Before>;

// The plan: whether any pair bounces, any large body moves, any body hangs on a fixed point, whether
// what pulls is summed in a pass of its own, and whether it is the last substep.
override BOUNCES: bool = true;
override MOVING_LARGE: bool = true;
override PIVOTS: bool = true;
override PULLS: bool = false;
override LAST: bool = false;

// ANCHOR: gather
// Sums what its pairs did to a body, in the order of their IDs.
fn gather(row: u32, large: u32) -> Total {
    var sum: Total;
    if MOVING_LARGE && large != NOBODY {
        sum = totals[large];
    }
    let count = incidents[row];
    var next = incidents[grid.capacity + row];
    for (var k = 1u; k <= count; k++) {
        let pair = next >> 1u;
        let side = next & 1u;
        next = incidents[min(k + 1u, grid.room) * grid.capacity + row];
        var given: Given;
        given.linear = vec4f(presses[pair].linear, presses[pair].counts);
        given.push = vec4f(presses[pair].push, presses[pair].bounces);
        given.angular = presses[pair].turning[2u * side];
        given.push_angular = presses[pair].turning[2u * side + 1u].xyz;
        given.sign = select(-1.0, 1.0, side == 1u);
        add(&sum, given);
    }
    return sum;
}
// ANCHOR_END: gather

// ANCHOR: advance
@compute @workgroup_size(WORKGROUP)
fn pair_advance(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows {
        return;
    }
    let halted = status[HALTED];
    var rigid = rigids[row];
    var holding = holdings[row];
    if halted != 0u {
        return;
    }
    if LAST && row == 0u {
        status[STEPS] += 1u;
    }
    if is_static(rigid) {
        return;
    }
    let sum = gather(row, rigid.large);
    exchange(&rigid, &holding, sum);
    if PIVOTS && rigid.pivot != NOBODY {
        let push = moved_by(rigid, sum.push_angular);
        turn_about(&rigid, &holding, pivots[rigid.pivot], push, step);
    } else {
        advance(&rigid, holding.momentum, sum, step);
    }
    rigid.shares = max(select(sum.counts, sum.bounces, LAST && BOUNCES), 1.0);
    if !LAST && !PULLS {
        if BOUNCES {
            befores[row] = Before(rigid.velocity, 0.0, rigid.angular_velocity, 0.0);
        }
        var pull: Pull;
        if mouse.body == row {
            pull = drag(rigid, mouse);
        }
        kick(&rigid, &holding, pull, step);
    }
    holdings[row] = holding;
    rigids[row].position = rigid.position;
    rigids[row].attitude = rigid.attitude;
    rigids[row].velocity = rigid.velocity;
    rigids[row].shares = rigid.shares;
    rigids[row].angular_velocity = rigid.angular_velocity;
}
// ANCHOR_END: advance

// ANCHOR: rebound
// Adds what restitution gave.
@compute @workgroup_size(WORKGROUP)
fn pair_rebound(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    var rigid = rigids[row];
    if is_static(rigid) {
        return;
    }
    var holding = holdings[row];
    holding.linear = vec3f(0.0);
    holding.angular = vec3f(0.0);
    exchange(&rigid, &holding, gather(row, rigid.large));
    rigids[row].velocity = rigid.velocity;
    rigids[row].angular_velocity = rigid.angular_velocity;
    holdings[row].momentum = holding.momentum;
}
// ANCHOR_END: rebound
