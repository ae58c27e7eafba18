//! A number, or as many as the processor has lanes.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, Mul, MulAssign, Neg, Not, Sub, SubAssign};

use wide::{f32x4, f32x8};

/// Four lanes: what every 64-bit processor has.
pub type Four = f32x4;

/// Eight lanes: two instructions of four where the processor has no wider ones.
pub type Eight = f32x8;

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
// ANCHOR_END: real

impl Mask for bool {
    #[inline]
    fn splat(yes: bool) -> Self {
        yes
    }

    #[inline]
    fn any(self) -> bool {
        self
    }
}

impl Real for f32 {
    type Mask = bool;

    const LANES: usize = 1;

    #[inline]
    fn splat(number: f32) -> Self {
        number
    }

    #[inline]
    fn of(mut number: impl FnMut(usize) -> f32) -> Self {
        number(0)
    }

    #[inline]
    fn lane(self, _: usize) -> f32 {
        self
    }

    #[inline]
    fn abs(self) -> Self {
        f32::abs(self)
    }

    #[inline]
    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }

    #[inline]
    fn round(self) -> Self {
        self.round_ties_even()
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline]
    fn lt(self, other: Self) -> bool {
        self < other
    }

    #[inline]
    fn le(self, other: Self) -> bool {
        self <= other
    }

    #[inline]
    fn gt(self, other: Self) -> bool {
        self > other
    }

    #[inline]
    fn same(self, other: Self) -> bool {
        self == other
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

/// Lanes of a type of `wide`. Its comparisons give all bits of a lane or none.
macro_rules! lanes {
    ($wide:ty, $mask:ident, $count:literal) => {
        /// Yes or no in each lane: all bits or none.
        #[derive(Clone, Copy, Debug)]
        pub struct $mask($wide);

        impl BitAnd for $mask {
            type Output = Self;

            #[inline]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl BitOr for $mask {
            type Output = Self;

            #[inline]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl Not for $mask {
            type Output = Self;

            #[inline]
            fn not(self) -> Self {
                Self(!self.0)
            }
        }

        impl Mask for $mask {
            #[inline]
            fn splat(yes: bool) -> Self {
                Self(<$wide>::splat(f32::from_bits(if yes {
                    u32::MAX
                } else {
                    0
                })))
            }

            #[inline]
            fn any(self) -> bool {
                self.0.any()
            }
        }

        impl Real for $wide {
            type Mask = $mask;

            const LANES: usize = $count;

            #[inline]
            fn splat(number: f32) -> Self {
                <$wide>::splat(number)
            }

            #[inline]
            fn of(number: impl FnMut(usize) -> f32) -> Self {
                <$wide>::new(std::array::from_fn(number))
            }

            #[inline]
            fn lane(self, lane: usize) -> f32 {
                self.to_array()[lane]
            }

            #[inline]
            fn abs(self) -> Self {
                <$wide>::abs(self)
            }

            #[inline]
            fn sqrt(self) -> Self {
                <$wide>::sqrt(self)
            }

            #[inline]
            fn round(self) -> Self {
                <$wide>::round_ties_even(self)
            }

            #[inline]
            fn max(self, other: Self) -> Self {
                self.fast_max(other)
            }

            #[inline]
            fn min(self, other: Self) -> Self {
                self.fast_min(other)
            }

            #[inline]
            fn lt(self, other: Self) -> $mask {
                $mask(self.simd_lt(other))
            }

            #[inline]
            fn le(self, other: Self) -> $mask {
                $mask(self.simd_le(other))
            }

            #[inline]
            fn gt(self, other: Self) -> $mask {
                $mask(self.simd_gt(other))
            }

            #[inline]
            fn same(self, other: Self) -> $mask {
                $mask(self.simd_eq(other))
            }

            #[inline]
            fn select(mask: $mask, yes: Self, no: Self) -> Self {
                mask.0.select(yes, no)
            }
        }
    };
}

lanes!(f32x4, Mask4, 4);
lanes!(f32x8, Mask8, 8);
