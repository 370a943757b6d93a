//! Memory aligned to 64 that ends where it says, so that a sanitizer sees a byte more.

use std::alloc::{Layout, alloc_zeroed, dealloc, handle_alloc_error};

pub struct Block {
    start: *mut u8,
    layout: Layout,
    len: usize,
}

impl Block {
    pub fn zeroed(len: usize) -> Self {
        let layout = Layout::from_size_align(len.max(1), 64).expect("a size that fits");
        // SAFETY: the size is not 0.
        let start = unsafe { alloc_zeroed(layout) };
        if start.is_null() {
            handle_alloc_error(layout);
        }
        Self { start, layout, len }
    }

    pub fn copy(bytes: &[u8]) -> Self {
        let mut block = Self::zeroed(bytes.len());
        block.bytes_mut().copy_from_slice(bytes);
        block
    }

    pub fn bytes(&self) -> &[u8] {
        // SAFETY: owned and initialised.
        unsafe { std::slice::from_raw_parts(self.start, self.len) }
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        // SAFETY: as above, borrowed mutably.
        unsafe { std::slice::from_raw_parts_mut(self.start, self.len) }
    }
}

impl Drop for Block {
    fn drop(&mut self) {
        // SAFETY: allocated with this layout.
        unsafe { dealloc(self.start, self.layout) };
    }
}
