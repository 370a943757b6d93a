//! Rays and triangles that may meet, paired off regardless of which ray it is.

use super::columns::SLOTS;

/// Pairs of a slot and a triangle's number. Each triangle in the array is one of the scene's,
/// or 0, also behind the last pair: rows of eight are read, and their triangles looked up
/// unchecked. So what is written is what [`Lanes::compress`](crate::simd::Lanes::compress)
/// makes of references to triangles.
pub(super) struct Pairs {
    slots: [u32; Self::ROOM],
    triangles: [u32; Self::ROOM],
    /// How many there are.
    pub len: usize,
}

impl Pairs {
    /// How many there may be.
    pub const MOST: usize = 256;
    /// Eight are written at a time.
    const ROOM: usize = Self::MOST + 8;

    pub const NONE: Self = Self { slots: [0; Self::ROOM], triangles: [0; Self::ROOM], len: 0 };

    /// Pair `i`.
    #[inline(always)]
    pub fn get(&self, i: usize) -> (usize, u32) {
        let i = i % Self::MOST;
        // The remainder spares a test where slots are looked up.
        (self.slots[i] as usize % SLOTS, self.triangles[i])
    }

    /// Slots and triangles from pair `i` on; behind the last, any that were there before.
    #[inline(always)]
    pub fn eight(&self, i: usize) -> [&[u32; 8]; 2] {
        let i = i % Self::MOST;
        [&self.slots, &self.triangles].map(|a| a[i..].first_chunk().expect("room for eight"))
    }

    /// Where slots and triangles are written from pair `i` on.
    #[inline(always)]
    pub fn eight_mut(&mut self, i: usize) -> [&mut [u32; 8]; 2] {
        let i = i % Self::MOST;
        [&mut self.slots, &mut self.triangles]
            .map(|a| a[i..].first_chunk_mut().expect("room for eight"))
    }
}
