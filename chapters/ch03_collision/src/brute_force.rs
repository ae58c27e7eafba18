//! The broad phase that needs no explanation: ask every pair. With few bodies the fastest.

use crate::aabb::Aabb;

// ANCHOR: all_pairs
/// Calls `found` with every pair i < j of boxes that overlap, in order.
pub fn all_pairs(boxes: &[Aabb], mut found: impl FnMut(usize, usize)) {
    for (i, one) in boxes.iter().enumerate() {
        for (j, other) in boxes.iter().enumerate().skip(i + 1) {
            if one.overlaps(other) {
                found(i, j);
            }
        }
    }
}
// ANCHOR_END: all_pairs
