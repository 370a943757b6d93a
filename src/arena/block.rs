//! Owned arena memory for Rust users.

use alloc::vec::Vec;

use bytemuck::{Pod, Zeroable};

use super::View;

/// 64 bytes, aligned to 64.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C, align(64))]
struct Line([u8; 64]);

/// A zeroed, 64-byte aligned block of bytes.
#[derive(Clone)]
pub struct Block(Vec<Line>);

impl Block {
    /// `bytes` rounded up to whole lines, or `None` if there is no memory.
    pub fn zeroed(bytes: usize) -> Option<Self> {
        bytemuck::allocation::try_zeroed_vec(bytes.div_ceil(64)).ok().map(Self)
    }

    pub fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.0)
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        bytemuck::cast_slice_mut(&mut self.0)
    }

    /// The arena a build wrote here.
    pub fn view(&self) -> View<'_> {
        // SAFETY: `Scene` puts a block behind a view only after a build wrote it.
        unsafe { View::open_trusted(self.bytes()) }
    }
}
