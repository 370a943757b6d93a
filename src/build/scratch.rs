//! The build's working memory: slices cut from the caller's scratch block.

use bytemuck::Pod;

use crate::Error;

/// What is left of a block of scratch memory.
pub struct Scratch<'s>(&'s mut [u8]);

impl<'s> Scratch<'s> {
    pub fn new(block: &'s mut [u8]) -> Self {
        Self(block)
    }

    /// All of what is left, for a while.
    pub fn rest(&mut self) -> Scratch<'_> {
        Scratch(self.0)
    }

    /// Cuts off `count` records with whatever bytes they hold.
    pub fn take<T: Pod>(&mut self, count: usize) -> Result<&'s mut [T], Error> {
        let bytes = count.checked_mul(size_of::<T>()).ok_or(Error::Overflow)?;
        let block = core::mem::take(&mut self.0);
        let skip = block.as_ptr().align_offset(align_of::<T>());
        let end = skip.checked_add(bytes).ok_or(Error::Overflow)?;
        if end > block.len() {
            return Err(Error::BufferTooSmall);
        }
        let (head, rest) = block.split_at_mut(end);
        self.0 = rest;
        bytemuck::try_cast_slice_mut(&mut head[skip..]).map_err(|_| Error::Alignment)
    }
}

/// Cuts off the first `count` records.
pub fn cut<'a, T>(rest: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (head, tail) = core::mem::take(rest).split_at_mut(count);
    *rest = tail;
    head
}
