//! A stack of words whose memory is not cleared first: that would take longer than a short
//! descent does.
//!
//! # Safety
//! The first `len` words have been written, by `push` and `insert` alone, which `len` counts.

use core::mem::MaybeUninit;

/// Room for `N` words.
pub struct Room<const N: usize>([MaybeUninit<i64>; N]);

impl<const N: usize> Room<N> {
    #[inline(always)]
    pub fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; N])
    }
}

/// Up to `N` words. Their number is apart from them, so that it can be in a register.
pub struct Stack<'r, const N: usize> {
    words: &'r mut [MaybeUninit<i64>; N],
    len: usize,
}

impl<'r, const N: usize> Stack<'r, N> {
    /// None yet.
    #[inline(always)]
    pub fn new(room: &'r mut Room<N>) -> Self {
        Self { words: &mut room.0, len: 0 }
    }

    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Puts a word on top; one that there is no room for is lost.
    #[inline(always)]
    pub fn push(&mut self, word: i64) {
        if let Some(slot) = self.words.get_mut(self.len) {
            slot.write(word);
            self.len += 1;
        }
    }

    /// Puts a word among those from number `base` on, which descend to the top, at its place;
    /// one that there is no room for is lost.
    #[inline(always)]
    pub fn insert(&mut self, base: usize, word: i64) {
        if self.len >= N {
            return;
        }
        let mut at = self.len;
        while at > base {
            // SAFETY: `at` is no more than `len`, so the word below is written.
            let below = unsafe { self.words[at - 1].assume_init() };
            if below >= word {
                break;
            }
            self.words[at].write(below);
            at -= 1;
        }
        self.words[at].write(word);
        self.len += 1;
    }

    /// Takes the word on top.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<i64> {
        self.len = self.len.checked_sub(1)?;
        // SAFETY: it was one of the first `len` words.
        Some(unsafe { self.words[self.len].assume_init() })
    }
}
