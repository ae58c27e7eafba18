//! What each of the seven steps is able to do, and the hash by which they are compared.

use glam::Vec3;

use crate::ball::Ball;

/// A number of balls that fly and bounce, however they are stored.
pub trait World {
    /// All balls fly for `dt` seconds.
    fn integrate(&mut self, dt: f32);

    /// Those that have reached the floor turn back.
    fn bounce(&mut self, dt: f32);

    /// One step of time.
    fn step(&mut self, dt: f32) {
        self.integrate(dt);
        self.bounce(dt);
    }

    /// All properties of a ball.
    fn ball(&self, number: usize) -> Ball;

    /// Bytes that a ball takes, with the pointers that lead to it, without what the allocator adds.
    fn bytes(&self) -> usize;

    /// The places in memory that `integrate` needs for a ball.
    fn visits(&self, number: usize) -> Vec<Span>;
}

/// A value's place in memory.
pub struct Span {
    pub address: usize,
    pub bytes: usize,
}

impl Span {
    /// Where this value lies.
    pub fn of<T>(value: &T) -> Self {
        Self {
            address: std::ptr::from_ref(value).addr(),
            bytes: size_of::<T>(),
        }
    }

    /// Where a ball's p and p* lie.
    pub fn of_places(position: &Vec3, last_position: &Vec3) -> Vec<Self> {
        vec![Self::of(position), Self::of(last_position)]
    }

    /// Numbers of the cache lines that it lies in.
    pub fn lines(&self) -> impl Iterator<Item = usize> {
        self.address / LINE..=(self.address + self.bytes - 1) / LINE
    }
}

/// Bytes of a cache line.
pub const LINE: usize = 64;

/// Of every bit of the positions (64-bit FNV-1a over the numbers in order), the balls one by one.
pub fn hash(balls: impl IntoIterator<Item = Ball>) -> u64 {
    let numbers = balls.into_iter().flat_map(|ball| ball.position.to_array());
    numbers
        .flat_map(f32::to_le_bytes)
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::mem::offset_of;

    use super::*;

    /// How many lines the first `count` values lie in that begin at `start` and then every `stride` bytes.
    fn lines(start: usize, stride: usize, bytes: usize, count: usize) -> usize {
        let spans = (0..count).map(|i| Span {
            address: start + i * stride,
            bytes,
        });
        let lines: BTreeSet<usize> = spans
            .flat_map(|span| span.lines().collect::<Vec<_>>())
            .collect();
        lines.len()
    }

    #[test]
    fn of_ten_structs_integrate_needs_13_of_16_lines() {
        assert_eq!(offset_of!(Ball, position), 0);
        assert_eq!(offset_of!(Ball, last_position), 12);
        assert_eq!(lines(0, size_of::<Ball>(), 24, 10), 13);
        assert_eq!(lines(0, size_of::<Ball>(), size_of::<Ball>(), 10), 16);
    }

    #[test]
    fn of_ten_balls_as_columns_integrate_needs_4_of_19_lines() {
        assert_eq!(2 * lines(0, 12, 12, 10), 4);
        let columns = [12, 12, 16, 16, 4, 12, 4, 4, 4, 4, 12];
        assert_eq!(columns.iter().sum::<usize>(), size_of::<Ball>());
        assert_eq!(
            columns
                .map(|bytes| lines(0, bytes, bytes, 10))
                .iter()
                .sum::<usize>(),
            19
        );
    }

    #[test]
    fn a_run_lies_on_average_in_as_many_lines_as_the_formula_says() {
        // Anywhere at a multiple of 4: the run's bytes and a line's, less 4, in lines.
        for bytes in [4, 12, 24, 100] {
            let places = (0..LINE / 4).map(|place| lines(4 * place, 0, bytes, 1));
            assert_eq!(places.sum::<usize>() * 4, bytes + LINE - 4);
        }
    }
}
