//! A list with room for N items, which lives where it is declared: the narrow phase runs for every
//! pair in every step, and never asks for memory.

use std::fmt;
use std::ops::{Deref, DerefMut};

/// Up to N items. Reads as a slice.
#[derive(Clone, Copy)]
pub struct List<T, const N: usize> {
    items: [T; N],
    count: usize,
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// These items.
    ///
    /// # Panics
    /// If they are more than N.
    #[must_use]
    pub fn of(items: &[T]) -> Self {
        let mut list = Self::default();
        list.items[..items.len()].copy_from_slice(items);
        list.count = items.len();
        list
    }

    /// Adds an item at the end.
    ///
    /// # Panics
    /// If there are N already.
    pub fn push(&mut self, item: T) {
        self.items[self.count] = item;
        self.count += 1;
    }

    /// Adds an item at the end, unless there are N already.
    pub fn push_if_room(&mut self, item: T) {
        if !self.is_full() {
            self.push(item);
        }
    }

    /// Whether there is no room for another.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.count == N
    }

    /// Keeps the items for which `wanted` holds, in order.
    pub fn retain(&mut self, wanted: impl Fn(&T) -> bool) {
        let mut kept = 0;
        for i in 0..self.count {
            if wanted(&self.items[i]) {
                self.items[kept] = self.items[i];
                kept += 1;
            }
        }
        self.count = kept;
    }

    /// Takes the item at `i` out; those behind it move up.
    pub fn remove(&mut self, i: usize) {
        self.items.copy_within(i + 1..self.count, i);
        self.count -= 1;
    }

    /// Takes the item at `i` out and puts the last one there.
    pub fn swap_remove(&mut self, i: usize) {
        self.count -= 1;
        self.items[i] = self.items[self.count];
    }
}

impl<T: Copy + Default, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self {
            items: [T::default(); N],
            count: 0,
        }
    }
}

impl<T, const N: usize> Deref for List<T, N> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items[..self.count]
    }
}

impl<T, const N: usize> DerefMut for List<T, N> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.count]
    }
}

impl<T: PartialEq, const N: usize> PartialEq for List<T, N> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: fmt::Debug, const N: usize> fmt::Debug for List<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}
