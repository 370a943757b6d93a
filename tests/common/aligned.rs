//! Memory at an address that is a multiple of 64, as arenas need it.

use std::ops::{Deref, DerefMut};

#[derive(Clone, Copy)]
#[repr(C, align(64))]
struct Line([u8; 64]);

/// A block of bytes whose length need not be a multiple of anything.
#[derive(Clone)]
pub struct Aligned {
    lines: Vec<Line>,
    len: usize,
}

impl Aligned {
    pub fn filled(len: usize, byte: u8) -> Self {
        let lines = vec![Line([byte; 64]); len.div_ceil(64)];
        Self { lines, len }
    }

    pub fn copy(bytes: &[u8]) -> Self {
        let mut block = Self::filled(bytes.len(), 0);
        block.copy_from_slice(bytes);
        block
    }
}

impl Deref for Aligned {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        // SAFETY: the lines hold `len` bytes or more, without padding.
        unsafe { std::slice::from_raw_parts(self.lines.as_ptr().cast(), self.len) }
    }
}

impl DerefMut for Aligned {
    fn deref_mut(&mut self) -> &mut [u8] {
        // SAFETY: as above, borrowed mutably.
        unsafe { std::slice::from_raw_parts_mut(self.lines.as_mut_ptr().cast(), self.len) }
    }
}
