//! What holds bodies together besides contacts. This chapter has none; chapter 4's joints are.

use super::Span;

// ANCHOR: links
/// Constraints that are resolved together with the contacts, in the same sweeps.
pub trait Links {
    /// Calls `visit` with the index of every body that they hold.
    fn each_body(&self, visit: impl FnMut(usize));

    /// Works out what stays the same while a step is resolved.
    fn prepare(&mut self, span: Span);

    /// Nudges the bodies to where they belong; gives how far the furthest was off, m.
    fn part(&mut self) -> f32;

    /// Begins with the impulses of the last step.
    fn resume(&mut self);

    /// Mends the impulses once; says whether a relative velocity was off by more than `still`, m/s.
    fn hold(&mut self, still: f32) -> bool;

    /// Notes how far the bodies, now in their places, are from where they belong.
    fn finish(&mut self);
}
// ANCHOR_END: links

/// No links.
pub struct NoLinks;

impl Links for NoLinks {
    fn each_body(&self, _visit: impl FnMut(usize)) {}

    fn prepare(&mut self, _span: Span) {}

    fn part(&mut self) -> f32 {
        0.0
    }

    fn resume(&mut self) {}

    fn hold(&mut self, _still: f32) -> bool {
        false
    }

    fn finish(&mut self) {}
}
