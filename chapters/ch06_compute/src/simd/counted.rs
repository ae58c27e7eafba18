//! A number that counts what is computed with it.

use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{MOST_LANES, Real};

/// What was done in all lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Additions, subtractions, multiplications, divisions, square roots and roundings.
    pub arithmetic: u64,
    /// Comparisons, and what is chosen by them; signs.
    pub choices: u64,
}

thread_local! {
    static DONE: Cell<Work> = const { Cell::new(Work { arithmetic: 0, choices: 0 }) };
}

/// What this thread did since this was last asked.
#[must_use]
pub fn done() -> Work {
    DONE.take()
}

// ANCHOR: counted
/// A number that counts: every formula over a [`Real`] can be run over it, and has the same bits.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counted<R>(R);

/// An operation in each lane.
fn computed<R: Real>(number: R) -> Counted<R> {
    let mut work = DONE.get();
    work.arithmetic += R::LANES as u64;
    DONE.set(work);
    Counted(number)
}

/// A choice in each lane.
fn chosen<R: Real, T>(outcome: T) -> T {
    let mut work = DONE.get();
    work.choices += R::LANES as u64;
    DONE.set(work);
    outcome
}

impl<R: Real> Mul for Counted<R> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        computed(self.0 * other.0)
    }
}
// ANCHOR_END: counted

impl<R: Real> Add for Counted<R> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        computed(self.0 + other.0)
    }
}

impl<R: Real> Sub for Counted<R> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        computed(self.0 - other.0)
    }
}

impl<R: Real> Div for Counted<R> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        computed(self.0 / other.0)
    }
}

impl<R: Real> Neg for Counted<R> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(chosen::<R, _>(-self.0))
    }
}

impl<R: Real> AddAssign for Counted<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> SubAssign for Counted<R> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<R: Real> MulAssign for Counted<R> {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<R: Real> Real for Counted<R> {
    type Mask = R::Mask;

    const LANES: usize = R::LANES;

    fn splat(number: f32) -> Self {
        Self(R::splat(number))
    }

    fn of(number: impl FnMut(usize) -> f32) -> Self {
        Self(R::of(number))
    }

    fn lane(self, lane: usize) -> f32 {
        self.0.lane(lane)
    }

    fn of_rows(row: impl FnMut(usize) -> [f32; 4]) -> [Self; 4] {
        R::of_rows(row).map(Self)
    }

    fn to_rows(columns: [Self; 4]) -> [[f32; 4]; MOST_LANES] {
        R::to_rows(columns.map(|column| column.0))
    }

    fn abs(self) -> Self {
        Self(chosen::<R, _>(self.0.abs()))
    }

    fn sqrt(self) -> Self {
        computed(self.0.sqrt())
    }

    fn round(self) -> Self {
        computed(self.0.round())
    }

    fn max(self, other: Self) -> Self {
        Self(chosen::<R, _>(self.0.max(other.0)))
    }

    fn min(self, other: Self) -> Self {
        Self(chosen::<R, _>(self.0.min(other.0)))
    }

    fn lt(self, other: Self) -> R::Mask {
        chosen::<R, _>(self.0.lt(other.0))
    }

    fn le(self, other: Self) -> R::Mask {
        chosen::<R, _>(self.0.le(other.0))
    }

    fn gt(self, other: Self) -> R::Mask {
        chosen::<R, _>(self.0.gt(other.0))
    }

    fn same(self, other: Self) -> R::Mask {
        chosen::<R, _>(self.0.same(other.0))
    }

    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self(chosen::<R, _>(R::select(mask, yes.0, no.0)))
    }
}
