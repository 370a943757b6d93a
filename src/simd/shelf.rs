//! Records one after the other, whose memory is not cleared first: that would take longer than
//! what is done with a few of them.
//!
//! # Safety
//! The first `len` records have been written, by `place` alone, which `len` counts.

use core::mem::MaybeUninit;
use core::ops::{Index, IndexMut};

/// Room for `N` records, of which there are some.
pub struct Shelf<T: Copy, const N: usize> {
    records: [MaybeUninit<T>; N],
    len: usize,
}

impl<T: Copy, const N: usize> Shelf<T, N> {
    /// None yet.
    #[inline(always)]
    pub fn new() -> Self {
        Self { records: [const { MaybeUninit::uninit() }; N], len: 0 }
    }

    /// Record `i`, no more than one behind the last, where it is new, and `none`. Where there is no
    /// room for that, the last.
    #[inline(always)]
    pub fn place(&mut self, i: usize, none: &T) -> &mut T {
        let i = i.min(self.len).min(N - 1);
        if i == self.len {
            self.records[i].write(*none);
            self.len += 1;
        }
        &mut self.all_mut()[i]
    }

    /// All that there are.
    #[inline(always)]
    pub fn all(&self) -> &[T] {
        // SAFETY: `len` records are written, of the `N` that there is room for.
        unsafe { core::slice::from_raw_parts(self.records.as_ptr().cast(), self.len) }
    }

    #[inline(always)]
    fn all_mut(&mut self) -> &mut [T] {
        // SAFETY: likewise, and nothing else refers to them.
        unsafe { core::slice::from_raw_parts_mut(self.records.as_mut_ptr().cast(), self.len) }
    }
}

impl<T: Copy, const N: usize> Index<usize> for Shelf<T, N> {
    type Output = T;
    #[inline(always)]
    fn index(&self, i: usize) -> &T {
        &self.all()[i]
    }
}

impl<T: Copy, const N: usize> IndexMut<usize> for Shelf<T, N> {
    #[inline(always)]
    fn index_mut(&mut self, i: usize) -> &mut T {
        &mut self.all_mut()[i]
    }
}
