// A substep of the bodies, an invocation a body: it gathers what its pairs did to it, puts that in the
// place of what it started with, moves, and takes up what pulls and holds it for the next substep.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/body.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<uniform> mouse: Mouse;
@group(0) @binding(3) var<storage, read_write> rigids: array<Rigid>;
@group(0) @binding(4) var<storage, read_write> helds: array<Held>;
@group(0) @binding(5) var<storage, read> incidents: array<u32>;
@group(0) @binding(6) var<storage, read> presses: array<Pressed>;
@group(0) @binding(7) var<storage, read_write> status: array<u32>;
@group(0) @binding(8) var<storage, read> totals: array<Total>;
@group(0) @binding(9) var<storage, read> pivots: array<Pivot>;

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
        let linear = vec4f(presses[pair].linear, presses[pair].counts);
        let push = vec4f(presses[pair].push, presses[pair].bounces);
        let angular = presses[pair].turning[2u * side].xyz;
        let push_angular = presses[pair].turning[2u * side + 1u].xyz;
        add(&sum, linear, push, angular, push_angular, side);
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
    let old = helds[row];
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
    exchange(&rigid, old, sum.linear, sum.angular);
    if PIVOTS && rigid.pivot != NOBODY {
        let push = moved_by(rigid, sum.push_angular);
        turn_about(&rigid, pivots[rigid.pivot], push, step);
    } else {
        advance(&rigid, sum, step);
    }
    let held = Held(sum.linear, 0.0, sum.angular, 0.0);
    helds[row] = held;
    rigid.shares = max(select(sum.counts, sum.bounces, LAST && BOUNCES), 1.0);
    if !LAST && !PULLS {
        var pull: Pull;
        if mouse.body == row {
            pull = drag(rigid, mouse);
        }
        kick(&rigid, held, pull, step);
    }
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
    let sum = gather(row, rigid.large);
    exchange(&rigid, Held(), sum.linear, sum.angular);
    rigids[row].velocity = rigid.velocity;
    rigids[row].angular_velocity = rigid.angular_velocity;
}
// ANCHOR_END: rebound
