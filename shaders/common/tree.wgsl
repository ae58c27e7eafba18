// All joints of a tree of bodies, solved at once by the invocations of a workgroup: an invocation a node, a
// level of the tree at a time. A tree lies in one workgroup, which may have several. Told in
// `ch06_compute::own_row::tree`.
// Needs common/rotation, rows, common/symmetric, common/articulated, common/link, common/fold.

// Nodes of a workgroup. `own_row::tree::WORKGROUP` says so too.
const NODES: u32 = 64u;

// The deepest level of the workgroup.
var<workgroup> levels: u32;

// What nodes tell each other: where their bodies are and how they move, then what parents feel, then what
// becomes of the parents' motion. The numbers of one node are NODES apart.
var<workgroup> told: array<array<vec4f, NODES>, 9>;

// The place in its workgroup of a node.
fn lane_of(node: u32) -> u32 {
    return node % NODES;
}

// ANCHOR: tell_bone
fn tell_bone(lane: u32, bone: Bone) {
    told[0][lane] = vec4f(bone.position, 0.0);
    told[1][lane] = bone.attitude;
    told[2][lane] = vec4f(bone.rate.velocity, 0.0);
    told[3][lane] = vec4f(bone.rate.spin, 0.0);
    told[4][lane] = vec4f(bone.push.velocity, 0.0);
    told[5][lane] = vec4f(bone.push.spin, 0.0);
}

// As much as joints need of the parent.
fn told_bone(lane: u32) -> Bone {
    var bone: Bone;
    bone.position = told[0][lane].xyz;
    bone.attitude = told[1][lane];
    bone.rate = Rate(told[2][lane].xyz, told[3][lane].xyz);
    bone.push = Rate(told[4][lane].xyz, told[5][lane].xyz);
    return bone;
}
// ANCHOR_END: tell_bone

// ANCHOR: tell_felt
fn tell_felt(lane: u32, felt: Carried) {
    let body = felt.articulated;
    told[0][lane] = vec4f(body.mass.diagonal, body.mass.off.x);
    told[1][lane] = vec4f(body.coupling[0], body.mass.off.y);
    told[2][lane] = vec4f(body.coupling[1], body.mass.off.z);
    told[3][lane] = vec4f(body.coupling[2], body.inertia.off.x);
    told[4][lane] = vec4f(body.inertia.diagonal, body.inertia.off.y);
    told[5][lane] = vec4f(felt.wrench[0].impulse, body.inertia.off.z);
    told[6][lane] = vec4f(felt.wrench[0].turning, 0.0);
    told[7][lane] = vec4f(felt.wrench[1].impulse, 0.0);
    told[8][lane] = vec4f(felt.wrench[1].turning, 0.0);
}

fn told_felt(lane: u32) -> Carried {
    let c0 = told[1][lane];
    let c1 = told[2][lane];
    let c2 = told[3][lane];
    let mass = told[0][lane];
    let inertia = told[4][lane];
    let impulse = told[5][lane];
    var felt: Carried;
    felt.articulated.mass = Symmetric(mass.xyz, vec3f(mass.w, c0.w, c1.w));
    felt.articulated.coupling = mat3x3f(c0.xyz, c1.xyz, c2.xyz);
    felt.articulated.inertia = Symmetric(inertia.xyz, vec3f(c2.w, inertia.w, impulse.w));
    felt.wrench[0] = Wrench(impulse.xyz, told[6][lane].xyz);
    felt.wrench[1] = Wrench(told[7][lane].xyz, told[8][lane].xyz);
    return felt;
}
// ANCHOR_END: tell_felt

fn tell_change(lane: u32, change: array<Rate, 2>) {
    told[0][lane] = vec4f(change[0].velocity, 0.0);
    told[1][lane] = vec4f(change[0].spin, 0.0);
    told[2][lane] = vec4f(change[1].velocity, 0.0);
    told[3][lane] = vec4f(change[1].spin, 0.0);
}

fn told_change(lane: u32) -> array<Rate, 2> {
    return array<Rate, 2>(
        Rate(told[0][lane].xyz, told[1][lane].xyz),
        Rate(told[2][lane].xyz, told[3][lane].xyz),
    );
}

// ANCHOR: solve_tree
// Solves the trees of a workgroup, all of whose invocations must call this together. `bone` has had taken
// back what its joints gave it.
fn solve_tree(lane: u32, node: Node, bone: Bone, link: Link, h: f32) -> Unfolded {
    if lane == 0u {
        levels = node.levels;
    }
    let deepest = workgroupUniformLoad(&levels);
    var kept: Kept;
    // What a node is without its children all of them find at once, before the first level waits for none.
    var body = stands(node, bone, link, h);
    for (var up = 0u; up <= deepest; up++) {
        if node.kind != EMPTY && node.depth == deepest - up {
            for (var child = 0u; child < min(node.children, NODES); child++) {
                let felt = told_felt(lane_of(node.first_child + child));
                carried_plus(&body, felt);
            }
            let folded = fold(node.kind, link, bone, body);
            kept = folded.kept;
            tell_felt(lane, pulled(node, link, folded.felt, h));
        }
        workgroupBarrier();
    }
    var unfolded: Unfolded;
    for (var depth = 0u; depth <= deepest; depth++) {
        if node.kind != EMPTY && node.depth == depth {
            var parent: array<Rate, 2>;
            if node.parent != NONE {
                parent = told_change(lane_of(node.parent));
            }
            let felt = told_felt(lane);
            unfolded = unfold(node.kind, link, kept, felt, parent);
            tell_change(lane, unfolded.change);
        }
        workgroupBarrier();
    }
    return unfolded;
}
// ANCHOR_END: solve_tree
