//! Owned arena memory for Rust users.

use alloc::vec::Vec;

use super::View;
use super::layout::ALIGN;
use crate::simd::ask_for_large;

/// A block of bytes, zeroed at first and aligned to 64.
pub struct Block {
    /// With room to align: asked for more alignment than their own, allocators clear
    /// memory that is zero already, which takes as long as a pass of the build.
    memory: Vec<u8>,
    len: usize,
}

impl Block {
    /// `bytes` bytes, or `None` if there is no memory.
    pub fn zeroed(bytes: usize) -> Option<Self> {
        let size = bytes.checked_add(ALIGN)?;
        let memory: Vec<u8> = bytemuck::allocation::try_zeroed_vec(size).ok()?;
        ask_for_large(memory.as_ptr(), memory.len());
        Some(Self { memory, len: bytes })
    }

    fn start(&self) -> usize {
        self.memory.as_ptr().align_offset(ALIGN)
    }

    pub fn bytes(&self) -> &[u8] {
        &self.memory[self.start()..][..self.len]
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        let start = self.start();
        &mut self.memory[start..][..self.len]
    }

    /// The arena a build wrote here.
    pub fn view(&self) -> View<'_> {
        // SAFETY: `Scene` puts a block behind a view only after a build wrote it.
        unsafe { View::open_trusted(self.bytes()) }
    }
}

impl Clone for Block {
    fn clone(&self) -> Self {
        let mut memory: Vec<u8> = Vec::with_capacity(self.memory.len());
        let start = memory.as_ptr().align_offset(ALIGN);
        memory.resize(start, 0);
        memory.extend_from_slice(self.bytes());
        Self { memory, len: self.len }
    }
}
