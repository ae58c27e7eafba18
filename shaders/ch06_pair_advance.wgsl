// A substep of the bodies, an invocation a body: it gathers what its pairs did to it, puts that in the
// place of what it started with, moves, and takes up what pulls and holds it for the next substep. Bodies
// that hang on each other do so tree by tree, and between gathering and moving mend their joints.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/mouse, common/body, common/moving,
// common/symmetric, common/articulated, common/link, common/fold, common/tree.

@group(0) @binding(9) var<storage, read> incidents: array<u32>;
@group(0) @binding(10) var<storage, read> status: array<u32>;
@group(0) @binding(11) var<storage, read> pivots: array<Pivot>;
@group(0) @binding(12) var<storage, read_write> nodes: array<Node>;
@group(0) @binding(13) var<storage, read_write> joined: array<Held>;

// The plan: whether any body hangs on a fixed point, whether what pulls is summed in a pass of its own, and
// whether it is the last substep.
override PIVOTS: bool = true;
override PULLS: bool = false;
override LAST: bool = false;

// ANCHOR: gather
// Sums what its pairs did to a body, in the order of their IDs. `before` of its list are no pairs.
fn gather(row: u32, large: u32, before: u32) -> Total {
    var sum = sum_before(large);
    let count = incidents[row];
    // Two are asked for at once: what waits for memory waits once for both.
    for (var k = before + 1u; k <= count; k += 2u) {
        let first = incidents[k * grid.capacity + row];
        let second = incidents[min(k + 1u, count) * grid.capacity + row];
        let one = given_by(first >> 1u, first & 1u);
        let two = given_by(second >> 1u, second & 1u);
        add(&sum, one);
        if k < count {
            add(&sum, two);
        }
    }
    return sum;
}

// Adds what the limits and loops did that end at the body: they stand first in its list.
fn gather_joints(sum: ptr<function, Total>, row: u32, ends: u32) {
    for (var k = 1u; k <= ends; k++) {
        add_joint(sum, incidents[k * grid.capacity + row]);
    }
}
// ANCHOR_END: gather

// ANCHOR: take_up
// What comes after a body has moved: among how many its mass is shared, and the kick of the next substep.
fn take_up(
    row: u32,
    rigid: ptr<function, Rigid>,
    holding: ptr<function, Holding>,
    of_tree: Held,
    sum: Total,
) {
    (*rigid).shares = max(select(sum.counts, sum.bounces, LAST && BOUNCES), 1.0);
    if !LAST && !PULLS {
        kick_row(row, rigid, holding, of_tree, pull_of_mouse(row, *rigid));
    }
}
// ANCHOR_END: take_up

// Writes what changes in a substep.
fn write(row: u32, rigid: Rigid, holding: Holding) {
    rigids[row].position = rigid.position;
    rigids[row].attitude = rigid.attitude;
    rigids[row].velocity = rigid.velocity;
    rigids[row].shares = rigid.shares;
    rigids[row].angular_velocity = rigid.angular_velocity;
    holdings[row] = holding;
}

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
    if halted != 0u || is_static(rigid) || (JOINTS && in_tree(rigid)) {
        return;
    }
    let ends = select(0u, rigid.ends, JOINTS);
    var sum = gather(row, rigid.large, ends);
    if JOINTS {
        gather_joints(&sum, row, ends);
    }
    exchange(&rigid, &holding, sum);
    let push = push_of(rigid, sum);
    if PIVOTS && rigid.role == ON_POINT {
        turn_about(&rigid, &holding, pivots[rigid.seat], push.angular_velocity, step);
    } else {
        advance(&rigid, holding.momentum, push, sum.touches == 0.0, step);
    }
    take_up(row, &rigid, &holding, Held(), sum);
    write(row, rigid, holding);
}
// ANCHOR_END: advance

// By the place of a tree's root: whether anything holds the tree up. If nothing touches it and it doesn't
// hang on the world, it falls like a body that nothing touches.
var<workgroup> is_held: array<atomic<u32>, NODES>;

// A body, as its joints see it.
fn bone_of(rigid: Rigid) -> Bone {
    var bone: Bone;
    bone.position = rigid.position;
    bone.attitude = rigid.attitude;
    bone.rate = Rate(rigid.velocity, rigid.angular_velocity);
    bone.inverse_mass = rigid.inverse_mass;
    bone.inverse_inertia = rigid.inverse_inertia;
    return bone;
}

// Takes back from a body what its joints gave it at the start of the substep.
fn take_back(bone: ptr<function, Bone>, given: Held) {
    let turned = rotation_moment((*bone).attitude, (*bone).inverse_inertia, given.angular);
    (*bone).rate.velocity -= given.linear * (*bone).inverse_mass;
    (*bone).rate.spin -= turned;
}

// The joint of a node where it is now.
fn link_at(node: Node, bone: Bone) -> Link {
    if node.kind < PIN {
        return Link();
    }
    var parent: Bone;
    if node.parent == NONE {
        parent = bone_of(rigids[node.parent_body]);
    } else {
        parent = told_bone(lane_of(node.parent));
    }
    var second: Bone;
    if RODS && node.kind == TWO_RODS {
        second = bone_of(rigids[node.second_parent]);
    }
    return link_of(node, bone, parent, second, step.h);
}

// With what its joints hold a body: with what changed its velocities.
fn joined_by(bone: Bone, change: Rate) -> Held {
    let turning = rotation_moment(bone.attitude, 1.0 / bone.inverse_inertia, change.spin);
    return Held(change.velocity / bone.inverse_mass, 0.0, turning, 0.0);
}

// ANCHOR: trees
// An invocation a node; a workgroup has whole trees.
@compute @workgroup_size(NODES)
fn pair_trees(
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let at = NODES * group_index(group) + lane;
    var node: Node;
    if at < arrayLength(&nodes) && status[HALTED] == 0u {
        node = nodes[at];
    }
    let row = node.body;
    let is_one = node.kind != EMPTY;
    atomicStore(&is_held[lane], 0u);
    var rigid: Rigid;
    var holding: Holding;
    var sum: Total;
    var bone: Bone;
    if is_one {
        rigid = rigids[row];
        holding = holdings[row];
        sum = gather(row, rigid.large, rigid.ends);
        gather_joints(&sum, row, rigid.ends);
        exchange(&rigid, &holding, sum);
        bone = bone_of(rigid);
        let push = push_of(rigid, sum);
        bone.push = Rate(push.velocity, push.angular_velocity);
        let last = joined[at];
        take_back(&bone, last);
        holding.momentum -= last.angular;
        tell_bone(lane, bone);
    }
    workgroupBarrier();
    let hangs = node.parent == NONE && node.kind != FREE;
    if is_one && (hangs || sum.touches > 0.0) {
        atomicStore(&is_held[lane_of(node.root)], 1u);
    }
    let link = link_at(node, bone);
    workgroupBarrier();
    let unfolded = solve_tree(lane, node, bone, link, step.h);
    if is_one {
        let change = unfolded.change;
        let of_tree = joined_by(bone, change[0]);
        nodes[at].impulse = unfolded.given;
        joined[at] = of_tree;
        rigid.velocity = bone.rate.velocity + change[0].velocity;
        rigid.angular_velocity = bone.rate.spin + change[0].spin;
        holding.momentum += of_tree.angular;
        let push = Push(
            bone.push.velocity + change[1].velocity, 0.0,
            bone.push.spin + change[1].spin, 0.0,
        );
        let floats = atomicLoad(&is_held[lane_of(node.root)]) == 0u;
        advance(&rigid, holding.momentum, push, floats, step);
        take_up(row, &rigid, &holding, of_tree, sum);
        write(row, rigid, holding);
    }
}
// ANCHOR_END: trees

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
    exchange(&rigid, &holding, gather(row, rigid.large, select(0u, rigid.ends, JOINTS)));
    rigids[row].velocity = rigid.velocity;
    rigids[row].angular_velocity = rigid.angular_velocity;
    holdings[row].momentum = holding.momentum;
}
// ANCHOR_END: rebound
