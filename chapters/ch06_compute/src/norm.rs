//! Lengths of vectors, with the square root that the compiler makes.

use glam::{Vec2, Vec3};

// ANCHOR: norm
/// A vector that has a length.
pub trait Norm {
    /// Its length, rounded as `glam`'s `length` is. That calls `libm`, which has the instruction written out as SSE
    /// knows it. In a program for AVX the processor puts the wide registers aside before it, and fetches
    /// them back after it: some hundred cycles on Intel's, and the narrow phase takes many lengths.
    fn norm(self) -> f32;
}

impl Norm for Vec2 {
    #[inline]
    fn norm(self) -> f32 {
        self.length_squared().sqrt()
    }
}

impl Norm for Vec3 {
    #[inline]
    fn norm(self) -> f32 {
        self.length_squared().sqrt()
    }
}
// ANCHOR_END: norm

#[cfg(test)]
mod tests {
    use ch00_scenes::random::SplitMix64;

    use super::*;

    #[test]
    fn norms_have_the_bits_of_lengths() {
        let mut random = SplitMix64::new(7);
        let mut number = || (random.next_u64() as f64 / u64::MAX as f64 - 0.5) as f32 * 1e3;
        for _ in 0..10_000 {
            let v = Vec3::new(number(), number(), number());
            assert_eq!(v.norm().to_bits(), v.length().to_bits(), "{v}");
            let v = v.truncate();
            assert_eq!(v.norm().to_bits(), v.length().to_bits(), "{v}");
        }
    }
}
