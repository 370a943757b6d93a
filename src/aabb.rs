//! Axis-aligned boxes of triangles.

use bytemuck::{Pod, Zeroable};

use glam::{DVec3, Vec3A};

/// A box, by its lowest and highest corner. Empty if inverted.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Aabb {
    pub lo: [f32; 3],
    pub hi: [f32; 3],
}

impl Aabb {
    pub const EMPTY: Self = Self { lo: [f32::INFINITY; 3], hi: [f32::NEG_INFINITY; 3] };

    /// The box of a triangle. Zeros are positive: which of two zeros is the lesser
    /// depends on the instruction set.
    #[inline(always)]
    pub fn of(corners: &[[f32; 3]; 3]) -> Self {
        let [a, b, c] = corners.map(Vec3A::from_array);
        let (lo, hi) = (a.min(b).min(c) + Vec3A::ZERO, a.max(b).max(c) + Vec3A::ZERO);
        Self { lo: lo.to_array(), hi: hi.to_array() }
    }

    pub fn join(&mut self, other: &Self) {
        self.lo = core::array::from_fn(|k| self.lo[k].min(other.lo[k]));
        self.hi = core::array::from_fn(|k| self.hi[k].max(other.hi[k]));
    }

    /// The length of an object in the sense of section 1.3: its box's diagonal.
    pub fn diagonal(&self) -> f64 {
        let corner = |c: [f32; 3]| DVec3::from_array(c.map(f64::from));
        (corner(self.hi) - corner(self.lo)).length()
    }
}
