//! Random numbers that are the same on every machine: `SplitMix64`.
//!
//! The state is a counter that grows by the odd number ⌊2⁶⁴/φ⌋ (φ the golden ratio), so
//! it visits every 64-bit number once; a mixing function hides the pattern. Source:
//! Steele, Lea and Flood 2014, "Fast Splittable Pseudorandom Number Generators", figure
//! 17 (there with other constants), and Vigna's `splitmix64.c` for these.

use ch00_maths::f64::real::{PI, cos, sin};
use glam::{DQuat, DVec3};

/// What the counter grows by: 2⁶⁴ divided by the golden ratio, rounded to an odd number.
const GOLDEN_GAMMA: u64 = 0x9E37_79B9_7F4A_7C15;

/// A stream of random numbers that its seed determines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SplitMix64 {
    counter: u64,
}

impl SplitMix64 {
    /// The stream of this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { counter: seed }
    }

    /// 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        self.counter = self.counter.wrapping_add(GOLDEN_GAMMA);
        let z = self.counter;
        let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in [0, 1): the top 53 bits, which is what an f64 holds exactly.
    #[expect(
        clippy::cast_precision_loss,
        reason = "53 bits fit an f64 without loss"
    )]
    pub fn unit(&mut self) -> f64 {
        const STEPS: f64 = (1_u64 << 53) as f64;
        (self.next_u64() >> 11) as f64 / STEPS
    }

    /// A number in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A vector with each component in [−size, size): x, then y, then z.
    pub fn vector(&mut self, size: f64) -> DVec3 {
        let x = self.between(-size, size);
        let y = self.between(-size, size);
        let z = self.between(-size, size);
        DVec3::new(x, y, z)
    }

    /// A rotation, all equally likely: two angles, and how much of the quaternion each has
    /// [Shoemake 1992, "Uniform random rotations", Graphics Gems III].
    pub fn rotation(&mut self) -> DQuat {
        let share = self.unit();
        let (a, b) = (self.between(0.0, 2.0 * PI), self.between(0.0, 2.0 * PI));
        let (c, d) = ((1.0 - share).sqrt(), share.sqrt());
        DQuat::from_xyzw(c * sin(a), c * cos(a), d * sin(b), d * cos(b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_42_gives_the_published_stream() {
        let mut random = SplitMix64::new(42);
        let stream: Vec<u64> = (0..5).map(|_| random.next_u64()).collect();
        assert_eq!(
            stream,
            [
                13_679_457_532_755_275_413,
                2_949_826_092_126_892_291,
                5_139_283_748_462_763_858,
                6_349_198_060_258_255_764,
                701_532_786_141_963_250,
            ]
        );
    }

    #[test]
    fn seed_1234567_gives_the_published_stream() {
        let mut random = SplitMix64::new(1_234_567);
        let stream: Vec<u64> = (0..3).map(|_| random.next_u64()).collect();
        assert_eq!(
            stream,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423,
            ]
        );
    }

    #[test]
    fn a_unit_number_is_the_top_53_bits() {
        let mut random = SplitMix64::new(42);
        assert!((random.unit() - 0.741_564_878_771_823_3).abs() < 1e-16);
        assert!((random.unit() - 0.159_910_392_876_920_1).abs() < 1e-16);
    }

    #[test]
    fn numbers_between_two_bounds_keep_to_them_and_fill_the_range() {
        let mut random = SplitMix64::new(7);
        let draws: Vec<f64> = (0..10_000).map(|_| random.between(0.1, 0.3)).collect();
        let least = draws.iter().copied().fold(f64::INFINITY, f64::min);
        let most = draws.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!((0.1..0.1001).contains(&least), "{least}");
        assert!((0.2999..0.3).contains(&most), "{most}");
    }

    #[test]
    fn random_rotations_are_of_unit_length_and_take_an_axis_everywhere() {
        let mut random = SplitMix64::new(11);
        let mut sum = DVec3::ZERO;
        let mut squares = DVec3::ZERO;
        for _ in 0..10_000 {
            let q = random.rotation();
            assert!((q.length() - 1.0).abs() < 1e-14);
            let axis = q * DVec3::X;
            sum += axis / 10_000.0;
            squares += axis * axis / 10_000.0;
        }
        // Of a direction that is equally likely everywhere each component has mean 0 and
        // mean square 1/3; three standard deviations of these means are 0.017 and 0.009.
        assert!(sum.abs().max_element() < 0.017, "{sum}");
        let off = (squares - DVec3::splat(1.0 / 3.0)).abs().max_element();
        assert!(off < 0.009, "{squares}");
    }
}
