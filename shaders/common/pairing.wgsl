// How bodies are named in the lists of those that they may touch, and which kind of pair two are.
// Needs rows.

// The bits of a row in `Bound.body` and `Partner.body`.
const BODY: u32 = 0x07ffffffu;

// In `Bound.body`, above them: the kind in two bits, and whether the body is static.
const KIND_SHIFT: u32 = 27u;
const STATIC: u32 = 0x20000000u;

// In `Bound.flags`: the body is too large, or too fast, for the grid.
const OVERSIZED: u32 = 1u;
const RUSHING: u32 = 2u;

// In `Partner.body`, above them: where the pair is listed, in four bits, and whether by this body.
const SLOT_SHIFT: u32 = 27u;
const LISTED: u32 = 0x80000000u;

// Where the pairs of two bodies of these kinds are listed: by `pair_kind`, without the kinds that the
// scene can't have.
fn slot_of_pair(pairs_of: PairsOf, kind_a: u32, kind_b: u32) -> u32 {
    let low = min(kind_a, kind_b);
    let high = max(kind_a, kind_b);
    let kind = low * (7u - low) / 2u + high;
    let slots = select(pairs_of.low_slots, pairs_of.high_slots, kind >= 8u);
    return (slots >> (4u * (kind & 7u))) & 15u;
}

// Whether a body hangs in a tree of joints.
fn in_tree(rigid: Rigid) -> bool {
    return rigid.role != ON_POINT && rigid.seat != NONE;
}
