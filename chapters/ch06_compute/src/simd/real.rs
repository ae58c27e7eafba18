//! A number, or as many as the processor has lanes.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, Mul, MulAssign, Neg, Not, Sub, SubAssign};

use wide::{f32x4, f32x8};

/// Four lanes: what every 64-bit processor has.
pub type Four = f32x4;

/// Eight lanes: two instructions of four where the processor has no wider ones.
pub type Eight = f32x8;

/// As many lanes as the processors that the program is built for compute with one instruction. Twice as many have
/// the same bits; they take twice the instructions and registers, and more of them are left over in small scenes.
#[cfg(target_feature = "avx")]
pub type Widest = Eight;

/// As many lanes as the processors that the program is built for compute with one instruction. Twice as many have
/// the same bits; they take twice the instructions and registers, and more of them are left over in small scenes.
#[cfg(not(target_feature = "avx"))]
pub type Widest = Four;

/// The most lanes that a number has here.
pub const MOST_LANES: usize = 8;

// ANCHOR: real
/// A number in each lane.
pub trait Real:
    Copy
    + Debug
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// Yes or no in each lane.
    type Mask: Mask;

    /// How many lanes.
    const LANES: usize;

    /// The same number in each lane.
    fn splat(number: f32) -> Self;

    /// What `number` gives for each lane.
    fn of(number: impl FnMut(usize) -> f32) -> Self;

    /// The number in a lane.
    fn lane(self, lane: usize) -> f32;

    /// Rows of four numbers, a row a lane, turned into four numbers a lane.
    fn of_rows(row: impl FnMut(usize) -> [f32; 4]) -> [Self; 4];

    /// The way back. Rows behind the last lane are nothing.
    fn to_rows(columns: [Self; 4]) -> [[f32; 4]; MOST_LANES];
    // ANCHOR_END: real

    /// Without its sign.
    #[must_use]
    fn abs(self) -> Self;

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The nearest whole number, halves to even.
    #[must_use]
    fn round(self) -> Self;

    /// The larger: `self` if it is, else `other`.
    #[must_use]
    fn max(self, other: Self) -> Self;

    /// The smaller: `self` if it is, else `other`.
    #[must_use]
    fn min(self, other: Self) -> Self;

    // ANCHOR: masks
    /// Where `self` is less than `other`.
    fn lt(self, other: Self) -> Self::Mask;

    /// Where it is less or the same.
    fn le(self, other: Self) -> Self::Mask;

    /// Where it is more.
    fn gt(self, other: Self) -> Self::Mask;

    /// Where it is the same.
    fn same(self, other: Self) -> Self::Mask;

    /// One where yes, the other where no.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// 1 where yes, 0 where no.
    #[must_use]
    fn ones(mask: Self::Mask) -> Self {
        Self::select(mask, Self::splat(1.0), Self::splat(0.0))
    }
    // ANCHOR_END: masks

    /// 1/x.
    #[must_use]
    fn recip(self) -> Self {
        Self::splat(1.0) / self
    }

    /// Between two bounds.
    #[must_use]
    fn clamp(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }
}

/// Yes or no in each lane.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// The same in each lane.
    fn splat(yes: bool) -> Self;

    /// Whether any lane says yes.
    fn any(self) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn splat(yes: bool) -> Self {
        yes
    }

    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

impl Real for f32 {
    type Mask = bool;

    const LANES: usize = 1;

    #[inline(always)]
    fn splat(number: f32) -> Self {
        number
    }

    #[inline(always)]
    fn of(mut number: impl FnMut(usize) -> f32) -> Self {
        number(0)
    }

    #[inline(always)]
    fn lane(self, _: usize) -> f32 {
        self
    }

    #[inline(always)]
    fn of_rows(mut row: impl FnMut(usize) -> [f32; 4]) -> [Self; 4] {
        row(0)
    }

    #[inline(always)]
    fn to_rows(columns: [Self; 4]) -> [[f32; 4]; MOST_LANES] {
        let mut rows = [[0.0; 4]; MOST_LANES];
        rows[0] = columns;
        rows
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f32::abs(self)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }

    #[inline(always)]
    fn round(self) -> Self {
        self.round_ties_even()
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn gt(self, other: Self) -> bool {
        self > other
    }

    #[inline(always)]
    fn same(self, other: Self) -> bool {
        self == other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

/// Lanes of a type of `wide`. Its comparisons give all bits of a lane or none.
macro_rules! lanes {
    ($wide:ty, $mask:ident, $count:literal, $of_rows:ident, $to_rows:ident) => {
        /// Yes or no in each lane: all bits or none.
        #[derive(Clone, Copy, Debug)]
        pub struct $mask($wide);

        impl BitAnd for $mask {
            type Output = Self;

            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl BitOr for $mask {
            type Output = Self;

            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl Not for $mask {
            type Output = Self;

            #[inline(always)]
            fn not(self) -> Self {
                Self(!self.0)
            }
        }

        impl Mask for $mask {
            #[inline(always)]
            fn splat(yes: bool) -> Self {
                Self(<$wide>::splat(f32::from_bits(if yes {
                    u32::MAX
                } else {
                    0
                })))
            }

            #[inline(always)]
            fn any(self) -> bool {
                self.0.any()
            }
        }

        impl Real for $wide {
            type Mask = $mask;

            const LANES: usize = $count;

            #[inline(always)]
            fn splat(number: f32) -> Self {
                <$wide>::splat(number)
            }

            #[inline(always)]
            fn of(mut number: impl FnMut(usize) -> f32) -> Self {
                let mut numbers = [0.0; $count];
                for (lane, place) in numbers.iter_mut().enumerate() {
                    *place = number(lane);
                }
                <$wide>::new(numbers)
            }

            #[inline(always)]
            fn lane(self, lane: usize) -> f32 {
                self.as_array()[lane]
            }

            #[inline(always)]
            fn of_rows(row: impl FnMut(usize) -> [f32; 4]) -> [Self; 4] {
                $of_rows(row)
            }

            #[inline(always)]
            fn to_rows(columns: [Self; 4]) -> [[f32; 4]; MOST_LANES] {
                $to_rows(columns)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                <$wide>::abs(self)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                <$wide>::sqrt(self)
            }

            #[inline(always)]
            fn round(self) -> Self {
                <$wide>::round_ties_even(self)
            }

            #[inline(always)]
            fn max(self, other: Self) -> Self {
                self.fast_max(other)
            }

            #[inline(always)]
            fn min(self, other: Self) -> Self {
                self.fast_min(other)
            }

            #[inline(always)]
            fn lt(self, other: Self) -> $mask {
                $mask(self.simd_lt(other))
            }

            #[inline(always)]
            fn le(self, other: Self) -> $mask {
                $mask(self.simd_le(other))
            }

            #[inline(always)]
            fn gt(self, other: Self) -> $mask {
                $mask(self.simd_gt(other))
            }

            #[inline(always)]
            fn same(self, other: Self) -> $mask {
                $mask(self.simd_eq(other))
            }

            #[inline(always)]
            fn select(mask: $mask, yes: Self, no: Self) -> Self {
                mask.0.select(yes, no)
            }
        }
    };
}

lanes!(f32x4, Mask4, 4, four_of_rows, four_to_rows);
lanes!(f32x8, Mask8, 8, eight_of_rows, eight_to_rows);

#[inline(always)]
fn four_of_rows(mut row: impl FnMut(usize) -> [f32; 4]) -> [Four; 4] {
    let (a, b, c, d) = (row(0), row(1), row(2), row(3));
    Four::transpose([Four::new(a), Four::new(b), Four::new(c), Four::new(d)])
}

#[inline(always)]
fn four_to_rows(columns: [Four; 4]) -> [[f32; 4]; MOST_LANES] {
    let [a, b, c, d] = Four::transpose(columns);
    let none = [0.0; 4];
    let (a, b, c, d) = (a.to_array(), b.to_array(), c.to_array(), d.to_array());
    [a, b, c, d, none, none, none, none]
}

#[inline(always)]
fn eight_of_rows(mut row: impl FnMut(usize) -> [f32; 4]) -> [Eight; 4] {
    let [a, b, c, d] = four_of_rows(&mut row);
    let [e, f, g, h] = four_of_rows(|lane| row(lane + 4));
    let both = |low: Four, high: Four| bytemuck::cast([low, high]);
    [both(a, e), both(b, f), both(c, g), both(d, h)]
}

#[inline(always)]
fn eight_to_rows([x, y, z, w]: [Eight; 4]) -> [[f32; 4]; MOST_LANES] {
    let halves = |eight: Eight| bytemuck::cast::<Eight, [Four; 2]>(eight);
    let ([x0, x1], [y0, y1], [z0, z1], [w0, w1]) = (halves(x), halves(y), halves(z), halves(w));
    let [a, b, c, d, ..] = four_to_rows([x0, y0, z0, w0]);
    let [e, f, g, h, ..] = four_to_rows([x1, y1, z1, w1]);
    [a, b, c, d, e, f, g, h]
}
