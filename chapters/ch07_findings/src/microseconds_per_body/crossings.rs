//! Where one engine becomes cheaper than another.

use super::Sample;

/// A place where two curves cross.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// Cheaper below.
    pub below: String,
    /// Cheaper above.
    pub above: String,
    /// The number of balls, between two that were measured, straight in logarithms.
    pub balls: f64,
    /// What both take there, µs a ball.
    pub micros: f64,
}

/// All crossings of two engines' curves, by the number of balls. Only what passes the gate has a curve, and a
/// crossing counts only where the curves of the least times cross too: a machine that others use shows others.
pub fn crossings(samples: &[Sample]) -> Vec<Crossing> {
    let mut names: Vec<&str> = samples.iter().map(|one| one.name.as_str()).collect();
    names.dedup();
    let mut seen: Vec<&str> = Vec::new();
    for name in names {
        if !seen.contains(&name) {
            seen.push(name);
        }
    }
    let mut found = Vec::new();
    for (k, &one) in seen.iter().enumerate() {
        for &other in &seen[k + 1..] {
            found.extend(between(samples, one, other));
        }
    }
    found.sort_by(|a, b| a.balls.total_cmp(&b.balls));
    found
}

fn between(samples: &[Sample], one: &str, other: &str) -> Vec<Crossing> {
    let at = |name: &str, balls: u64| {
        let same = |s: &&Sample| s.name == name && s.balls == balls && s.passes();
        let found = samples.iter().find(same)?;
        Some([found.micros.median.ln(), found.micros.low.ln()])
    };
    let mut counts: Vec<u64> = samples.iter().map(|s| s.balls).collect();
    counts.sort_unstable();
    counts.dedup();
    let common = counts.iter().filter_map(|&balls| {
        let (a, b) = (at(one, balls)?, at(other, balls)?);
        Some(((balls as f64).ln(), a, b))
    });
    let common: Vec<_> = common.collect();
    let mut found = Vec::new();
    for pair in common.windows(2) {
        let [(n, a, b), (n_next, a_next, b_next)] = [pair[0], pair[1]];
        let crosses = |k: usize| (a[k] - b[k]) * (a_next[k] - b_next[k]) < 0.0;
        if !(crosses(0) && crosses(1)) {
            continue;
        }
        let ([a, _], [b, _], [a_next, _], [b_next, _]) = (a, b, a_next, b_next);
        let (before, after) = (a - b, a_next - b_next);
        let share = before / (before - after);
        let (below, above) = if before < 0.0 {
            (one, other)
        } else {
            (other, one)
        };
        found.push(Crossing {
            below: below.to_owned(),
            above: above.to_owned(),
            balls: (n + share * (n_next - n)).exp(),
            micros: (a + share * (a_next - a)).exp(),
        });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::Spread;

    fn sample(name: &str, balls: u64, micros: f64, p99: f64) -> Sample {
        Sample {
            name: name.to_owned(),
            device: "any".to_owned(),
            kept: false,
            balls,
            micros: Spread {
                median: micros,
                low: micros,
                high: micros,
            },
            p99,
            gone: 0,
        }
    }

    #[test]
    fn two_straight_curves_cross_where_their_formulas_are_equal() {
        // 1000/N and N/10 meet at N = 100, 10 µs.
        let samples = [
            sample("falls", 10, 100.0, 0.01),
            sample("falls", 1000, 1.0, 0.01),
            sample("grows", 10, 1.0, 0.01),
            sample("grows", 1000, 100.0, 0.01),
        ];
        let found = crossings(&samples);
        assert_eq!(found.len(), 1);
        assert_eq!((&*found[0].below, &*found[0].above), ("grows", "falls"));
        assert!((found[0].balls - 100.0).abs() < 1e-9 && (found[0].micros - 10.0).abs() < 1e-9);
    }

    #[test]
    fn what_only_the_medians_cross_is_no_crossing() {
        let mut samples = [
            sample("falls", 10, 100.0, 0.01),
            sample("falls", 1000, 1.0, 0.01),
            sample("grows", 10, 1.0, 0.01),
            sample("grows", 1000, 100.0, 0.01),
        ];
        samples[0].micros.low = 0.5;
        assert_eq!(crossings(&samples), []);
    }

    #[test]
    fn what_does_not_pass_the_gate_crosses_nothing() {
        let samples = [
            sample("falls", 10, 100.0, 0.2),
            sample("falls", 1000, 1.0, 0.01),
            sample("grows", 10, 1.0, 0.01),
            sample("grows", 1000, 100.0, 0.01),
        ];
        assert_eq!(crossings(&samples), []);
    }
}
