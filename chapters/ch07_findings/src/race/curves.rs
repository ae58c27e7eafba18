//! What was measured of a contender, for the plots.

/// What was measured after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Simulated time, s.
    pub time: f64,
    /// Mean time of a step in the last second, ms.
    pub ms: Option<f64>,
    /// Energy gained since the start, relative; none where the scene feeds energy in.
    pub energy_error: Option<f64>,
    /// Deepest overlap, m; none where it isn't known for all pairs.
    pub deepest: Option<f64>,
    /// 99 of 100 overlapping pairs overlap by no more than this, m.
    pub p99: Option<f64>,
    /// Widest gap of a joint, m; none without joints.
    pub joint: Option<f64>,
}

/// Samples of a run, oldest first: when there are too many every second one goes, so that a long run
/// still shows its start.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    samples: Vec<Sample>,
    /// Of so many samples one is kept.
    every: usize,
    skipped: usize,
    last: Option<Sample>,
}

/// As many are kept at most.
const MOST: usize = 400;

impl Curve {
    /// Adds a sample.
    pub fn push(&mut self, sample: Sample) {
        self.last = Some(sample);
        self.skipped += 1;
        if self.skipped < self.every {
            return;
        }
        self.skipped = 0;
        self.samples.push(sample);
        if self.samples.len() > MOST {
            let mut keeps = false;
            self.samples.retain(|_| {
                keeps = !keeps;
                keeps
            });
            self.every = 2 * self.every.max(1);
        }
    }

    /// What was measured last.
    pub fn last(&self) -> Option<&Sample> {
        self.last.as_ref()
    }

    /// One of the measures against time, where it is known.
    pub fn points(&self, measure: impl Fn(&Sample) -> Option<f64>) -> Vec<[f64; 2]> {
        let samples = self.samples.iter().chain(&self.last);
        let known = samples.filter_map(|sample| Some([sample.time, measure(sample)?]));
        known.filter(|[_, y]| y.is_finite()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(time: f64) -> Sample {
        Sample {
            time,
            ms: Some(1.0),
            energy_error: Some(f64::NAN),
            deepest: None,
            p99: None,
            joint: None,
        }
    }

    #[test]
    fn a_long_run_keeps_its_start_and_its_end_and_not_too_many_samples() {
        let mut curve = Curve::default();
        for i in 0..10_000 {
            curve.push(sample(f64::from(i)));
        }
        let points = curve.points(|sample| sample.ms);
        assert!(points.len() <= MOST + 1 && points.len() > MOST / 2);
        assert_eq!((points[0][0], points[points.len() - 1][0]), (0.0, 9999.0));
        assert!(points.is_sorted_by(|one, two| one[0] <= two[0]));
    }

    #[test]
    fn what_is_no_number_is_not_drawn() {
        let mut curve = Curve::default();
        curve.push(sample(0.0));
        assert!(curve.points(|sample| sample.energy_error).is_empty());
        assert!(curve.points(|sample| sample.joint).is_empty());
    }
}
