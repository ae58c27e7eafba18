//! The report's Table 1 again: bouncing balls, 600 steps, without a window. Frame rates (`rates.rs`)
//! beside the report's own, and escapes, overlaps and energy gained, which a rate doesn't tell.

use std::fmt::Write as _;

use ch00_scenes::measures::{Conserved, Measures, Reference, escaped};
use ch00_scenes::{Scene, State, builtin};

use crate::FindingsError;
use crate::lab::{self, Moment, worst};
use crate::product::{Product, Say};
use crate::rates::{self, Rates, Reported, reported};
use crate::table::{Table, millimetres, percent, three_digits};

/// Numbers of balls.
pub const COUNTS: [u64; 10] = [0, 10, 20, 30, 40, 50, 60, 100, 1000, 10_000];
/// A number of balls that takes long: more are run once, with the first seed, and all from here on are
/// left out where it must be quick.
const LONG: u64 = 1000;
/// Runs of the first seed that are timed, up to [`LONG`].
const RUNS: usize = 5;
/// Seeds of the balls; times are those of the first.
const SEEDS: [u64; 3] = [1, 2, 3];
/// Steps of a run.
const STEPS: u32 = 600;

/// What was measured of a number of balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Times of the runs with the first seed.
    pub rates: Rates,
    /// Most balls that were outside the box after any step: the worst seed.
    pub escaped: usize,
    /// Deepest overlap after the last step, m: the worst seed.
    pub deepest_m: f64,
    /// 99 of 100 overlaps are no deeper, m: the worst seed.
    pub p99_m: f64,
    /// Energy above the start's, relative, the largest of the run: the worst seed.
    pub energy_gained: f64,
    /// Things that a limit left undone: the worst seed.
    pub overflow: usize,
}

/// Measures, and lays out picture, CSV and page.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn product(quick: bool, say: Say) -> Result<Product, FindingsError> {
    let counts = COUNTS.into_iter().filter(|&count| !quick || count < LONG);
    let mut rows = Vec::new();
    for count in counts {
        let row = measured(count, STEPS)?;
        let median = three_digits(row.rates.median_ms());
        say(&format!("{count} balls: {median} ms a step"));
        rows.push(row);
    }
    let reported = reported(1)?;
    let title = "Bouncing balls: time of a frame, slowest and fastest mean of ten";
    let all = rows.iter().map(|row| &row.rates);
    Ok(Product {
        charts: vec![rates::chart("table1", title, "balls", &all, &reported).into()],
        csv: csv(&rows, &reported),
        page: Some(page(&rows, &reported)),
    })
}

/// Runs balls with every seed, the first one several times; a large number of them once.
///
/// # Errors
/// [`FindingsError`] where the scene can't be loaded.
pub fn measured(count: u64, steps: u32) -> Result<Row, FindingsError> {
    let mut row = Row {
        rates: Rates::of(count),
        escaped: 0,
        deepest_m: 0.0,
        p99_m: 0.0,
        energy_gained: 0.0,
        overflow: 0,
    };
    let (seeds, runs) = if count > LONG {
        (&SEEDS[..1], 1)
    } else {
        (&SEEDS[..], RUNS)
    };
    for &seed in seeds {
        let mut scene: Scene = builtin::build("balls", Some(count), Some(seed))?;
        scene.steps = steps;
        let times = row.watch(&scene)?;
        if seed == SEEDS[0] {
            row.rates.add(&times);
            for _ in 1..runs {
                let times = lab::run(&scene, &lab::by("corrected"), |_| ())?;
                row.rates.add(&times);
            }
        }
    }
    Ok(row)
}

impl Row {
    /// Makes a run, whose physics counts; gives the times of its steps.
    fn watch(&mut self, scene: &Scene) -> Result<Vec<std::time::Duration>, FindingsError> {
        let start = Reference::of(scene);
        let mut last = State::default();
        let times = lab::run(scene, &lab::by("corrected"), |now: &Moment| {
            let out = escaped(scene, now.state).unwrap_or(0) + now.state.not_finite();
            self.escaped = self.escaped.max(out);
            let gained = start.energy_error(&Conserved::of(scene, now.state));
            self.energy_gained = worst([self.energy_gained].into_iter().chain(gained));
            if now.step == scene.steps {
                last.clone_from(now.state);
                self.overflow = self.overflow.max(now.engine.counters().overflow);
            }
        })?;
        let overlaps = Measures::of(scene, &last).penetration;
        self.deepest_m = worst([self.deepest_m, overlaps.deepest]);
        self.p99_m = worst([self.p99_m, overlaps.p99]);
        Ok(times)
    }
}

fn csv(rows: &[Row], reported: &[Reported]) -> String {
    let fields = rates::CSV_FIELDS;
    let mut text = format!("balls,{fields},escaped,deepest_m,p99_depth_m,energy_gained,overflow\n");
    for row in rows {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{:?},{:?},{:?},{}",
            row.rates.csv(reported),
            row.escaped,
            row.deepest_m,
            row.p99_m,
            row.energy_gained,
            row.overflow,
        );
    }
    text
}

/// The table with a line on how it was measured.
fn page(rows: &[Row], reported: &[Reported]) -> String {
    let mut headings = vec!["balls"];
    headings.extend(rates::HEADINGS);
    headings.extend(["escaped", "overlap, deepest / 99 % (mm)", "energy gained"]);
    let mut table = Table::new(&headings);
    for row in rows {
        let mut cells = row.rates.cells(reported);
        cells.extend([
            row.escaped.to_string(),
            format!(
                "{} / {}",
                millimetres(row.deepest_m),
                millimetres(row.p99_m)
            ),
            percent(row.energy_gained),
        ]);
        table.push(cells);
    }
    let long = crate::draw::grouped(&LONG.to_string());
    format!(
        "{how} Escaped: the most balls outside the box after any step. Overlap: after the last step. \
         Energy gained: the most above the start's during the run. Of these the worst of the seeds 1, 2, 3 \
         (above {long} balls seed 1 alone).\n\n{table}",
        how = rates::how(
            STEPS,
            &format!("{RUNS} runs (above {long} balls there is one)")
        ),
        table = table.markdown(0),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_run_of_ten_balls_fills_a_row() {
        let row = measured(10, 30).expect("ten balls load");
        assert_eq!(row.rates.range().0, RUNS);
        let (max, min) = (row.rates.max_fps(), row.rates.min_fps());
        assert!(max >= min && min > 0.0, "{row:?}");
        assert!(row.rates.worst_ms() >= row.rates.p99_ms(), "{row:?}");
        assert!(row.rates.p99_ms() >= row.rates.median_ms(), "{row:?}");
        assert_eq!((row.escaped, row.overflow), (0, 0));
        let page = page(&[row], &reported(1).expect("it is there"));
        assert!(page.contains(" 59.17 / 56.17 |"), "{page}");
    }
}
