//! What bodies have gathered, wherever it lies.

use super::coloured::Live;
use crate::own_row::body::Gathered;

/// What bodies have gathered, as passes over bodies read it.
#[derive(Clone, Copy, Debug)]
pub struct Sums<'s> {
    gathered: &'s [Gathered],
    /// By row: where its sum is, if sums don't lie in the order of rows.
    spots: Option<&'s [u32]>,
    /// Where bodies are pushed by what moves them pair after pair, and not by impulses that they sum.
    live: Option<&'s Live>,
}

impl<'s> Sums<'s> {
    /// In the order of rows.
    #[must_use]
    pub fn of(gathered: &'s [Gathered]) -> Self {
        Self {
            gathered,
            spots: None,
            live: None,
        }
    }

    /// In another order: where each row's is.
    #[must_use]
    pub fn at(gathered: &'s [Gathered], spots: &'s [u32]) -> Self {
        Self {
            gathered,
            spots: Some(spots),
            live: None,
        }
    }

    /// Those of bodies that colours have moved, in the order of rows.
    #[must_use]
    pub fn live(gathered: &'s [Gathered], live: &'s Live) -> Self {
        Self {
            gathered,
            spots: None,
            live: Some(live),
        }
    }

    /// That of a row.
    #[inline]
    #[must_use]
    pub fn row(&self, row: usize) -> &'s Gathered {
        match self.spots {
            Some(spots) => &self.gathered[spots[row] as usize],
            None => &self.gathered[row],
        }
    }

    /// Whom colours have pushed.
    #[inline]
    #[must_use]
    pub fn pushed(&self) -> Option<&'s Live> {
        self.live
    }
}
