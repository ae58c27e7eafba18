//! When the last steps were made: a state that comes back from a device some frames late belongs to
//! one of them.

use std::collections::VecDeque;

/// The end of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// Steps since the start.
    pub step: u64,
    /// Simulated time since the start, s.
    pub time: f64,
    /// The first frame that shows it.
    pub frame: u64,
}

/// How many moments are kept: a device that is further behind than this is not waited for.
const KEPT: usize = 512;

/// The last moments, one after each step.
#[derive(Clone, Debug)]
pub struct Moments {
    kept: VecDeque<Moment>,
    /// The frame that is shown.
    frame: u64,
}

impl Moments {
    /// Before the first step.
    pub fn start() -> Self {
        Self {
            kept: VecDeque::from([Moment::default()]),
            frame: 0,
        }
    }

    /// After so many steps, and this much simulated time, s.
    pub fn note(&mut self, step: u64, time: f64) {
        if self.kept.len() == KEPT {
            self.kept.pop_front();
        }
        let frame = self.frame + 1;
        self.kept.push_back(Moment { step, time, frame });
    }

    /// The next frame is shown.
    pub fn show_frame(&mut self) {
        self.frame += 1;
    }

    /// The end of this step; where it is no longer known, of the first one that is.
    pub fn of(&self, step: u64) -> Moment {
        let first = self.kept.front().map_or(0, |first| first.step);
        let place = step.saturating_sub(first) as usize;
        let found = self.kept.get(place).or(self.kept.back());
        found.copied().unwrap_or_default()
    }

    /// Forgets what came after a moment.
    pub fn go_back_to(&mut self, moment: Moment) {
        self.kept.retain(|known| known.step <= moment.step);
    }

    /// Frames since a moment.
    pub fn frames_since(&self, moment: Moment) -> u64 {
        self.frame.saturating_sub(moment.frame)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two steps a frame, of half a second.
    fn moments(steps: u64) -> Moments {
        let mut moments = Moments::start();
        for step in 1..=steps {
            moments.note(step, step as f64 / 2.0);
            if step % 2 == 0 {
                moments.show_frame();
            }
        }
        moments
    }

    #[test]
    fn a_step_is_found_with_its_time_and_its_frame() {
        let moments = moments(10);
        let Moment { step, time, frame } = moments.of(6);
        assert_eq!((step, time, frame), (6, 3.0, 3));
        assert_eq!(moments.frames_since(moments.of(6)), 2);
        assert_eq!(moments.frames_since(moments.of(0)), 5);
    }

    #[test]
    fn of_a_long_run_the_last_steps_are_known() {
        let moments = moments(3000);
        assert_eq!(moments.of(2900).step, 2900);
        assert_eq!(moments.of(7).step, 3001 - KEPT as u64);
    }

    #[test]
    fn what_comes_after_a_step_can_be_forgotten() {
        let mut moments = moments(9);
        moments.go_back_to(moments.of(4));
        assert_eq!(moments.of(9).step, 4);
    }
}
