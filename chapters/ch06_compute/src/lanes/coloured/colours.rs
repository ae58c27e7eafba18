//! Colours: two pairs of one colour share no body that moves.

/// How many colours there are; a body with more contacts leaves some of them without.
pub const MOST_COLOURS: usize = 64;

/// In the place of a row: that body doesn't move, or is in another region.
pub const STILL: u32 = u32::MAX;

/// The colours of some pairs.
#[derive(Clone, Debug, Default)]
pub struct Colours {
    /// By pair: its colour; that of those which found none is the last.
    of: Vec<u8>,
    /// How many colours have pairs.
    count: usize,
    /// How many pairs found none.
    without: usize,
    /// By body: a bit a colour, whether one of its pairs has it.
    used: Vec<u64>,
}

impl Colours {
    /// How many colours have pairs, those without one counted as one more; at least one.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count.max(1)
    }

    /// What stands for the colour of those which found none, if there are such.
    #[must_use]
    pub fn alone(&self) -> Option<usize> {
        (self.without > 0).then(|| self.count - 1)
    }

    /// How many pairs found no colour.
    #[must_use]
    pub fn without(&self) -> usize {
        self.without
    }

    /// The colour of a pair, and which of its bodies move.
    #[must_use]
    pub fn at(&self, pair: usize, ends: &[[u32; 2]]) -> (u8, [bool; 2]) {
        let colour = self.of.get(pair).copied().unwrap_or_default();
        (colour, ends[pair].map(|row| row != STILL))
    }

    /// Gives every pair the first colour that none of its bodies has yet, in the order of the pairs: first
    /// those of two bodies that move, then those with one that doesn't. So what stands fast has the last word
    /// in a sweep. A body that doesn't move takes no colour.
    pub fn paint(&mut self, pairs: &[[u32; 2]], bodies: usize) {
        (self.count, self.without) = (0, 0);
        self.used.clear();
        self.used.resize(bodies, 0);
        self.of.clear();
        self.of.resize(pairs.len(), 0);
        let two_move = |&[a, b]: &[u32; 2]| a != STILL && b != STILL;
        self.paint_those(pairs, 0, two_move);
        let first = self.count.min(MOST_COLOURS - 1);
        self.paint_those(pairs, first, |pair| !two_move(pair));
        if self.without > 0 {
            self.count += 1;
            let last = (self.count - 1) as u8;
            for colour in self.of.iter_mut().filter(|colour| **colour == NONE) {
                *colour = last;
            }
        }
    }

    // ANCHOR: paint
    /// Gives each of the pairs that are chosen the first colour, from `first` on, that neither body has.
    fn paint_those(
        &mut self,
        pairs: &[[u32; 2]],
        first: usize,
        chosen: impl Fn(&[u32; 2]) -> bool,
    ) {
        let those = pairs.iter().enumerate().filter(|(_, pair)| chosen(pair));
        for (pair, rows) in those {
            let of = |row: u32| self.used.get(row as usize).copied().unwrap_or(0);
            let used = of(rows[0]) | of(rows[1]) | ((1 << first) - 1);
            let colour = used.trailing_ones() as usize;
            if colour == MOST_COLOURS {
                self.of[pair] = NONE;
                self.without += 1;
                continue;
            }
            self.of[pair] = colour as u8;
            self.count = self.count.max(colour + 1);
            for row in rows {
                if let Some(used) = self.used.get_mut(*row as usize) {
                    *used |= 1 << colour;
                }
            }
        }
    }
    // ANCHOR_END: paint
}

/// No colour.
const NONE: u8 = u8::MAX;
