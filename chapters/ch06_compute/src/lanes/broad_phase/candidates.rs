//! Pairs in order without comparing pairs: each is put to its smaller row by counting, and only the few
//! partners of one row are sorted.

use std::ops::Range;

use rayon::prelude::*;

use super::Bound;

/// Rows that one thread takes at a time.
const CHUNK: usize = 1024;

/// Pairs whose boxes with room overlap: for each row, its partners with larger rows, in order.
#[derive(Clone, Debug, Default)]
pub struct Candidates {
    /// By row: where its partners begin; one more at the end.
    starts: Vec<u32>,
    partners: Vec<u32>,
    /// Each thread's share of the pairs.
    shares: Vec<Vec<(usize, usize)>>,
}

impl Candidates {
    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.partners.len()
    }

    // ANCHOR: take
    /// Takes what was found, the smaller row first in each, in any order.
    pub fn take(&mut self, found: &[Vec<[u32; 2]>], rows: usize, ignored: &[(usize, usize)]) {
        self.starts.clear();
        self.starts.resize(rows + 2, 0);
        // One place further on, so that after the pairs have taken their places each start is right.
        for &[a, _] in found.iter().flatten() {
            self.starts[a as usize + 2] += 1;
        }
        for row in 2..rows + 2 {
            self.starts[row] += self.starts[row - 1];
        }
        self.partners.clear();
        self.partners.resize(self.starts[rows + 1] as usize, 0);
        for &[a, b] in found.iter().flatten() {
            let next = &mut self.starts[a as usize + 1];
            self.partners[*next as usize] = b;
            *next += 1;
        }
        for row in 0..rows {
            let own = self.starts[row] as usize..self.starts[row + 1] as usize;
            self.partners[own].sort_unstable();
        }
        self.starts.truncate(rows + 1);
        self.leave_out(ignored);
    }
    // ANCHOR_END: take

    /// Removes pairs that pass through each other; `ignored` is in order.
    fn leave_out(&mut self, ignored: &[(usize, usize)]) {
        if ignored.is_empty() {
            return;
        }
        let (mut kept, mut first) = (0, 0);
        let mut at = 0;
        for row in 0..self.starts.len() - 1 {
            let end = self.starts[row + 1];
            for k in first..end {
                let pair = (row, self.partners[k as usize] as usize);
                while at < ignored.len() && ignored[at] < pair {
                    at += 1;
                }
                if ignored.get(at) != Some(&pair) {
                    self.partners[kept as usize] = pair.1 as u32;
                    kept += 1;
                }
            }
            first = end;
            self.starts[row + 1] = kept;
        }
        self.partners.truncate(kept as usize);
    }

    // ANCHOR: still
    /// The candidates, and those of `added`, that may touch in this step, in order.
    pub fn still(
        &mut self,
        bounds: &[Bound],
        added: &[[u32; 2]],
        threads: bool,
        pairs: &mut Vec<(usize, usize)>,
    ) {
        pairs.clear();
        if !threads {
            self.still_in(0..bounds.len(), bounds, added, pairs);
            return;
        }
        let mut shares = std::mem::take(&mut self.shares);
        shares.resize_with(bounds.len().div_ceil(CHUNK), Vec::new);
        shares.par_iter_mut().enumerate().for_each(|(k, share)| {
            share.clear();
            let end = bounds.len().min((k + 1) * CHUNK);
            self.still_in(k * CHUNK..end, bounds, added, share);
        });
        for share in &shares {
            pairs.extend_from_slice(share);
        }
        self.shares = shares;
    }

    /// Those of some rows.
    fn still_in(
        &self,
        rows: Range<usize>,
        bounds: &[Bound],
        added: &[[u32; 2]],
        pairs: &mut Vec<(usize, usize)>,
    ) {
        let mut next = added.partition_point(|pair| (pair[0] as usize) < rows.start);
        for row in rows {
            let own = &self.partners[self.starts[row] as usize..self.starts[row + 1] as usize];
            let (bound, first) = (bounds[row], pairs.len());
            for &other in own {
                if bound.overlaps(&bounds[other as usize]) {
                    pairs.push((row, other as usize));
                }
            }
            let known = pairs.len();
            while next < added.len() && added[next][0] as usize == row {
                let other = added[next][1];
                if bound.overlaps(&bounds[other as usize]) && own.binary_search(&other).is_err() {
                    pairs.push((row, other as usize));
                }
                next += 1;
            }
            if pairs.len() > known {
                pairs[first..].sort_unstable();
            }
        }
    }
    // ANCHOR_END: still
}
