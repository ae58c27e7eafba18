//! How bodies move while a sweep goes through the colours: what one colour wrote, the next one reads.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use crate::bodies::Bodies;
use crate::lanes::threads;
use crate::own_row::body::Gathered;
use crate::own_row::contact::{Given, Moved};
use crate::own_row::side::{Side, Turns};
use crate::rows::Held;
use crate::simd::{Four, MOST_LANES, Mask, Real, Vec3};

// ANCHOR: live
/// How a body moves by now, four rows of four numbers: its velocity with n = 1, its angular velocity with 1/m,
/// and those of its push. It is a cache line by itself. The line behind it is what its pairs gave it when they
/// were visited for the last time: impulse and how many count, turning impulse, and what of both was impacts.
///
/// Two batches of a colour have no body in common that moves, so no number is ever written by two threads or
/// read by one while another writes it; but the compiler can't know. Atomic loads and stores, two numbers at a
/// time and in no order, are plain ones to the processor.
#[repr(align(64))]
#[derive(Debug, Default)]
struct Row([AtomicU64; 16]);

/// A row a body.
#[derive(Debug, Default)]
pub struct Live {
    rows: Vec<Row>,
}
// ANCHOR_END: live

/// Where in a row the impulses begin.
const IMPULSES: usize = 4;

/// Where those of them that were impacts begin.
const IMPACTS: usize = 6;

impl Clone for Live {
    /// Nothing: it is filled anew before each sweep.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Row {
    #[inline(always)]
    fn read(&self, k: usize) -> [f32; 4] {
        bytemuck::cast([self.0[2 * k].load(Relaxed), self.0[2 * k + 1].load(Relaxed)])
    }

    #[inline(always)]
    fn write(&self, k: usize, numbers: [f32; 4]) {
        let [one, two]: [u64; 2] = bytemuck::cast(numbers);
        self.0[2 * k].store(one, Relaxed);
        self.0[2 * k + 1].store(two, Relaxed);
    }

    #[inline(always)]
    fn add(&self, k: usize, numbers: [f32; 4]) {
        let sum = Four::new(self.read(k)) + Four::new(numbers);
        self.write(k, sum.to_array());
    }

    fn held(&self, k: usize) -> Held {
        bytemuck::cast([self.read(k), self.read(k + 1)])
    }
}

impl Live {
    /// As the bodies move now, without pushes and impulses.
    pub fn fill(&mut self, bodies: &Bodies, least: usize) {
        let fill = |row: usize, live: &mut Row| {
            let (motion, spin) = (&bodies.motion[row], &bodies.spin[row]);
            live.write(0, motion.velocity.extend(1.0).to_array());
            let turning = spin.angular_velocity.extend(spin.inverse_mass);
            live.write(1, turning.to_array());
            for k in 2..8 {
                live.write(k, [0.0; 4]);
            }
        };
        if self.rows.len() == bodies.rows() {
            threads::each_in(&mut self.rows, bodies.runs(), least, fill);
        } else {
            self.rows.resize_with(bodies.rows(), Row::default);
            threads::each(&mut self.rows, least, fill);
        }
    }

    // ANCHOR: add
    /// Adds what pairs gave one of their bodies, b or a, where `moves` has a lane's bit.
    #[inline(always)]
    pub fn add<R: Real>(&self, given: &Given<R>, is_b: bool, rows: &[u32], moves: u32) {
        let (linear, turning) = if is_b {
            (given.linear, given.angular_b)
        } else {
            (-given.linear, given.angular_a)
        };
        let of = |v: Vec3<R>, last: R| R::to_rows([v.x, v.y, v.z, last]);
        let zero = R::splat(0.0);
        let columns = [of(linear, given.counts), of(turning, zero)];
        self.add_at(IMPULSES, columns, rows, moves);
        let impact = R::splat(1.0) - given.stays;
        if impact.gt(zero).any() {
            let columns = [of(linear * impact, zero), of(turning * impact, zero)];
            self.add_at(IMPACTS, columns, rows, moves);
        }
    }

    #[inline(always)]
    fn add_at(&self, at: usize, columns: [[[f32; 4]; MOST_LANES]; 2], rows: &[u32], moves: u32) {
        for lane in (0..MOST_LANES).filter(|lane| moves >> lane & 1 == 1) {
            let row = &self.rows[rows[lane] as usize];
            row.add(at, columns[0][lane]);
            row.add(at + 1, columns[1][lane]);
        }
    }
    // ANCHOR_END: add

    /// What a body's pairs gave it; its pushes aren't impulses but [`Self::push`].
    #[must_use]
    pub fn gathered(&self, row: usize) -> Gathered {
        let row = &self.rows[row];
        let [_, _, _, counts] = row.read(IMPULSES);
        Gathered::of(row.held(IMPULSES), row.held(IMPACTS), counts)
    }

    /// How fast a body is pushed, m/s, and how it is turned by that, rad/s: three numbers each.
    #[inline(always)]
    #[must_use]
    pub fn push(&self, row: usize) -> [[f32; 4]; 2] {
        [self.rows[row].read(2), self.rows[row].read(3)]
    }

    /// All rows are filled next time, those that sleep too.
    pub fn forget(&mut self) {
        self.rows.clear();
    }

    /// Bodies as they are now, with their whole masses.
    #[inline(always)]
    #[must_use]
    pub fn read<R: Real, I: Turns<R>>(&self, bodies: &Bodies, rows: &[u32]) -> Moved<R, I> {
        let live = |k: usize| R::of_rows(|lane| self.rows[rows[lane] as usize].read(k));
        let [px, py, pz, _] = live(2);
        let [qx, qy, qz, _] = live(3);
        Moved {
            side: Side::moving(bodies, rows, live(0), live(1)),
            push: Vec3::new(px, py, pz),
            turning_push: Vec3::new(qx, qy, qz),
        }
    }

    /// Puts back what became of them, where `moves` has a lane's bit.
    #[inline(always)]
    pub fn write<R: Real, I>(&self, moved: &Moved<R, I>, rows: &[u32], moves: u32) {
        let of = |v: Vec3<R>, last: R| R::to_rows([v.x, v.y, v.z, last]);
        let (zero, side) = (R::splat(0.0), &moved.side);
        let columns = [
            of(side.velocity, R::splat(1.0)),
            of(side.angular_velocity, side.inverse_mass),
            of(moved.push, zero),
            of(moved.turning_push, zero),
        ];
        for lane in (0..R::LANES).filter(|lane| moves >> lane & 1 == 1) {
            let row = &self.rows[rows[lane] as usize];
            for (k, column) in columns.iter().enumerate() {
                row.write(k, column[lane]);
            }
        }
    }
}
