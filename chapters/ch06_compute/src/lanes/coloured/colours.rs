//! Colours: two pairs of one colour share no body that moves.

/// How many colours there are; a body with more contacts leaves some of them without.
pub const MOST_COLOURS: usize = 64;

/// The colours of the pairs of a step.
#[derive(Clone, Debug, Default)]
pub struct Colours {
    /// By pair: its colour; that of those which found none is the last.
    of: Vec<u8>,
    /// By pair: which of its bodies move.
    moves: Vec<[bool; 2]>,
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
    pub fn at(&self, pair: usize) -> (u8, [bool; 2]) {
        let colour = self.of.get(pair).copied().unwrap_or_default();
        (colour, self.moves.get(pair).copied().unwrap_or_default())
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.of.clear();
        self.moves.clear();
        (self.count, self.without) = (0, 0);
    }

    /// Gives every pair the first colour that none of its bodies has yet, in the order of the pairs: first
    /// those of two bodies that move, then those with one that doesn't. So what stands fast has the last word
    /// in a sweep. A body that doesn't move takes no colour.
    pub fn paint(
        &mut self,
        pairs: &[(usize, usize)],
        bodies: usize,
        moves: impl Fn(usize) -> bool,
    ) {
        self.clear();
        self.used.clear();
        self.used.resize(bodies, 0);
        let moving = |&(a, b): &(usize, usize)| [moves(a), moves(b)];
        self.moves.extend(pairs.iter().map(moving));
        self.of.resize(pairs.len(), 0);
        self.paint_those(pairs, 0, |moves| moves == [true, true]);
        let first = self.count.min(MOST_COLOURS - 1);
        self.paint_those(pairs, first, |moves| moves != [true, true]);
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
        pairs: &[(usize, usize)],
        first: usize,
        chosen: impl Fn([bool; 2]) -> bool,
    ) {
        for (pair, &(a, b)) in pairs.iter().enumerate() {
            let moves = self.moves[pair];
            if !chosen(moves) {
                continue;
            }
            let of = |row: usize, moves: bool| if moves { self.used[row] } else { 0 };
            let used = of(a, moves[0]) | of(b, moves[1]) | ((1 << first) - 1);
            let colour = used.trailing_ones() as usize;
            if colour == MOST_COLOURS {
                self.of[pair] = NONE;
                self.without += 1;
                continue;
            }
            self.of[pair] = colour as u8;
            self.used[a] |= 1 << colour;
            self.used[b] |= 1 << colour;
            self.count = self.count.max(colour + 1);
        }
    }
    // ANCHOR_END: paint
}

/// No colour.
const NONE: u8 = u8::MAX;
