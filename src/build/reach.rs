//! How far a block of voxels reaches from one voxel in it, in eight bytes.

use bytemuck::{Pod, Zeroable};

use super::grow::Block;
use crate::arena::layout::{EXIT_BITS, EXIT_MAX};

/// One byte each for -x, +x, -y, +y, -z, +z. A face on the grid's border has
/// [`BORDER`] added: nothing is lost by not reaching further.
#[derive(Clone, Copy, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct Reach(u64);

/// Above any reach, and more than can be told apart from it by adding reaches.
const BORDER: u64 = 0x40;
/// Marks the block of a voxel with a list.
const LISTED: u64 = 1 << 48;
const ONES: u64 = 0x0101_0101_0101;

/// A voxel with a list grows a box of its own where that of the voxel before it
/// reaches less far than this beyond that one.
const LEFT: u64 = 3;

impl Reach {
    /// The block of a voxel that shares none.
    pub const NONE: Self = Self(0);

    /// From voxel `at`, in a grid of `n` voxels; `listed` if it has a list.
    pub fn new(block: &Block, at: [usize; 3], n: [usize; 3], listed: bool) -> Self {
        let mut bytes = if listed { LISTED } else { 0 };
        for k in 0..3 {
            let down = (at[k] - block.lo[k]) as u64 + if block.lo[k] == 0 { BORDER } else { 0 };
            let up =
                (block.hi[k] - 1 - at[k]) as u64 + if block.hi[k] == n[k] { BORDER } else { 0 };
            bytes |= (down | up << 8) << (16 * k);
        }
        Self(bytes)
    }

    /// The same block from the next voxel along axis `K`, if that is in it and
    /// the block reaches at least `room - 1` from there, or to the border, on all
    /// sides.
    #[inline(always)]
    pub fn next<const K: usize>(self, room: usize) -> Option<Self> {
        const HIGH: u64 = 0x80 * ONES;
        let inside = self.0 >> (16 * K + 8) & 0x7f != 0;
        let moved = self.0.wrapping_add(1 << (16 * K)).wrapping_sub(1 << (16 * K + 8));
        let short = !(moved | HIGH).wrapping_sub(ONES * (room as u64 - 1)) & HIGH;
        (inside && short == 0 && self.0 & LISTED == 0).then_some(Self(moved))
    }

    /// The same block, of a voxel with a list, from the next voxel along axis `K`,
    /// unless that is near the block's end.
    #[inline(always)]
    pub fn next_listed<const K: usize>(self) -> Option<Self> {
        let left = self.0 >> (16 * K + 8) & 0x7f;
        let moved = self.0.wrapping_add(1 << (16 * K)).wrapping_sub(1 << (16 * K + 8));
        (left >= LEFT && self.0 & LISTED != 0).then_some(Self(moved))
    }

    /// The arena's form, cut to what that can hold.
    #[inline(always)]
    pub fn encode(self) -> u32 {
        let most = ONES * u64::from(EXIT_MAX);
        let beyond = (self.0 >> EXIT_BITS & ONES) * u64::from(EXIT_MAX);
        let all = (self.0 | beyond) & most;
        let pairs = all & 0x001f_001f_001f | all >> (8 - EXIT_BITS) & 0x03e0_03e0_03e0;
        (pairs & 0x3ff | pairs >> 6 & 0x3ff << 10 | pairs >> 12 & 0x3ff << 20) as u32
    }
}
