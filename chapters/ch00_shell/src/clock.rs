//! How many steps a frame makes, and how far between two steps it draws.
//!
//! [`Pace::Fixed`] saves up the time that passes and spends it in steps of one size, so that
//! the result doesn't depend on the frame rate; what is left over says how far to
//! interpolate. [`Pace::Variable`] is the report's way: one step a frame, as long as the
//! last frame took. The clock reads no time itself: its caller says how much has passed.
//!
//! A machine may need longer for a step than the step lasts. It can't keep up, and the more steps a frame
//! makes the longer it takes, until the next one wants still more. Time is dropped then:
//! the picture goes on in slow motion, but it goes on.

/// How the clock turns time into steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Steps of one size, as many as the time that has passed has room for.
    Fixed,
    /// One step a frame, as long as the last frame: the report's behaviour.
    Variable,
}

/// What to do in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// How many steps to make.
    pub steps: u32,
    /// Size of each, s.
    pub dt: f64,
    /// How far between the last two states to draw: 0 at the one before, 1 at the last.
    pub alpha: f64,
}

/// Turns the time that passes between frames into steps.
#[derive(Clone, Debug)]
pub struct Clock {
    pace: Pace,
    saved: f64,
    dropped: f64,
}

/// Time that a frame may at most catch up with, in steps. A machine that needs longer for a
/// step than the step lasts would otherwise fall further behind with each frame.
pub const MAX_STEPS_PER_FRAME: u32 = 4;

/// The steps of a frame may take so long, s, if they are more than one: with a picture that takes as long
/// there are still 15 frames a second.
pub const LONGEST_STEPS: f64 = 1.0 / 30.0;

/// The longest variable step, s. Only a window that stood still (hidden, suspended) gets
/// here; the report's frames of 66 ms pass unchanged.
pub const LONGEST_VARIABLE_STEP: f64 = 0.5;

/// The shortest variable step, s: methods divide by the step's size.
pub const SHORTEST_VARIABLE_STEP: f64 = 1e-4;

impl Clock {
    /// A clock that has saved up no time.
    #[must_use]
    pub fn new(pace: Pace) -> Self {
        Self {
            pace,
            saved: 0.0,
            dropped: 0.0,
        }
    }

    /// How it turns time into steps.
    #[must_use]
    pub fn pace(&self) -> Pace {
        self.pace
    }

    /// Changes how it turns time into steps, and forgets the time saved up.
    pub fn set_pace(&mut self, pace: Pace) {
        self.pace = pace;
        self.saved = 0.0;
    }

    /// Forgets the time saved up, after a pause or a reset.
    pub fn restart(&mut self) {
        self.saved = 0.0;
    }

    /// Time that passed without being simulated since the clock was made, s.
    #[must_use]
    pub fn dropped(&self) -> f64 {
        self.dropped
    }

    /// What to do in a frame that begins `elapsed` seconds after the last one began, where
    /// a step is `dt` seconds and takes `cost` seconds to make.
    pub fn frame(&mut self, elapsed: f64, dt: f64, cost: f64) -> Frame {
        match self.pace {
            Pace::Fixed => self.fixed_frame(elapsed, dt, most_steps(cost)),
            Pace::Variable => self.variable_frame(elapsed),
        }
    }

    fn fixed_frame(&mut self, elapsed: f64, dt: f64, most: u32) -> Frame {
        self.saved += elapsed.max(0.0);
        let due = (self.saved / dt).floor();
        let steps = due.min(f64::from(most));
        self.dropped += (due - steps) * dt;
        self.saved = (self.saved - due * dt).clamp(0.0, dt);
        let steps = steps as u32;
        Frame {
            steps,
            dt,
            alpha: self.saved / dt,
        }
    }

    fn variable_frame(&mut self, elapsed: f64) -> Frame {
        let dt = variable_step(elapsed);
        self.dropped += (elapsed - dt).max(0.0);
        Frame {
            steps: 1,
            dt,
            alpha: 1.0,
        }
    }
}

/// How many steps a frame may make if one takes `cost` seconds.
fn most_steps(cost: f64) -> u32 {
    // Too large a float becomes the largest whole number.
    ((LONGEST_STEPS / cost.max(1e-9)) as u32).clamp(1, MAX_STEPS_PER_FRAME)
}

/// The report's step: what the last frame took, s, between [`SHORTEST_VARIABLE_STEP`] and
/// [`LONGEST_VARIABLE_STEP`].
#[must_use]
pub fn variable_step(last_frame: f64) -> f64 {
    last_frame.clamp(SHORTEST_VARIABLE_STEP, LONGEST_VARIABLE_STEP)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DT: f64 = 1.0 / 64.0; // exact in binary, so that sums of it are

    #[test]
    fn a_frame_as_long_as_a_step_makes_one_step() {
        let mut clock = Clock::new(Pace::Fixed);
        for _ in 0..100 {
            let frame = clock.frame(DT, DT, 0.0);
            assert_eq!((frame.steps, frame.alpha), (1, 0.0));
        }
    }

    #[test]
    fn frames_twice_as_fast_step_every_second_time_and_draw_halfway() {
        let mut clock = Clock::new(Pace::Fixed);
        let first = clock.frame(DT / 2.0, DT, 0.0);
        let second = clock.frame(DT / 2.0, DT, 0.0);
        assert_eq!((first.steps, first.alpha), (0, 0.5));
        assert_eq!((second.steps, second.alpha), (1, 0.0));
    }

    #[test]
    fn all_time_is_either_stepped_or_saved_or_counted_as_dropped() {
        let mut clock = Clock::new(Pace::Fixed);
        let (mut passed, mut stepped, mut alpha) = (0.0, 0.0, 0.0);
        for i in 0..1000 {
            let elapsed = f64::from(i % 7) * 0.021;
            let frame = clock.frame(elapsed, DT, 0.0);
            passed += elapsed;
            stepped += f64::from(frame.steps) * DT;
            alpha = frame.alpha;
        }
        assert!(clock.dropped() > 1.0);
        assert!((passed - stepped - alpha * DT - clock.dropped()).abs() < 1e-9);
    }

    #[test]
    fn a_long_stall_makes_few_steps_and_says_what_it_dropped() {
        let mut clock = Clock::new(Pace::Fixed);
        let frame = clock.frame(100.0 * DT, DT, 0.0);
        assert_eq!(frame.steps, MAX_STEPS_PER_FRAME);
        let expected = f64::from(100 - MAX_STEPS_PER_FRAME) * DT;
        assert!((clock.dropped() - expected).abs() < 1e-12);
        assert_eq!(clock.frame(DT, DT, 0.0).steps, 1, "the stall is over");
    }

    #[test]
    fn steps_that_take_long_are_not_caught_up_with() {
        for (cost, most) in [(0.001, 4), (0.01, 3), (0.0166, 2), (0.017, 1), (2.0, 1)] {
            let mut clock = Clock::new(Pace::Fixed);
            let frame = clock.frame(10.0 * DT, DT, cost);
            assert_eq!(frame.steps, most, "{cost} s a step");
            let dropped = f64::from(10 - most) * DT;
            assert!((clock.dropped() - dropped).abs() < 1e-12);
        }
    }

    #[test]
    fn a_clock_that_runs_backwards_makes_no_step() {
        let mut clock = Clock::new(Pace::Fixed);
        assert_eq!(clock.frame(-1.0, DT, 0.0).steps, 0);
    }

    #[test]
    fn a_variable_step_is_as_long_as_the_last_frame() {
        let mut clock = Clock::new(Pace::Variable);
        let frame = clock.frame(0.066, DT, 0.0);
        assert_eq!((frame.steps, frame.alpha), (1, 1.0));
        assert!((frame.dt - 0.066).abs() < 1e-15);
    }

    #[test]
    fn a_variable_step_is_never_zero_and_never_longer_than_half_a_second() {
        let mut clock = Clock::new(Pace::Variable);
        assert!((clock.frame(0.0, DT, 0.0).dt - SHORTEST_VARIABLE_STEP).abs() < 1e-15);
        assert!((clock.frame(30.0, DT, 0.0).dt - LONGEST_VARIABLE_STEP).abs() < 1e-15);
        assert!((clock.dropped() - 29.5).abs() < 1e-12);
    }

    #[test]
    fn restarting_forgets_the_time_saved_up() {
        let mut clock = Clock::new(Pace::Fixed);
        clock.frame(0.75 * DT, DT, 0.0);
        clock.restart();
        assert_eq!(clock.frame(0.75 * DT, DT, 0.0).steps, 0);
    }
}
