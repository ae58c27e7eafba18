//! An axis as a scale: which numbers it spans, where a number stands on it, and where its
//! ticks are. Numbers that it can't hold stand below it or beyond it.

use super::numbers::{multiple, part_of_decade, power_of_ten};
use crate::chart::{Axis, Scale as Division};

/// Where a number stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At 0 or under it, on an axis by powers of ten.
    Below,
    /// Between the axis' ends, 0 to 1.
    On(f64),
    /// Not finite.
    Beyond,
}

/// A line across the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Between the axis' ends, 0 to 1.
    pub at: f64,
    /// What stands beside it; empty for a light line.
    pub label: String,
}

/// An axis with the numbers that it spans.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    division: Division,
    /// Ends of the axis, as log₁₀ on an axis by powers of ten.
    low: f64,
    high: f64,
    /// What stands beside the band for numbers of 0 and less, if there are any.
    pub below: Option<&'static str>,
    /// The same for numbers that are not finite.
    pub beyond: Option<&'static str>,
}

/// Room between the outermost numbers and the ends of the axis, over its length.
const ROOM: f64 = 0.04;

impl Scale {
    /// The scale that holds these numbers.
    pub fn of(axis: &Axis, numbers: impl Iterator<Item = f64>) -> Self {
        let division = axis.scale;
        let (mut below, mut beyond) = (None, None);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for number in numbers.chain(axis.reaches.iter().copied()) {
            if !number.is_finite() {
                beyond = Some(axis.lost);
            } else if division == Division::Log && number <= 0.0 {
                below = Some(if number < 0.0 {
                    "≤ 0"
                } else {
                    below.unwrap_or("0")
                });
            } else {
                let number = measured(division, number);
                (low, high) = (low.min(number), high.max(number));
            }
        }
        let (low, high) = ends(division, low, high);
        Self {
            division,
            low,
            high,
            below,
            beyond,
        }
    }

    /// Where a number stands.
    pub fn place(&self, number: f64) -> Place {
        if !number.is_finite() {
            Place::Beyond
        } else if self.division == Division::Log && number <= 0.0 {
            Place::Below
        } else {
            Place::On(self.share(measured(self.division, number)))
        }
    }

    /// The ticks, about `most` of them with a label.
    pub fn ticks(&self, most: usize) -> Vec<Tick> {
        match self.division {
            Division::Linear => self.even_ticks(most),
            Division::Log => self.decade_ticks(most),
        }
    }

    /// Ticks at whole numbers, each called by the power of ten that it is the exponent of.
    pub fn powers(&self) -> Vec<Tick> {
        let (first, last) = (self.low.ceil() as i32, self.high.floor() as i32);
        let tick = |exponent: i32| Tick {
            at: self.share(f64::from(exponent)),
            label: power_of_ten(exponent, first >= -4 && last <= 5),
        };
        (first..=last).map(tick).collect()
    }

    fn share(&self, number: f64) -> f64 {
        (number - self.low) / (self.high - self.low)
    }

    fn even_ticks(&self, most: usize) -> Vec<Tick> {
        let step = round_step((self.high - self.low) / most.max(1) as f64);
        let largest = self.low.abs().max(self.high.abs());
        let (first, last) = (
            (self.low / step).ceil() as i64,
            (self.high / step).floor() as i64,
        );
        (first..=last)
            .map(|k| {
                let value = k as f64 * step;
                Tick {
                    at: self.share(value),
                    label: multiple(value, step, largest),
                }
            })
            .collect()
    }

    fn decade_ticks(&self, most: usize) -> Vec<Tick> {
        let (first, last) = (self.low.floor() as i32, self.high.floor() as i32);
        let plain = first >= -4 && last <= 5;
        let decades = self.high - self.low;
        let every = ((decades / most.max(1) as f64).ceil() as i32).max(1);
        // Few decades are labelled between their ends too; many have no lines there.
        let digits: &[i32] = match decades {
            ..1.2 => &[1, 2, 3, 4, 5, 6, 7, 8, 9],
            ..3.0 => &[1, 2, 5],
            _ => &[1],
        };
        let lines = if every == 1 && decades < 8.0 {
            1..=9
        } else {
            1..=1
        };
        let mut ticks = Vec::new();
        for exponent in first..=last {
            for digit in lines.clone() {
                let at = self.share(f64::from(exponent) + f64::from(digit).log10());
                if !(0.0..=1.0).contains(&at) {
                    continue;
                }
                let label = match digit {
                    1 if exponent.rem_euclid(every) == 0 => power_of_ten(exponent, plain),
                    2.. if digits.contains(&digit) => part_of_decade(digit, exponent, plain),
                    _ => String::new(),
                };
                ticks.push(Tick { at, label });
            }
        }
        ticks
    }
}

/// A number as it is measured along the axis.
fn measured(division: Division, number: f64) -> f64 {
    match division {
        Division::Linear => number,
        Division::Log => number.log10(),
    }
}

/// The ends of an axis for numbers from `low` to `high`, which are crossed where there are none.
fn ends(division: Division, low: f64, high: f64) -> (f64, f64) {
    if low > high {
        return (0.0, 1.0);
    }
    let least = match division {
        // Rounding alone must not fill the axis.
        Division::Linear => (1e-6 * low.abs().max(high.abs())).max(1e-300),
        Division::Log => 0.1,
    };
    let room = if high - low < least {
        match division {
            Division::Linear if high == 0.0 => 1.0,
            Division::Linear => 0.1 * high.abs().max(low.abs()),
            Division::Log => 0.6,
        }
    } else {
        ROOM * (high - low)
    };
    (low - room, high + room)
}

/// 1, 2 or 5 times a power of ten: the next one from `least` upwards.
fn round_step(least: f64) -> f64 {
    let decade = 10f64.powf(least.log10().floor());
    let digit = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|digit| digit * decade >= least * (1.0 - 1e-9));
    digit.unwrap_or(10.0) * decade
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale, most: usize) -> Vec<String> {
        let ticks = scale.ticks(most).into_iter();
        ticks
            .map(|tick| tick.label)
            .filter(|label| !label.is_empty())
            .collect()
    }

    #[test]
    fn an_even_axis_has_round_numbers() {
        let scale = Scale::of(&Axis::linear("x"), [0.0, 0.6].into_iter());
        assert_eq!(
            labels(&scale, 8),
            ["0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6"]
        );
    }

    #[test]
    fn one_constant_number_stands_in_the_middle() {
        for axis in [Axis::linear("x"), Axis::log("x")] {
            let scale = Scale::of(&axis, [3.0].into_iter());
            let Place::On(at) = scale.place(3.0) else {
                panic!("3 is a number like others");
            };
            assert!((at - 0.5).abs() < 1e-12, "{at}");
        }
    }

    #[test]
    fn zeros_and_losses_have_their_places() {
        let numbers = [0.0, 0.1, f64::NAN];
        let log = Scale::of(&Axis::log("x"), numbers.into_iter());
        assert_eq!((log.below, log.beyond), (Some("0"), Some("lost")));
        assert_eq!(log.place(0.0), Place::Below);
        assert_eq!(log.place(f64::NEG_INFINITY), Place::Beyond);
        let linear = Scale::of(&Axis::linear("x"), numbers.into_iter());
        assert_eq!(linear.below, None);
        assert!(matches!(linear.place(0.0), Place::On(_)));
    }

    #[test]
    fn a_negative_number_changes_the_label_of_the_band() {
        let scale = Scale::of(&Axis::log("x"), [0.0, -1.0, 0.0].into_iter());
        assert_eq!(scale.below, Some("≤ 0"));
    }

    #[test]
    fn an_axis_without_numbers_still_has_ends() {
        let scale = Scale::of(&Axis::log("x"), [f64::NAN].into_iter());
        assert_eq!(labels(&scale, 8)[0], "1");
    }

    #[test]
    fn many_decades_are_labelled_now_and_then() {
        let scale = Scale::of(&Axis::log("x"), [1e-18, 1.0].into_iter());
        let labels = labels(&scale, 7);
        assert!(labels.len() <= 7, "{labels:?}");
        assert!(labels.contains(&"10⁻¹⁵".to_owned()), "{labels:?}");
    }
}
