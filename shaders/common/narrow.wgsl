// The narrow phase: where two bodies touch or soon may, as a row of up to four points. A pass runs over
// the pairs of one kind, so that the invocations of a workgroup do the same work.
// Needs common/rotation, rows, common/narrow_core, common/narrow_features, common/narrow_spots,
// common/narrow_faces, common/narrow_edges, common/narrow_axis, common/narrow_simplex,
// common/narrow_gjk, common/narrow_way, common/narrow_contacts, common/narrow_convex,
// common/narrow_ball, common/narrow_capsule.

// How many kinds of pairs there are.
const PAIR_KINDS: u32 = 10u;

// The kind of a pair: 0 to 3 a ball with a ball, box, capsule, cylinder; 4 to 6 a box with a box,
// capsule, cylinder; 7 and 8 a capsule with a capsule, cylinder; 9 two cylinders.
fn pair_kind(a: u32, b: u32) -> u32 {
    let low = min(a, b);
    let high = max(a, b);
    return low * (7u - low) / 2u + high;
}

// Where a and b, a pair of this kind, touch or are at most `margin`, m, from touching; without points
// where they are further apart.
fn manifold_of_kind(kind: u32, a: Posed, b: Posed, margin: f32) -> Manifold {
    let swapped = a.kind > b.kind;
    var first = a;
    var second = b;
    if swapped {
        first = b;
        second = a;
    }
    var m = in_order(kind, first, second, margin);
    m.kind = kind;
    if swapped {
        return flipped(m);
    }
    return m;
}

// manifold_of_kind, for a pair whose first body has the smaller kind.
fn in_order(kind: u32, a: Posed, b: Posed, margin: f32) -> Manifold {
    let o = vec3f(0.0);
    let d = b.position - a.position;
    switch kind {
        case 0: {
            return ball_ball(a.size.x, b.size.x, d, margin);
        }
        case 1: {
            return ball_box(a, core_of(BOX, b, d), margin);
        }
        case 2: {
            return ball_capsule(a, core_of(CAPSULE, b, d), margin);
        }
        case 3: {
            return ball_cylinder(a, core_of(CYLINDER, b, d), margin);
        }
        case 4: {
            return convex_convex(core_of(BOX, a, o), core_of(BOX, b, d), margin);
        }
        case 5: {
            return box_capsule(core_of(BOX, a, o), core_of(CAPSULE, b, d), margin);
        }
        case 6: {
            return convex_convex(core_of(BOX, a, o), core_of(CYLINDER, b, d), margin);
        }
        case 7: {
            return capsule_capsule(core_of(CAPSULE, a, o), core_of(CAPSULE, b, d), margin);
        }
        case 8: {
            return convex_convex(core_of(CAPSULE, a, o), core_of(CYLINDER, b, d), margin);
        }
        default: {
            return convex_convex(core_of(CYLINDER, a, o), core_of(CYLINDER, b, d), margin);
        }
    }
}

// The same pair seen from the other body.
fn flipped(m: Manifold) -> Manifold {
    var other = m;
    other.normal = -m.normal;
    if m.turns == WITH_A {
        other.turns = WITH_B;
    }
    if m.turns == WITH_B {
        other.turns = WITH_A;
    }
    other.round_a = m.round_b;
    other.round_b = m.round_a;
    for (var k = 0u; k < 4u; k++) {
        let core_a = other.core_a[k];
        let core_b = other.core_b[k];
        other.core_a[k] = vec4f(core_b.xyz, core_a.w);
        other.core_b[k] = vec4f(core_a.xyz, 0.0);
    }
    return other;
}
