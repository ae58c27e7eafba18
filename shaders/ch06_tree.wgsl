// Mends the velocities and the pushes of the bodies of all trees, so that no joint parts: an invocation a
// node. Contacts, limits and loops have left them so that they do.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector, rows,
// common/symmetric, common/articulated, common/link, common/fold, common/tree.

@group(0) @binding(0) var<uniform> step: Step;
@group(0) @binding(1) var<storage, read_write> nodes: array<Node>;
@group(0) @binding(2) var<storage, read_write> rigids: array<Rigid>;
@group(0) @binding(3) var<storage, read_write> pushes: array<Push>;
@group(0) @binding(4) var<storage, read_write> joined: array<Held>;

// A body, as its joints see it.
fn bone_of(row: u32) -> Bone {
    var bone: Bone;
    bone.position = rigids[row].position;
    bone.attitude = rigids[row].attitude;
    bone.rate = Rate(rigids[row].velocity, rigids[row].angular_velocity);
    bone.push = Rate(pushes[row].velocity, pushes[row].angular_velocity);
    bone.inverse_mass = rigids[row].inverse_mass;
    bone.inverse_inertia = rigids[row].inverse_inertia;
    return bone;
}

// ANCHOR: take_back
// Takes back from a body what its joints gave it at the start of the substep.
fn take_back(bone: ptr<function, Bone>, row: u32) {
    let turned = rotation_moment((*bone).attitude, (*bone).inverse_inertia, joined[row].angular);
    (*bone).rate.velocity -= joined[row].linear * (*bone).inverse_mass;
    (*bone).rate.spin -= turned;
}
// ANCHOR_END: take_back

// The joint of a node where it is now.
fn meet(node: Node, bone: Bone, h: f32) -> Link {
    var link: Link;
    if node.kind < PIN {
        return link;
    }
    var parent: Bone;
    if node.parent == NONE {
        parent = bone_of(node.parent_body);
    } else {
        parent = told_bone(lane_of(node.parent));
    }
    var second: Bone;
    if RODS && node.kind == TWO_RODS {
        second = bone_of(node.second_parent);
    }
    return link_of(node, bone, parent, second, h);
}

// Changes a body's velocities and pushes, and says with what its joints hold it: with what changed its
// velocities.
fn move_body(row: u32, bone: Bone, change: array<Rate, 2>) {
    rigids[row].velocity = bone.rate.velocity + change[0].velocity;
    rigids[row].angular_velocity = bone.rate.spin + change[0].spin;
    pushes[row].velocity = bone.push.velocity + change[1].velocity;
    pushes[row].angular_velocity = bone.push.spin + change[1].spin;
    joined[row].linear = change[0].velocity / bone.inverse_mass;
    joined[row].angular = rotation_moment(bone.attitude, 1.0 / bone.inverse_inertia, change[0].spin);
}

// ANCHOR: tree
@compute @workgroup_size(NODES)
fn tree(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let row = NODES * group_index(group) + lane;
    var node: Node;
    if row < arrayLength(&nodes) {
        node = nodes[row];
    }
    var bone: Bone;
    if node.kind != EMPTY {
        bone = bone_of(node.body);
        take_back(&bone, node.body);
        tell_bone(lane, bone);
    }
    workgroupBarrier();
    let link = meet(node, bone, step.h);
    workgroupBarrier();
    let unfolded = solve_tree(lane, node, bone, link, step.h);
    if node.kind != EMPTY {
        nodes[row].impulse = unfolded.given;
        move_body(node.body, bone, unfolded.change);
    }
}
// ANCHOR_END: tree
