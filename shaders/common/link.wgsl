// Where a joint is and what it wants: the geometry of a substep. Names as in
// `ch06_compute::own_row::tree`. Needs common/rotation, rows, common/symmetric, common/articulated.

// The plan: whether the scene has hinges, and whether it has rods.
override HINGES: bool = true;
override RODS: bool = true;

// The share of a gap that a substep closes in any case.
const JOINT_SHARE: f32 = 0.2;
// Up to this, m/s and rad/s, it closes a gap once more, and all of it.
const GENTLE_CLOSING: f32 = 0.2;
const GENTLE_ALIGNING: f32 = 1.0;
// The fastest that a gap closes, m/s, and that a hinge's axes come together, rad/s.
const FASTEST_CLOSING: f32 = 10.0;
const FASTEST_ALIGNING: f32 = 20.0;
// Below this a length, m, its square, or a reply is none.
const LEAST: f32 = 1e-12;

// ANCHOR: bone
// A body of a tree, as its joints see it.
struct Bone {
    position: vec3f,
    inverse_mass: f32,
    attitude: vec4f,
    inverse_inertia: vec3f,
    // How it moves, and how it is pushed.
    rate: Rate,
    push: Rate,
}
// ANCHOR_END: bone

// ANCHOR: link
struct Link {
    // r: from the body's centre to the joint's point c, m.
    arm: vec3f,
    // s: from the parent's centre to c, m.
    parent_arm: vec3f,
    // A hinge's axis; the direction of a rod.
    along: vec3f,
    // The direction of the second rod.
    second: vec3f,
    // What the joint wants the relative motion at c to change by: first of the velocities, then of the
    // pushes. Rods want speeds along them: x of the first, y of the second.
    wanted: array<Rate, 2>,
}
// ANCHOR_END: link

// ANCHOR: link_of
// The joint of a node between bodies where they are now. `second` is what the second of two rods hangs on.
fn link_of(node: Node, child: Bone, parent: Bone, second: Bone, h: f32) -> Link {
    var link: Link;
    if RODS && node.kind >= ROD {
        return rods(node, child, parent, second, h);
    }
    if node.kind >= PIN {
        link = pinned(node, child, parent, h);
    }
    if HINGES && node.kind == HINGE {
        align(&link, node, child, parent, h);
    }
    return link;
}
// ANCHOR_END: link_of

// ANCHOR: closing
// How fast a gap closes.
fn closing(gap: vec3f, gentle: f32, fastest: f32, h: f32) -> vec3f {
    return at_most(gap * (JOINT_SHARE / h) + at_most(gap / h, gentle), fastest);
}
// ANCHOR_END: closing

// ANCHOR: pinned
// Two points. Impulses act midway between them, or the pair of them would turn both bodies while there is
// a gap.
fn pinned(node: Node, child: Bone, parent: Bone, h: f32) -> Link {
    let apart = child.position - parent.position;
    let anchor = quat_rotate(child.attitude, node.anchor);
    let gap = apart + anchor - quat_rotate(parent.attitude, node.parent_anchor);
    var link: Link;
    link.arm = anchor - 0.5 * gap;
    link.parent_arm = link.arm + apart;
    link.wanted[0].velocity = -relative(child.rate, parent.rate, link)
        - closing(gap, GENTLE_CLOSING, FASTEST_CLOSING, h);
    link.wanted[1].velocity = -relative(child.push, parent.push, link);
    return link;
}

// Ċ: the velocity at c of the child against the parent.
fn relative(child: Rate, parent: Rate, link: Link) -> vec3f {
    return rate_at(child, link.arm).velocity - rate_at(parent, link.parent_arm).velocity;
}
// ANCHOR_END: pinned

// ANCHOR: align
// Two axes. Â_p × Â is, to first order, the turn by which the child's axis has left the parent's.
fn align(link: ptr<function, Link>, node: Node, child: Bone, parent: Bone, h: f32) {
    let axis = quat_rotate(child.attitude, node.axis);
    let left = cross(quat_rotate(parent.attitude, node.parent_axis), axis);
    (*link).along = axis;
    (*link).wanted[0].spin = without(parent.rate.spin - child.rate.spin, axis)
        - closing(left, GENTLE_ALIGNING, FASTEST_ALIGNING, h);
    (*link).wanted[1].spin = without(parent.push.spin - child.push.spin, axis);
}

// What of v is across an axis.
fn without(v: vec3f, axis: vec3f) -> vec3f {
    return v - axis * dot(axis, v);
}
// ANCHOR_END: align

// ANCHOR: rods
// One or two distances from the child's point, which is c: a rod's impulse acts along it, so it may be
// taken at either end.
fn rods(node: Node, child: Bone, parent: Bone, second: Bone, h: f32) -> Link {
    var link: Link;
    link.arm = quat_rotate(child.attitude, node.anchor);
    link.parent_arm = link.arm + (child.position - parent.position);
    let first = rod(node.parent_anchor, node.length, child, parent, link.arm, h);
    link.along = first.along;
    link.wanted[0].velocity.x = first.wanted;
    link.wanted[1].velocity.x = first.pushed;
    if node.kind == TWO_RODS {
        let other = rod(node.parent_axis, node.second_length, child, second, link.arm, h);
        link.second = other.along;
        link.wanted[0].velocity.y = other.wanted;
        link.wanted[1].velocity.y = other.pushed;
    }
    return link;
}

// A rod: its direction, and what it wants its stretching to change by.
struct Rod {
    along: vec3f,
    wanted: f32,
    pushed: f32,
}

fn rod(hook_in_parent: vec3f, length_wanted: f32, child: Bone, parent: Bone, arm: vec3f, h: f32) -> Rod {
    let hook = quat_rotate(parent.attitude, hook_in_parent);
    let line = child.position - parent.position + arm - hook;
    let distance = length(line);
    let along = line / max(distance, LEAST);
    let gap = along * (distance - length_wanted);
    let moving = rate_at(child.rate, arm).velocity - rate_at(parent.rate, hook).velocity;
    let pushed = rate_at(child.push, arm).velocity - rate_at(parent.push, hook).velocity;
    let closes = closing(gap, GENTLE_CLOSING, FASTEST_CLOSING, h);
    return Rod(along, -dot(along, moving) - dot(along, closes), -dot(along, pushed));
}
// ANCHOR_END: rods

// The same direction, no longer than `most`.
fn at_most(v: vec3f, most: f32) -> vec3f {
    return v * (most / max(length(v), most));
}
