// The points where two cores meet along a known normal. If it stands on a face, the other core's widest
// feature lies on that; if not, two edges meet.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots,
// common/narrow_faces, common/narrow_edges, common/narrow_axis, common/narrow_simplex,
// common/narrow_gjk, common/narrow_way.

// The points of two bodies that part soonest along `way`, those with a gap of at most `margin`, m.
fn contacts(a: Core, b: Core, way: Way, margin: f32) -> Spots {
    let n = way.normal;
    let rounds = a.round + b.round;
    var spots = no_spots(n, FIXED, margin + rounds);
    let on_a = stands_on_face(a, n);
    let on_b = stands_on_face(b, n);
    if on_a || on_b {
        let of_a = face_towards(a, n);
        let of_b = face_towards(b, -n);
        faces_meet(&spots, a, b, of_a, of_b, slack(a, b));
        spots.lift_a = lift(a, of_a.shape, n);
        spots.lift_b = lift(b, of_b.shape, n);
        spots.turns = turns(on_a && of_b.shape == EDGE, on_b && of_a.shape == EDGE);
    } else {
        let of_a = edge_towards(a, n);
        let of_b = edge_towards(b, -n);
        spots.lift_a = lift(a, EDGE, n);
        spots.lift_b = lift(b, EDGE, n);
        let gap = way.apart + rounds;
        let push = max(GAP * smaller_size(a, b) - gap, 0.0);
        let round_a = a.round + spots.lift_a;
        let round_b = b.round + spots.lift_b;
        edges_meet(&spots, of_a, of_b, Meeting(gap, push, round_a, round_b, slack(a, b)));
        spots.turns = turns(a.kind == BOX && b.kind == CAPSULE, false);
    }
    return spots;
}

// How the normal turns: with the body on whose face something round lies, else not at all.
fn turns(with_a: bool, with_b: bool) -> u32 {
    if with_a {
        return WITH_A;
    }
    return select(FIXED, WITH_B, with_b);
}

// How far from the surface, along the normal, a cylinder's axis is where it lies on its side or rolls
// on its rim, m. A core point there stays where it is while the cylinder spins.
fn lift(core: Core, shape: u32, n: vec3f) -> f32 {
    let d = to_own(core, n);
    let across = dot(d, outward(d));
    if core.kind != CYLINDER || shape != EDGE || across < CAP_COSINE {
        return 0.0;
    }
    return core.half.x / across;
}
