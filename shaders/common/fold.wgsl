// A node on the way up to the root and on the way down again. Names as in
// `ch06_compute::own_row::tree::fold`, where it is told.
// Needs common/rotation, rows, common/symmetric, common/articulated, common/link.

// How much of the stiffness that a pull gives a joint stands in the inertia.
const PULL_SHARE: f32 = 0.5;
// Two rods whose directions are this near to one line, as the square of their sine, pull as if they were
// not quite.
const LEAST_SINE2: f32 = 1e-4;

// ANCHOR: carried
// What a body and all that hangs on it answer, and what moves them: first for the velocities, then for the
// pushes.
struct Carried {
    articulated: Articulated,
    wrench: array<Wrench, 2>,
}
// ANCHOR_END: carried

// ANCHOR: kept
// What a node keeps from the way up for the way down.
struct Kept {
    // Δω = rest − gain · Δv_c. Of a hinge the columns are what velocity and spin make of its turn, and its
    // axis.
    gain: mat3x3f,
    // The body's spin while the joint's point stays; of a hinge x is its turn.
    rest: array<vec3f, 2>,
    // K⁻¹: how the joint's point yields, for joints that leave it free in some direction.
    give: Symmetric,
    // How the joint's point moves if nothing holds it.
    free: array<vec3f, 2>,
}
// ANCHOR_END: kept

// What a fold gives.
struct Folded {
    kept: Kept,
    felt: Carried,
}

// The sum of both, which are taken at the same point.
fn carried_plus(body: ptr<function, Carried>, other: Carried) {
    (*body).articulated.mass = symmetric_plus((*body).articulated.mass, other.articulated.mass);
    (*body).articulated.coupling += other.articulated.coupling;
    (*body).articulated.inertia = symmetric_plus((*body).articulated.inertia, other.articulated.inertia);
    for (var k = 0u; k < 2u; k++) {
        (*body).wrench[k].impulse += other.wrench[k].impulse;
        (*body).wrench[k].turning += other.wrench[k].turning;
    }
}

// ANCHOR: stands
// A body before anything is folded into it.
fn stands(node: Node, bone: Bone, link: Link, h: f32) -> Carried {
    var body: Carried;
    body.articulated = articulated_of_body(bone.inverse_mass, bone.inverse_inertia, bone.attitude);
    body.articulated.inertia = stiffened(body.articulated.inertia, link.arm, node.impulse, h);
    return body;
}

// What the parent feels, with the stiffness that the pull of the joint gives the parent.
fn pulled(node: Node, link: Link, felt: Carried, h: f32) -> Carried {
    var stiff = felt;
    let inertia = felt.articulated.inertia;
    stiff.articulated.inertia = stiffened(inertia, link.parent_arm, -node.impulse, h);
    return stiff;
}
// ANCHOR_END: stands

// ANCHOR: stiffened
// The inertia of a body that is pulled at an arm's end, as it was in the last substep.
fn stiffened(inertia: Symmetric, arm: vec3f, impulse: vec3f, h: f32) -> Symmetric {
    let pull = (PULL_SHARE * h) * max(dot(arm, impulse), 0.0);
    let along = symmetric_scaled(symmetric_outer(arm), -pull / max(dot(arm, arm), LEAST));
    return symmetric_plus(symmetric_plus(inertia, symmetric_splat(pull)), along);
}
// ANCHOR_END: stiffened

// ANCHOR: fold
// On the way up: folds a body, with all that was folded into it, into its joint. Gives what it keeps for
// the way down, and what the parent feels, about the parent's centre.
fn fold(kind: u32, link: Link, bone: Bone, body: Carried) -> Folded {
    var at_joint: Carried;
    at_joint.articulated = articulated_at(body.articulated, link.arm);
    at_joint.wrench[0] = wrench_at(body.wrench[0], link.arm);
    at_joint.wrench[1] = wrench_at(body.wrench[1], link.arm);
    var folded: Folded;
    if HINGES && kind == HINGE {
        folded = fold_hinge(link, bone, at_joint);
    } else {
        folded = fold_point(kind, link, bone, at_joint);
    }
    folded.felt.wrench[0] = wrench_at(folded.felt.wrench[0], -link.parent_arm);
    folded.felt.wrench[1] = wrench_at(folded.felt.wrench[1], -link.parent_arm);
    return folded;
}
// ANCHOR_END: fold

// ANCHOR: fold_point
// A joint about whose point the body turns freely: it gives way until no angular impulse is left. What is
// felt at the point is the mass K = A − Cᵀ D⁻¹ C.
fn fold_point(kind: u32, link: Link, bone: Bone, at_joint: Carried) -> Folded {
    let c = at_joint.articulated.coupling;
    let stiffest = most_of(bone.inverse_inertia);
    let turns = symmetric_inverse(at_joint.articulated.inertia, 1.0 / stiffest);
    var folded: Folded;
    let gain = mat3x3f(
        symmetric_times(turns, c[0]),
        symmetric_times(turns, c[1]),
        symmetric_times(turns, c[2]),
    );
    let felt = less_product(at_joint.articulated.mass, gain, c);
    var impulse: array<vec3f, 2>;
    for (var k = 0u; k < 2u; k++) {
        let wrench = at_joint.wrench[k];
        impulse[k] = wrench.impulse - wrench.turning * gain;
        folded.kept.rest[k] = symmetric_times(turns, wrench.turning);
    }
    folded.kept.gain = gain;
    if kind == PIN {
        for (var k = 0u; k < 2u; k++) {
            let held = symmetric_times(felt, link.wanted[k].velocity);
            folded.felt.wrench[k].impulse = impulse[k] - held;
        }
        folded.felt.articulated = articulated_felt_at(felt, link.parent_arm);
        return folded;
    }
    let least = 1.0 / (bone.inverse_mass + dot(link.arm, link.arm) * stiffest);
    folded.kept.give = symmetric_inverse(felt, least);
    folded.kept.free[0] = symmetric_times(folded.kept.give, impulse[0]);
    folded.kept.free[1] = symmetric_times(folded.kept.give, impulse[1]);
    if RODS && kind >= ROD {
        folded.felt = fold_rods(kind, link, folded.kept);
    }
    return folded;
}

// A − Gᵀ C where that is symmetric.
fn less_product(a: Symmetric, g: mat3x3f, c: mat3x3f) -> Symmetric {
    return Symmetric(
        a.diagonal - vec3f(dot(g[0], c[0]), dot(g[1], c[1]), dot(g[2], c[2])),
        a.off - vec3f(dot(g[1], c[2]), dot(g[2], c[0]), dot(g[0], c[1])),
    );
}

// The largest of three.
fn most_of(v: vec3f) -> f32 {
    return max(v.x, max(v.y, v.z));
}
// ANCHOR_END: fold_point

// ANCHOR: fold_rods
// One or two rods, of which the parent feels what acts along them: with U their directions the mass
// U κ Uᵀ, κ = (Uᵀ K⁻¹ U)⁻¹.
fn fold_rods(kind: u32, link: Link, kept: Kept) -> Carried {
    let u1 = link.along;
    let u2 = link.second;
    let n1 = symmetric_times(kept.give, u1);
    let reply = max(dot(u1, n1), LEAST);
    var carried: Carried;
    var mass = symmetric_scaled(symmetric_outer(u1), 1.0 / reply);
    var first: array<f32, 2>;
    for (var k = 0u; k < 2u; k++) {
        first[k] = dot(u1, kept.free[k]) - link.wanted[k].velocity.x;
        carried.wrench[k].impulse = u1 * (first[k] / reply);
    }
    if kind == TWO_RODS {
        let n2 = symmetric_times(kept.give, u2);
        let both = dot(u1, n2);
        let other = max(dot(u2, n2), LEAST);
        let sharing = 1.0 / max(reply * other - both * both, LEAST_SINE2 * reply * other);
        mass = symmetric_scaled(symmetric_outer(u1), other * sharing);
        mass = symmetric_plus(mass, symmetric_scaled(symmetric_outer(u2), reply * sharing));
        mass = symmetric_plus(mass, symmetric_scaled(symmetric_outer_pair(u1, u2), -both * sharing));
        for (var k = 0u; k < 2u; k++) {
            let second = dot(u2, kept.free[k]) - link.wanted[k].velocity.y;
            let along = u1 * (other * first[k] - both * second);
            carried.wrench[k].impulse = (along + u2 * (reply * second - both * first[k])) * sharing;
        }
    }
    carried.articulated = articulated_felt_at(mass, link.parent_arm);
    return carried;
}
// ANCHOR_END: fold_rods

// ANCHOR: fold_hinge
// A hinge: the body gives way about its axis alone, until no angular impulse is left along that.
fn fold_hinge(link: Link, bone: Bone, at_joint: Carried) -> Folded {
    let body = at_joint.articulated;
    let axis = link.along;
    let turning = symmetric_times(body.inertia, axis);
    let moving = axis * body.coupling;
    let reply = 1.0 / max(dot(axis, turning), 1.0 / most_of(bone.inverse_inertia));
    var felt: Articulated;
    felt.mass = symmetric_plus(body.mass, symmetric_scaled(symmetric_outer(moving), -reply));
    felt.coupling = body.coupling
        - reply * mat3x3f(turning * moving.x, turning * moving.y, turning * moving.z);
    felt.inertia = symmetric_plus(body.inertia, symmetric_scaled(symmetric_outer(turning), -reply));
    var folded: Folded;
    for (var k = 0u; k < 2u; k++) {
        let wrench = at_joint.wrench[k];
        let turns = reply * dot(axis, wrench.turning);
        let wanted = articulated_times(felt, link.wanted[k]);
        folded.felt.wrench[k].impulse = wrench.impulse - moving * turns - wanted.impulse;
        folded.felt.wrench[k].turning = wrench.turning - turning * turns - wanted.turning;
        folded.kept.rest[k] = vec3f(turns, 0.0, 0.0);
    }
    folded.kept.gain = mat3x3f(moving * reply, turning * reply, axis);
    folded.felt.articulated = articulated_at(felt, -link.parent_arm);
    return folded;
}
// ANCHOR_END: fold_hinge

// How a body's motion changes, and by what impulse at its joint's point.
struct Unfolded {
    change: array<Rate, 2>,
    given: vec3f,
}

// ANCHOR: unfold
// On the way down: how the body's motion changes, for velocities and pushes, where its parent's does so;
// and the impulse at the joint's point that changes its velocity.
fn unfold(kind: u32, link: Link, kept: Kept, felt: Carried, parent: array<Rate, 2>) -> Unfolded {
    var unfolded: Unfolded;
    for (var k = 0u; k < 2u; k++) {
        let above = parent[k];
        let given = symmetric_times(felt.articulated.mass, above.velocity)
            + above.spin * felt.articulated.coupling - felt.wrench[k].impulse;
        let here = rate_at(above, link.parent_arm);
        if HINGES && kind == HINGE {
            unfolded.change[k] = follow_hinge(link, kept, k, here);
        } else {
            var velocity = here.velocity + link.wanted[k].velocity;
            if kind != PIN {
                velocity = kept.free[k] + symmetric_times(kept.give, given);
            }
            unfolded.change[k] = follow_point(link, kept, k, velocity);
        }
        if k == 0u {
            unfolded.given = given;
        }
    }
    return unfolded;
}

// The body's motion if its joint's point moves so.
fn follow_point(link: Link, kept: Kept, k: u32, velocity: vec3f) -> Rate {
    return rate_at(Rate(velocity, kept.rest[k] - kept.gain * velocity), -link.arm);
}

// The body's motion on a hinge if the parent moves so there.
fn follow_hinge(link: Link, kept: Kept, k: u32, here: Rate) -> Rate {
    let velocity = here.velocity + link.wanted[k].velocity;
    let spin = here.spin + link.wanted[k].spin;
    let turn = kept.rest[k].x - dot(kept.gain[0], velocity) - dot(kept.gain[1], spin);
    return rate_at(Rate(velocity, spin + turn * kept.gain[2]), -link.arm);
}
// ANCHOR_END: unfold
