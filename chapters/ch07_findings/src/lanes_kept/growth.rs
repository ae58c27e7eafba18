//! How the time of a step grows with the number of bodies, and what a second thread brings: drawn from a table that
//! is kept in the book, as times on a machine that does other work, too, are no use beside each other.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_lanes_growth.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example pile -- \
              --engine lanes --method NAME --substeps N --counts N,N,… --settle N --steps N --threads 1,2 --turns 9 --csv FILE",
};

/// A heap that is stepped by so many threads.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    run: Run,
    balls: f64,
    threads: u32,
    /// A step, ms.
    ms: f64,
}

/// By what it is stepped, and from when it is timed.
#[derive(Clone, Debug, PartialEq)]
struct Run {
    method: String,
    substeps: u32,
    settled: u32,
    device: String,
}

/// Lays out picture, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    SOURCE.drawn(say, drawn)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let samples = kept.samples(Sample::of)?;
    Ok(Product {
        charts: vec![chart(&samples).into()],
        csv: csv(&samples),
        page: Some(page(&samples, &kept.origin())),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        line.one_of("scene", &["pile"])?;
        line.one_of("engine", &["lanes"])?;
        Ok(Self {
            run: Run {
                method: line.text("method")?.to_owned(),
                substeps: line.number("substeps")?,
                settled: line.number("settle_steps")?,
                device: line.text("device")?.to_owned(),
            },
            balls: line.positive("count")?,
            threads: line.number("threads")?,
            ms: line.positive("ms_median")?,
        })
    }
}

impl Run {
    fn name(&self) -> String {
        format!(
            "{}, {} substeps, from step {}",
            self.method, self.substeps, self.settled
        )
    }

    /// The time of a step of so many balls on so many threads, ms.
    fn ms(&self, samples: &[Sample], balls: f64, threads: u32) -> Option<f64> {
        let same = |s: &&Sample| s.run == *self && s.balls == balls && s.threads == threads;
        samples.iter().find(same).map(|sample| sample.ms)
    }

    /// The k of the Nᵏ with which a step on so many threads grows from the smallest heap to one of so many balls.
    fn growth(&self, samples: &[Sample], balls: f64, threads: u32) -> Option<f64> {
        let smallest = self.counts(samples).first().copied()?;
        let more = balls / smallest;
        let longer = self.ms(samples, balls, threads)? / self.ms(samples, smallest, threads)?;
        (more > 1.0).then(|| longer.ln() / more.ln())
    }

    /// How many balls its heaps have, the fewest first.
    fn counts(&self, samples: &[Sample]) -> Vec<f64> {
        let own = samples.iter().filter(|sample| sample.run == *self);
        let mut counts: Vec<f64> = own.map(|sample| sample.balls).collect();
        counts.sort_by(f64::total_cmp);
        counts.dedup();
        counts
    }
}

/// All runs, in the order of the table.
fn runs(samples: &[Sample]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for sample in samples {
        if !runs.contains(&sample.run) {
            runs.push(sample.run.clone());
        }
    }
    runs
}

fn chart(samples: &[Sample]) -> Chart {
    let mut series = Vec::new();
    for run in runs(samples) {
        for (threads, word) in [(1, "one thread"), (2, "two threads")] {
            let point = |balls| Some((balls, 1e3 * run.ms(samples, balls, threads)? / balls));
            let points: Vec<_> = run.counts(samples).into_iter().filter_map(point).collect();
            if !points.is_empty() {
                let name = format!("{}: {word}", run.name());
                series.push(Series::new(&name, Style::Other(series.len()), points));
            }
        }
    }
    Chart {
        name: "lanes_growth",
        title: "Time of a step for each ball".to_owned(),
        x: Axis::log("balls"),
        y: Axis::log("time for each ball (µs)"),
        series,
    }
}

fn csv(samples: &[Sample]) -> String {
    let mut text = "method,substeps,from step,balls,threads,step (ms)\n".to_owned();
    for Sample {
        run,
        balls,
        threads,
        ms,
    } in samples
    {
        let (method, substeps, settled) = (&run.method, run.substeps, run.settled);
        let _ = writeln!(text, "{method},{substeps},{settled},{balls},{threads},{ms}");
    }
    text
}

fn page(samples: &[Sample], origin: &str) -> String {
    let mut table = Table::new(&[
        "method",
        "balls",
        "one thread, ms",
        "two threads, ms",
        "ratio",
        "growth on one",
        "on two",
    ]);
    for run in runs(samples) {
        for balls in run.counts(samples) {
            let times = [1, 2].map(|threads| run.ms(samples, balls, threads));
            let shown = |number: Option<f64>| number.map(three_digits).unwrap_or_default();
            let ratio = times[0].zip(times[1]).map(|(one, two)| one / two);
            let growth = [1, 2].map(|threads| run.growth(samples, balls, threads));
            let [growth, on_two] = growth.map(|growth| growth.map(|k| format!("N^{k:.2}")));
            table.push(vec![
                run.name(),
                draw::grouped(&balls.to_string()),
                shown(times[0]),
                shown(times[1]),
                shown(ratio),
                growth.unwrap_or_default(),
                on_two.unwrap_or_default(),
            ]);
        }
    }
    let device = samples.first().map_or("", |s| s.run.device.as_str());
    format!("{}\n{device}; {origin}.\n", table.markdown(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "scene,count,engine,method,device,threads,substeps,settle_steps,ms_median\n\
        pile,1000,lanes,coloured,cpu,1,3,150,1.0\n\
        pile,10000,lanes,coloured,cpu,1,3,150,10.0\n\
        pile,100000,lanes,coloured,cpu,1,3,150,1000.0\n\
        pile,10000,lanes,coloured,cpu,2,3,150,5.0\n";

    #[test]
    fn growth_is_the_power_of_the_number_and_the_ratio_is_of_one_thread_to_two() {
        let kept = SOURCE.parse("here.csv".into(), TABLE).expect("a table");
        let samples = kept.samples(Sample::of);
        let samples = samples.expect("it can be read");
        let run = &samples[0].run;
        assert_eq!(run.growth(&samples, 1e3, 1), None);
        assert!((run.growth(&samples, 1e4, 1).expect("two sizes") - 1.0).abs() < 1e-12);
        assert!((run.growth(&samples, 1e5, 1).expect("two sizes") - 1.5).abs() < 1e-12);
        let page = page(&samples, "here");
        assert!(page.contains("N^1.50") && page.contains("2.00"), "{page}");
    }
}
