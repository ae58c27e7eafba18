// The shortest way apart, without a polytope. GJK knows the nearest points of bodies that are apart, so
// bodies that overlap are pushed apart first, along the best direction known. The direction that GJK
// finds there is a better one for the bodies where they are, and so on: a step of the proximal method,
// which can only climb.
// Needs common/rotation, common/narrow_core, common/narrow_axis, common/narrow_simplex,
// common/narrow_gjk.

// How far apart cores are pushed, as a share of the smaller body's size.
const GAP: f32 = 0.02;

// Pushes at most.
const MOST_PUSHES: u32 = 8u;

// A push that gains less than this share of the smaller body's size was the last.
const ENOUGH: f32 = 1e-5;

// A direction along which the two are at least as far apart as along `start`, and further than along
// all those near it.
fn push_apart(a: Core, b: Core, start: Way) -> Way {
    let size = smaller_size(a, b);
    let rounds = a.round + b.round;
    var best = start;
    var push = 0.0;
    for (var i = 0u; i < MOST_PUSHES; i++) {
        let normal = gjk(a, b, push * best.normal, best.normal);
        let apart = separation(a, b, normal);
        let gain = apart - best.apart;
        if gain > 0.0 {
            best = Way(normal, apart);
        }
        push = max(GAP * size - rounds - best.apart, 0.0);
        if push == 0.0 || (i > 0u && gain < ENOUGH * size) {
            break;
        }
    }
    return best;
}
