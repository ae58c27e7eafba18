//! A cell of the table: one scenario, one contender, one rate; its error and its cost, or how it failed. It is
//! a line of CSV.

use std::str::FromStr;

use super::store::Kept;

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// With an error that means something.
    Measured,
    /// In a way that has a name: fell, lost, NaN.
    Failed(String),
    /// It was never begun: what the method doesn't model.
    Cannot(String),
}

/// What was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the contender.
    pub contender: String,
    /// Steps a second.
    pub rate: u32,
    /// Parts of a step.
    pub substeps: u32,
    /// Sweeps of a part; 0 where there are none.
    pub sweeps: u32,
    /// In the scenario's unit.
    pub error: f64,
    /// Processor time for a second of the scene, s: of repeated runs the median.
    pub cost: f64,
    /// How many runs were timed.
    pub runs: u32,
    /// How it ended.
    pub end: End,
}

/// The first line of the file.
pub const HEADINGS: &str =
    "scenario,contender,rate (1/s),substeps,sweeps,error,CPU time (s/s),runs,end";

impl End {
    /// As a line says it.
    #[must_use]
    pub fn line(&self) -> String {
        match self {
            End::Measured => "measured".to_owned(),
            End::Failed(how) => format!("failed: {how}"),
            End::Cannot(why) => format!("cannot: {}", why.replace(',', ";").replace('\n', " ")),
        }
    }

    /// What a line says.
    #[must_use]
    pub fn of(text: &str) -> Option<Self> {
        match text.split_once(": ") {
            None if text == "measured" => Some(End::Measured),
            Some(("failed", how)) => Some(End::Failed(how.to_owned())),
            Some(("cannot", why)) => Some(End::Cannot(why.to_owned())),
            _ => None,
        }
    }
}

impl Kept for Cell {
    const HEADINGS: &'static str = HEADINGS;

    fn line(&self) -> String {
        self.line()
    }

    fn read(line: &str) -> Option<Self> {
        line.parse().ok()
    }
}

impl Cell {
    /// A line without its end.
    #[must_use]
    pub fn line(&self) -> String {
        format!(
            "{},{},{},{},{},{:e},{:e},{},{}",
            self.scenario,
            self.contender,
            self.rate,
            self.substeps,
            self.sweeps,
            self.error,
            self.cost,
            self.runs,
            self.end.line()
        )
    }

    /// What tells it from all others.
    #[must_use]
    pub fn key(&self) -> (&str, &str, u32) {
        (&self.scenario, &self.contender, self.rate)
    }

    /// Whether the error is one.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        self.end == End::Measured
    }

    /// The error for a chart: infinite where it failed.
    #[must_use]
    pub fn drawn(&self) -> f64 {
        if self.is_measured() {
            self.error
        } else {
            f64::INFINITY
        }
    }
}

/// A line that is no cell: cut off, or not ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoCell;

impl FromStr for Cell {
    type Err = NoCell;

    fn from_str(line: &str) -> Result<Self, NoCell> {
        let mut fields = line.split(',');
        let mut next = || fields.next().ok_or(NoCell);
        let number = |text: &str| text.parse::<u32>().map_err(|_| NoCell);
        let real = |text: &str| text.parse::<f64>().map_err(|_| NoCell);
        let cell = Self {
            scenario: next()?.to_owned(),
            contender: next()?.to_owned(),
            rate: number(next()?)?,
            substeps: number(next()?)?,
            sweeps: number(next()?)?,
            error: real(next()?)?,
            cost: real(next()?)?,
            runs: number(next()?)?,
            end: End::of(next()?).ok_or(NoCell)?,
        };
        if fields.next().is_some() {
            return Err(NoCell);
        }
        Ok(cell)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(end: End) -> Cell {
        Cell {
            scenario: "free_top".to_owned(),
            contender: "own-row".to_owned(),
            rate: 60,
            substeps: 10,
            sweeps: 0,
            error: 3.1e-4,
            cost: 1.5e-5,
            runs: 5,
            end,
        }
    }

    #[test]
    fn what_is_written_is_read_again() {
        for end in [
            End::Measured,
            End::Failed("fell".to_owned()),
            End::Cannot("it has no joints".to_owned()),
        ] {
            let cell = cell(end);
            assert_eq!(cell.line().parse(), Ok(cell));
        }
    }

    #[test]
    fn a_line_that_was_cut_off_is_no_cell() {
        let line = cell(End::Measured).line();
        for length in 0..line.len() {
            assert_eq!(line[..length].parse::<Cell>(), Err(NoCell), "{length}");
        }
        assert_eq!(format!("{line},more").parse::<Cell>(), Err(NoCell));
    }

    #[test]
    fn reasons_with_commas_stay_one_field() {
        let why = "no joints, no contacts\nat all".to_owned();
        let read: Cell = cell(End::Cannot(why)).line().parse().expect("a cell");
        assert_eq!(
            read.end,
            End::Cannot("no joints; no contacts at all".to_owned())
        );
    }
}
