// Joints that close a loop, an invocation a joint: it reads both bodies and writes its own impulses. Names
// as in `ch06_compute::own_row::loops`, where it is told.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector, rows, common/side,
// common/symmetric, common/articulated, common/link, common/point_reply.

@group(0) @binding(0) var<uniform> step: Step;
@group(0) @binding(1) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(2) var<storage, read_write> loops: array<Node>;
@group(0) @binding(3) var<storage, read_write> loop_presses: array<Pressed>;

// The share of a gap that a substep's push closes.
const LOOP_SHARE: f32 = 0.2;
// Sweeps over the point and the axes of a hinge.
const LOOP_SWEEPS: u32 = 2u;

// What the joint gave in the last substep, as it acts now.
fn again(node: Node, link: Link) -> Wrench {
    let along = link.along * dot(link.along, node.impulse);
    return Wrench(select(node.impulse, along, node.kind == ROD), without(node.turning, link.along));
}

// A body that doesn't move: what its joint wants is then to close the gap and no more.
fn still(side: Side) -> Bone {
    var bone: Bone;
    bone.position = side.position;
    bone.attitude = side.attitude;
    return bone;
}

// ANCHOR: mend
// Mends `given` so that the relative motion at the joint's point becomes `wanted`: first of the point, then
// of a hinge's axes.
fn mend(kind: u32, link: Link, wanted: Rate, given: ptr<function, Wrench>, sides: ptr<function, Sides>) {
    let reply = symmetric_plus(point_reply((*sides).a, link.parent_arm), point_reply((*sides).b, link.arm));
    for (var sweep = 0u; sweep < LOOP_SWEEPS; sweep++) {
        let parts = parting_at(link, sides);
        var impulse: vec3f;
        if kind == ROD {
            let lacks = wanted.velocity.x - dot(link.along, parts);
            let answer = dot(link.along, symmetric_times(reply, link.along));
            impulse = link.along * (lacks / max(answer, LEAST));
        } else {
            let holding = symmetric_inverse(reply, (*sides).a.shared_mass + (*sides).b.shared_mass);
            impulse = symmetric_times(holding, wanted.velocity - parts);
        }
        take_both(sides, impulse, -cross(link.parent_arm, impulse), cross(link.arm, impulse));
        (*given).impulse += impulse;
        if kind == HINGE {
            let turning = aligning(link.along, wanted.spin, sides);
            take_both(sides, vec3f(0.0), -turning, turning);
            (*given).turning += turning;
        }
    }
}
// ANCHOR_END: mend

// Velocity of b's point away from a's, m/s.
fn parting_at(link: Link, sides: ptr<function, Sides>) -> vec3f {
    return (*sides).b.velocity + cross((*sides).b.angular_velocity, link.arm)
        - (*sides).a.velocity - cross((*sides).a.angular_velocity, link.parent_arm);
}

// The angular impulse across a hinge's axis that makes the relative spin there what is wanted.
fn aligning(axis: vec3f, wanted: vec3f, sides: ptr<function, Sides>) -> vec3f {
    let u = across(axis);
    let w = cross(axis, u);
    let lacks = wanted - ((*sides).b.angular_velocity - (*sides).a.angular_velocity);
    let by_u = (*sides).a.shared_inertia * u + (*sides).b.shared_inertia * u;
    let by_w = (*sides).a.shared_inertia * w + (*sides).b.shared_inertia * w;
    let uu = dot(u, by_u);
    let uw = dot(u, by_w);
    let ww = dot(w, by_w);
    let along_u = dot(u, lacks);
    let along_w = dot(w, lacks);
    let sharing = 1.0 / max(uu * ww - uw * uw, LEAST);
    return (u * (ww * along_u - uw * along_w) + w * (uu * along_w - uw * along_u)) * sharing;
}

// ANCHOR: loops
@compute @workgroup_size(WORKGROUP)
fn solve_loops(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= arrayLength(&loops) {
        return;
    }
    let node = loops[row];
    let before = loop_presses[row];
    var sides = Sides(side_of(rigids[node.parent_body]), side_of(rigids[node.body]));
    var none: Bone;
    let link = link_of(node, still(sides.b), still(sides.a), none, step.h);
    var given = again(node, link);
    let change = given.impulse - before.linear;
    let turning_a = wrench_at(given, -link.parent_arm).turning * -1.0 - before.turning[0].xyz;
    let turning_b = wrench_at(given, -link.arm).turning - before.turning[2].xyz;
    take_both(&sides, change, turning_a, turning_b);
    var rest: Rate;
    mend(node.kind, link, rest, &given, &sides);
    stop_both(&sides);
    var pushed: Wrench;
    let closes = Rate(LOOP_SHARE * link.wanted[0].velocity, LOOP_SHARE * link.wanted[0].spin);
    mend(node.kind, link, closes, &pushed, &sides);
    loops[row].impulse = given.impulse;
    loops[row].turning = given.turning;
    loop_presses[row].linear = given.impulse;
    loop_presses[row].counts = 1.0;
    loop_presses[row].push = pushed.impulse;
    loop_presses[row].turning[0] = vec4f(-wrench_at(given, -link.parent_arm).turning, 0.0);
    loop_presses[row].turning[1] = vec4f(-wrench_at(pushed, -link.parent_arm).turning, 0.0);
    loop_presses[row].turning[2] = vec4f(wrench_at(given, -link.arm).turning, 0.0);
    loop_presses[row].turning[3] = vec4f(wrench_at(pushed, -link.arm).turning, 0.0);
}
// ANCHOR_END: loops
