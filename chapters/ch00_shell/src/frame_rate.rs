//! Frames per second as the report counts them (Tables 1 and 2): the mean over the last ten
//! frames, and the largest and smallest that this mean has been; and the median and 99th
//! percentile of a frame's time, which a mean hides.

use std::collections::VecDeque;
use std::time::Duration;

/// How many frames the mean is taken over, as in the report.
pub const FRAMES_IN_MEAN: usize = 10;

/// How many of the last frames a window's percentiles are taken over: ten seconds at 60 Hz.
pub const FRAMES_IN_WINDOW: usize = 600;

/// Frame times as they come.
#[derive(Clone, Debug)]
pub struct FrameRate {
    times: VecDeque<Duration>,
    keep: usize,
    mean: Option<f64>,
    max: Option<f64>,
    min: Option<f64>,
}

impl FrameRate {
    /// Percentiles over the last [`FRAMES_IN_WINDOW`] frames, for a window.
    #[must_use]
    pub fn of_window() -> Self {
        Self::keeping(FRAMES_IN_WINDOW)
    }

    /// Percentiles over all frames, for a run of known length.
    #[must_use]
    pub fn of_run() -> Self {
        Self::keeping(usize::MAX)
    }

    fn keeping(keep: usize) -> Self {
        Self {
            times: VecDeque::new(),
            keep,
            mean: None,
            max: None,
            min: None,
        }
    }

    /// Counts a frame that took `time`.
    pub fn record(&mut self, time: Duration) {
        if self.times.len() == self.keep {
            self.times.pop_front();
        }
        self.times.push_back(time);
        if let Some(mean) = self.mean_of_last_ten() {
            self.mean = Some(mean);
            self.max = Some(self.max.map_or(mean, |max| max.max(mean)));
            self.min = Some(self.min.map_or(mean, |min| min.min(mean)));
        }
    }

    /// Mean over the last ten frames, 1/s; `None` before the tenth.
    #[must_use]
    pub fn fps(&self) -> Option<f64> {
        self.mean
    }

    /// The largest ten-frame mean so far, 1/s; `None` before the tenth frame.
    #[must_use]
    pub fn max_fps(&self) -> Option<f64> {
        self.max
    }

    /// The smallest ten-frame mean so far, 1/s; `None` before the tenth frame.
    #[must_use]
    pub fn min_fps(&self) -> Option<f64> {
        self.min
    }

    /// Half of the frames took no longer; `None` before the first.
    #[must_use]
    pub fn p50(&self) -> Option<Duration> {
        self.percentile(50)
    }

    /// 99 of 100 frames took no longer; `None` before the first.
    #[must_use]
    pub fn p99(&self) -> Option<Duration> {
        self.percentile(99)
    }

    /// The sum over the frames that are kept.
    #[must_use]
    pub fn total(&self) -> Duration {
        self.times.iter().sum()
    }

    fn mean_of_last_ten(&self) -> Option<f64> {
        let first = self.times.len().checked_sub(FRAMES_IN_MEAN)?;
        let sum: Duration = self.times.range(first..).sum();
        // A clock too coarse to see ten frames says nothing about their rate.
        (sum > Duration::ZERO).then(|| FRAMES_IN_MEAN as f64 / sum.as_secs_f64())
    }

    /// Nearest rank: the smallest time that `percent` of 100 frames don't exceed.
    fn percentile(&self, percent: usize) -> Option<Duration> {
        let mut sorted: Vec<_> = self.times.iter().copied().collect();
        let rank = (sorted.len() * percent).div_ceil(100).checked_sub(1)?;
        Some(*sorted.select_nth_unstable(rank).1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn milliseconds(times: impl IntoIterator<Item = u64>) -> FrameRate {
        let mut rate = FrameRate::of_run();
        for time in times {
            rate.record(Duration::from_millis(time));
        }
        rate
    }

    #[test]
    fn no_rate_before_the_tenth_frame() {
        assert_eq!(milliseconds([20; 9]).fps(), None);
        assert_eq!(milliseconds([20; 10]).fps(), Some(50.0));
    }

    #[test]
    fn the_mean_forgets_all_but_the_last_ten_frames() {
        let rate = milliseconds([1000; 5].into_iter().chain([10; 10]));
        assert_eq!(rate.fps(), Some(100.0));
    }

    #[test]
    fn one_slow_frame_lowers_the_smallest_mean_by_its_share_in_ten() {
        let rate = milliseconds([10; 10].into_iter().chain([110]).chain([10; 20]));
        assert_eq!(rate.max_fps(), Some(100.0));
        assert_eq!(rate.min_fps(), Some(50.0)); // 9 · 10 ms + 110 ms = 200 ms
    }

    #[test]
    fn percentiles_are_times_that_occurred() {
        let rate = milliseconds(1..=100);
        assert_eq!(rate.p50(), Some(Duration::from_millis(50)));
        assert_eq!(rate.p99(), Some(Duration::from_millis(99)));
        assert_eq!(milliseconds([7]).p99(), Some(Duration::from_millis(7)));
        assert_eq!(milliseconds([]).p50(), None);
    }

    #[test]
    fn a_window_forgets_old_frames_but_not_the_extremes() {
        let mut rate = FrameRate::of_window();
        for _ in 0..10 {
            rate.record(Duration::from_millis(100));
        }
        for _ in 0..FRAMES_IN_WINDOW {
            rate.record(Duration::from_millis(10));
        }
        assert_eq!(rate.p99(), Some(Duration::from_millis(10)));
        assert_eq!(rate.min_fps(), Some(10.0));
        assert_eq!(rate.total(), Duration::from_secs(6));
    }

    #[test]
    fn frames_too_short_to_measure_have_no_rate() {
        assert_eq!(milliseconds([0; 20]).max_fps(), None);
    }
}
