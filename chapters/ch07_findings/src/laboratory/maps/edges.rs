//! Where a map's edge lies, and where theory says that it lies.

use super::{Map, Place, Who};
use crate::chart::{Class, Scale};
use crate::lab::median;

/// A column of a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Where it stands.
    pub x: f64,
    /// The last good cell from the good end on, if any is.
    pub good: Option<f64>,
    /// The first one that isn't good, if any isn't.
    pub bad: Option<f64>,
    /// What theory says.
    pub law: f64,
}

/// A panel's edge beside theory's.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// In the order of x.
    pub columns: Vec<Column>,
    /// Whether cells get better upwards.
    better_upwards: bool,
    /// Whether between two cells the middle is that of their logarithms.
    log: bool,
}

impl Edge {
    /// Where a panel's cells turn bad, beside its first law; None where it has none.
    #[must_use]
    pub fn of(map: &Map, who: &Who, places: &[Place]) -> Option<Self> {
        let mut laws = who.laws.iter();
        let (law, until) = laws.find_map(|law| Some((&law.y, law.until?)))?;
        let mut cells: Vec<([f64; 2], Class)> = map
            .places(who, places)
            .filter_map(|place| Some((place.at, map.class(place)?)))
            .collect();
        let sign = if map.better_upwards { -1.0 } else { 1.0 };
        // Each column begins at its good end.
        cells.sort_by(|(a, _), (b, _)| {
            (a[0].total_cmp(&b[0])).then((sign * a[1]).total_cmp(&(sign * b[1])))
        });
        let columns = cells.chunk_by(|a, b| a.0[0] == b.0[0]);
        let columns = columns.map(|column| {
            let is_good = |cell: &&([f64; 2], Class)| cell.1 <= until;
            let good = column.iter().take_while(is_good).last();
            let bad = column.iter().find(|cell| !is_good(cell));
            let x = column[0].0[0];
            Column {
                x,
                good: good.map(|cell| cell.0[1]),
                bad: bad.map(|cell| cell.0[1]),
                law: law(x),
            }
        });
        Some(Self {
            columns: columns.collect(),
            better_upwards: map.better_upwards,
            log: (map.axes)()[1].scale == Scale::Log,
        })
    }

    /// Whether theory's edge is where the measured one is: between the last good cell and the first bad one;
    /// beyond the last cell, where none is bad, or none good.
    #[must_use]
    pub fn agrees(&self, column: &Column) -> bool {
        // How far on the bad side, in either sense of up.
        let worse = |y: f64| if self.better_upwards { -y } else { y };
        let law = worse(column.law);
        let reached = column.good.is_none_or(|good| law >= worse(good));
        reached && column.bad.is_none_or(|bad| law <= worse(bad))
    }

    /// How many columns agree, and of how many.
    #[must_use]
    pub fn agreement(&self) -> (usize, usize) {
        let agreeing = self.columns.iter().filter(|column| self.agrees(column));
        (agreeing.count(), self.columns.len())
    }

    /// The measured edge over theory's, where there are both.
    pub fn ratios(&self) -> impl Iterator<Item = f64> {
        self.columns.iter().filter_map(|column| {
            let (good, bad) = (column.good?, column.bad?);
            let edge = if self.log {
                (good * bad).sqrt()
            } else {
                0.5 * (good + bad)
            };
            let ratio = edge / column.law;
            ratio.is_finite().then_some(ratio)
        })
    }

    /// The median of [`Edge::ratios`], the least and the largest; None where no column has an edge.
    #[must_use]
    pub fn ratio(&self) -> Option<[f64; 3]> {
        let all: Vec<f64> = self.ratios().collect();
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = all.iter().copied().fold(0.0, f64::max);
        (!all.is_empty()).then(|| [median(all), least, largest])
    }

    /// How many columns are good, and bad, from end to end.
    #[must_use]
    pub fn whole(&self) -> [usize; 2] {
        let good = self.columns.iter().filter(|column| column.bad.is_none());
        let bad = self.columns.iter().filter(|column| column.good.is_none());
        [good.count(), bad.count()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(better_upwards: bool, columns: &[(Option<f64>, Option<f64>, f64)]) -> Edge {
        let column = |&(good, bad, law)| Column {
            x: 1.0,
            good,
            bad,
            law,
        };
        Edge {
            columns: columns.iter().map(column).collect(),
            better_upwards,
            log: true,
        }
    }

    #[test]
    fn theory_agrees_between_the_last_good_cell_and_the_first_bad_one() {
        let (good, bad) = (Some(8.0), Some(4.0));
        let up = edge(
            true,
            &[(good, bad, 5.0), (good, bad, 9.0), (good, bad, 3.0)],
        );
        assert_eq!(up.agreement(), (1, 3));
        let down = edge(false, &[(bad, good, 5.0), (bad, good, 9.0)]);
        assert_eq!(down.agreement(), (1, 2));
        let ratio: Vec<f64> = up.ratios().collect();
        assert!((ratio[0] - 32f64.sqrt() / 5.0).abs() < 1e-12);
    }

    #[test]
    fn where_all_cells_are_good_theory_must_lie_beyond_the_last() {
        let up = edge(true, &[(Some(2.0), None, 1.0), (Some(2.0), None, 3.0)]);
        assert_eq!(up.agreement(), (1, 2));
        let none = edge(true, &[(None, Some(64.0), 99.0), (None, Some(64.0), 9.0)]);
        assert_eq!(none.agreement(), (1, 2));
        assert_eq!((up.whole(), none.whole()), ([2, 0], [0, 2]));
        assert_eq!(none.ratio(), None);
    }
}
