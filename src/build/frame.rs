//! Grids as boxes cut into voxels: how many along each axis, and where.
//!
//! Boxes are grown by 2^-12 of their sides so that what lies in them lies
//! inside by more than the walk's error (`trace::local`), and by 2^-32 of the
//! largest coordinate so that flat ones have a size. A cell is then never
//! smaller than 2^-35 of a coordinate. A voxel that becomes a grid of its own is
//! grown by 2^-10 of it, the bound of the walk's error in the grid above.

use super::turn;
use crate::aabb::Aabb;
use crate::arena::layout;
use crate::math::{cbrt, sqrt};
use crate::options::{Gridding, MAX_COUNT};
use bytemuck::{Pod, Zeroable};

/// Growth of a voxel's box, in voxels, before it becomes a grid of its own.
const VOXEL_MARGIN: f64 = 1.0 / 1024.0;

/// A grid while it is built: the arena's record in the scene's coordinates and in
/// full precision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Grid {
    /// Lowest corner of the box.
    pub lo: [f64; 3],
    /// Sides of the box, `n * cell`.
    pub extent: [f64; 3],
    /// Sides of a voxel.
    pub cell: [f64; 3],
    /// `1 / cell`.
    pub inv_cell: [f64; 3],
    /// Voxels along each axis, 1 to 2048.
    pub n: [u32; 3],
    /// Level of the hierarchy; 0 is the deepest.
    pub level: u32,
    /// Number of the first voxel.
    pub first: u32,
    /// [`layout::COVERS`] if made by [`Grid::inside`]; [`layout::TURNED`] if in coordinates
    /// of its own (`turn`).
    pub flags: u32,
    /// No side of a voxel is smaller: [`least_cell`] of the scene, or what `turn` asks for.
    pub least: f64,
}

/// How to choose voxel counts.
#[derive(Clone, Copy)]
pub struct Rule {
    pub gridding: Gridding,
    pub alpha: f32,
    /// The power that overlap numbers act with.
    pub power: f32,
    /// Counts that were asked for, or zeros.
    pub counts: [u32; 3],
    /// What counts are multiplied with along each axis, give or take a factor for all,
    /// where the gridding looks at overlap numbers; ones elsewhere.
    pub weights: [f64; 3],
}

impl Grid {
    /// A grid of one voxel over a box of objects, in a scene of box `scene`.
    pub(super) fn around(b: &Aabb, level: u32, scene: &Aabb) -> Self {
        let least = least_cell(scene);
        let side: [f64; 3] = core::array::from_fn(|k| f64::from(b.hi[k]) - f64::from(b.lo[k]));
        let longest = side[0].max(side[1]).max(side[2]);
        let margin: [f64; 3] = core::array::from_fn(|k| {
            let far = f64::from(b.lo[k].abs().max(b.hi[k].abs()));
            let thin = if side[k] == 0.0 { longest / f64::from(1 << 20) } else { 0.0 };
            side[k] / 4096.0 + far / f64::from(1u32 << 31) / 2.0 + thin + least
        });
        let lo = core::array::from_fn(|k| f64::from(b.lo[k]) - margin[k]);
        let side = core::array::from_fn(|k| side[k] + 2.0 * margin[k]);
        Self { lo, least, level, ..Self::default() }.cut(side, [1; 3])
    }

    /// A grid of one voxel over voxel `at` of this one.
    pub(super) fn inside(&self, at: [u32; 3], level: u32) -> Self {
        let lo = |k: usize| self.lo[k] + (f64::from(at[k]) - VOXEL_MARGIN) * self.cell[k];
        let side = self.cell.map(|c| c * (1.0 + 2.0 * VOXEL_MARGIN));
        Self { lo: core::array::from_fn(lo), level, flags: u32::from(layout::COVERS), ..*self }
            .cut(side, [1; 3])
    }

    /// The same box with the counts that `rule` gives for `objects` objects.
    pub(super) fn divided(&self, rule: &Rule, objects: usize) -> Self {
        let n =
            if rule.counts == [0; 3] { counts(&self.extent, rule, objects) } else { rule.counts };
        // Keeps `cell >= 2^-35 |lo|`, on which the walk's error bound rests, and
        // its speeds in the range of f32.
        let room = if self.is_turned() { turn::MOST } else { MAX_COUNT };
        let n = core::array::from_fn(|k| {
            let far = self.lo[k].abs().max((self.lo[k] + self.extent[k]).abs());
            let most = (self.extent[k] * f64::from(1u32 << 31) * 8.0 / far)
                .min(self.extent[k] / self.least);
            n[k].min((most as u32).max(1)).min(room)
        });
        self.cut(self.extent, n)
    }

    /// The same box with half the counts.
    pub(super) fn coarser(&self) -> Self {
        self.cut(self.extent, self.n.map(|n| n.div_ceil(2)))
    }

    /// This grid with sides `side` cut into `n`.
    fn cut(&self, side: [f64; 3], n: [u32; 3]) -> Self {
        let cell: [f64; 3] = core::array::from_fn(|k| side[k] / f64::from(n[k]));
        Self {
            cell,
            inv_cell: cell.map(|c| 1.0 / c),
            extent: core::array::from_fn(|k| f64::from(n[k]) * cell[k]),
            n,
            ..*self
        }
    }

    /// Whether it is in coordinates of its own.
    pub fn is_turned(&self) -> bool {
        self.flags & u32::from(layout::TURNED) != 0
    }

    /// Number of voxels; no overflow for counts in range.
    pub fn voxels(&self) -> u64 {
        self.n.iter().map(|&n| u64::from(n)).product()
    }

    /// The arena's record of this grid.
    pub(super) fn record(&self, unit: f64) -> layout::Grid {
        layout::Grid {
            lo: self.lo.map(|x| x * unit),
            inv_cell: self.inv_cell.map(|x| (x / unit) as f32),
            cell: self.cell.map(|x| (x * unit) as f32),
            n: self.n.map(|n| n as u16),
            level: self.level as u8,
            flags: self.flags as u8,
            first: self.first,
            walks: 1,
        }
    }
}

/// The longest side of a grid around a box, give or take a part in 1000.
fn longest(b: &Aabb) -> f64 {
    let side = |k: usize| f64::from(b.hi[k]) - f64::from(b.lo[k]);
    let far = |k: usize| f64::from(b.lo[k].abs().max(b.hi[k].abs()));
    (0..3).map(|k| side(k).max(far(k) / f64::from(1u32 << 31))).fold(0.0, f64::max)
}

/// 2^-79 of the longest side: detail that no scene needs, and whose reciprocal is
/// in the range of `f32` by far.
fn least_cell(scene: &Aabb) -> f64 {
    longest(scene) / (1u128 << 79) as f64
}

/// The power of two that brings the longest side of a box to `[1, 2)`.
pub fn unit(scene: &Aabb) -> f64 {
    // The exponent's bits alone: every f32 is a normal f64.
    let power = f64::from_bits(longest(scene).to_bits() & (0x7ff << 52));
    // An empty scene's is infinite.
    if power > 0.0 && power < f64::INFINITY { 1.0 / power } else { 1.0 }
}

/// Voxels per axis, rounded to the nearest; an axis along which the box is
/// flat (less than 2^-12 of the longest side) is not cut.
fn counts(side: &[f64; 3], rule: &Rule, objects: usize) -> [u32; 3] {
    let longest = side[0].max(side[1]).max(side[2]);
    let mut open: [bool; 3] = core::array::from_fn(|k| side[k] > longest / 4096.0);
    let alpha = f64::from(rule.alpha);
    let target = alpha * alpha * alpha * objects as f64;
    let round = |x: f64| ((x + 0.5) as u32).clamp(1, MAX_COUNT);
    if rule.gridding == Gridding::Homogeneous {
        return open.map(|open| if open { round(cbrt(target)) } else { 1 });
    }
    // By the sides, unless the weights say it all.
    let sides = rule.gridding == Gridding::Proportional;
    let shape: [f64; 3] =
        core::array::from_fn(|k| if sides { side[k] / longest } else { rule.weights[k] });
    // An axis whose share is below one voxel gets one and leaves the rest to
    // the others, so that the product stays near the target.
    loop {
        let axes = (0..3).filter(|&k| open[k]);
        let (count, product) = axes.fold((0, 1.0), |(c, p), k| (c + 1, p * shape[k]));
        let density = match count {
            0 => return [1; 3],
            1 => target / product,
            2 => sqrt(target / product),
            _ => cbrt(target / product),
        };
        let share: [f64; 3] = core::array::from_fn(|k| density * shape[k]);
        match (0..3)
            .filter(|&k| open[k] && share[k] < 1.0)
            .min_by(|&a, &b| share[a].total_cmp(&share[b]))
        {
            Some(k) => open[k] = false,
            None => return core::array::from_fn(|k| if open[k] { round(share[k]) } else { 1 }),
        }
    }
}
