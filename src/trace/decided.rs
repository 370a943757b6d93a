//! What was decided lately: a triangle in many voxels is decided once.

use super::counters::Count;
use crate::ray::NONE;

/// Numbers of triangles, by their low bits.
#[derive(Clone, Copy)]
pub(super) struct Decided([u32; 8]);

impl Decided {
    pub const NONE: Self = Self([NONE; 8]);

    /// Whether a triangle is still to be decided, as it now will be; each time where
    /// decisions are counted.
    #[inline(always)]
    pub fn is_due<C: Count>(&mut self, number: u32) -> bool {
        let entry = &mut self.0[number as usize % 8];
        core::mem::replace(entry, number) != number || C::COUNTS
    }
}
