//! The file and the page of the samples.

use std::fmt::Write as _;

use super::sample::{Sample, machines};
use super::{BUDGET_GROWTH, budget, grouped, growth, growth_in_words};
use crate::draw;
use crate::table::{Table, percent, three_digits};

/// The samples as a file.
pub fn csv(samples: &[Sample]) -> String {
    let mut text =
        "engine,method,device,threads,balls,settling_steps,ms_a_step,least_ms,largest_ms,budget_ms,\
        growth_exponent_from_10000,p99_of_r,deepest_of_r,gone\n"
            .to_owned();
    for s in samples {
        let optional =
            |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:?}"));
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{:?},{:?},{:?},{},{},{:?},{:?},{}",
            s.engine,
            s.method,
            draw::quoted(&s.device),
            s.threads,
            s.balls,
            s.settling,
            s.ms[0],
            s.ms[1],
            s.ms[2],
            optional(budget(s)),
            optional(growth(samples, s)),
            s.p99,
            s.deepest,
            s.gone,
        );
    }
    text
}

/// The samples as a page.
pub fn page(samples: &[Sample], origin: &str) -> String {
    let mut table = Table::new(&[
        "engine",
        "method",
        "threads",
        "balls",
        "settled (steps)",
        "ms/step",
        "least … largest",
        "budget",
        "growth from 10,000: N to the",
        "p99 of R",
        "deepest of R",
        "gone",
    ]);
    let none = || "–".to_owned();
    for s in samples {
        table.push(vec![
            s.engine.clone(),
            s.method.clone(),
            s.threads.to_string(),
            grouped(s.balls),
            s.settling.to_string(),
            three_digits(s.ms[0]),
            format!("{} … {}", three_digits(s.ms[1]), three_digits(s.ms[2])),
            budget(s).map_or_else(none, three_digits),
            growth(samples, s).map_or_else(none, |exponent| format!("{exponent:.2}")),
            percent(s.p99),
            percent(s.deepest),
            s.gone.to_string(),
        ]);
    }
    let growth = growth_in_words(samples).map_or_else(String::new, |words| {
        format!(
            " On the GPU a step grows {words}; the budget is a power of {BUDGET_GROWTH} at most."
        )
    });
    format!(
        "A pile of balls (radius 0.1 to 0.3 m, about six layers, steps of 1/60 s) on {machines}; {origin}. \
         ms of a step: of the batches of steps the one in the middle, the fastest and the slowest. Overlaps \
         are relative to the smaller ball's radius R. Gone: balls that left the box, or have numbers that are \
         not finite.{growth}\n\n{table}",
        machines = machines(samples),
        table = table.markdown(3),
    )
}
