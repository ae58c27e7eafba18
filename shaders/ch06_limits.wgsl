// Angle limits, an invocation a limit: it reads both bodies and writes its own angular impulses.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector, common/swing_twist,
// rows, common/side, common/symmetric, common/point_reply, common/limit.

@group(0) @binding(0) var<uniform> step: Step;
@group(0) @binding(1) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(2) var<storage, read_write> limits: array<Limit>;
@group(0) @binding(3) var<storage, read_write> turned: array<Turned>;

// ANCHOR: limits
@compute @workgroup_size(WORKGROUP)
fn solve_limits(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= arrayLength(&limits) {
        return;
    }
    let limit = limits[row];
    var sides = Sides(side_of(rigids[limit.a]), side_of(rigids[limit.b]));
    let solved = solve_limit(limit, turned[row], &sides, step.h);
    limits[row].impulses = solved.impulses;
    turned[row] = solved.gives;
}
// ANCHOR_END: limits
