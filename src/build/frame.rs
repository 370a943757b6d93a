//! Grids as boxes cut into voxels: how many along each axis, and where.
//!
//! Boxes are grown by 2^-12 of their sides so that what lies in them lies
//! inside by more than the walk's error (`trace::local`), and by 2^-32 of the
//! largest coordinate so that flat ones have a size. A cell is then never
//! smaller than 2^-35 of a coordinate.

use crate::aabb::Aabb;
use crate::arena::layout::Grid;
use crate::math::{cbrt, sqrt};
use crate::options::{Gridding, MAX_COUNT};

/// Growth of a voxel's box, in voxels, before it becomes a grid of its own.
const VOXEL_MARGIN: f64 = 1.0 / 4096.0;

/// How to choose voxel counts.
#[derive(Clone, Copy)]
pub struct Rule {
    pub gridding: Gridding,
    pub alpha: f32,
    /// Counts that were asked for, or zeros.
    pub counts: [u32; 3],
}

impl Grid {
    /// A grid of one voxel over a box of objects.
    pub(super) fn around(b: &Aabb, level: u32) -> Self {
        let side: [f64; 3] = core::array::from_fn(|k| f64::from(b.hi[k]) - f64::from(b.lo[k]));
        let longest = side[0].max(side[1]).max(side[2]);
        let margin: [f64; 3] = core::array::from_fn(|k| {
            let far = f64::from(b.lo[k].abs().max(b.hi[k].abs()));
            let thin = if side[k] == 0.0 { longest / f64::from(1 << 20) } else { 0.0 };
            side[k] / 4096.0 + far / f64::from(1u32 << 31) / 2.0 + thin
        });
        let lo = core::array::from_fn(|k| f64::from(b.lo[k]) - margin[k]);
        Self::over(lo, core::array::from_fn(|k| side[k] + 2.0 * margin[k]), [1; 3], level)
    }

    /// A grid of one voxel over voxel `at` of this one.
    pub(super) fn inside(&self, at: [u32; 3], level: u32) -> Self {
        let lo = |k: usize| self.lo[k] + (f64::from(at[k]) - VOXEL_MARGIN) * self.cell[k];
        let side = self.cell.map(|c| c * (1.0 + 2.0 * VOXEL_MARGIN));
        Self::over(core::array::from_fn(lo), side, [1; 3], level)
    }

    /// The same box with the counts that `rule` gives for `objects` objects.
    pub(super) fn divided(&self, rule: &Rule, objects: usize) -> Self {
        let n =
            if rule.counts == [0; 3] { counts(&self.extent, rule, objects) } else { rule.counts };
        // Keeps `cell >= 2^-35 |lo|`, on which the walk's error bound rests.
        let n = core::array::from_fn(|k| {
            let far = self.lo[k].abs().max((self.lo[k] + self.extent[k]).abs());
            let most = self.extent[k] * f64::from(1u32 << 31) * 8.0 / far;
            n[k].min((most as u32).max(1))
        });
        Self::over(self.lo, self.extent, n, self.level)
    }

    /// The same box with half the counts.
    pub(super) fn coarser(&self) -> Self {
        Self::over(self.lo, self.extent, self.n.map(|n| n.div_ceil(2)), self.level)
    }

    fn over(lo: [f64; 3], side: [f64; 3], n: [u32; 3], level: u32) -> Self {
        let cell: [f64; 3] = core::array::from_fn(|k| side[k] / f64::from(n[k]));
        Self {
            lo,
            cell,
            inv_cell: cell.map(|c| 1.0 / c),
            extent: core::array::from_fn(|k| f64::from(n[k]) * cell[k]),
            n,
            level,
            first: 0,
            walks: 1,
            zero: 0.0,
        }
    }
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
    // An axis whose share is below one voxel gets one and leaves the rest to
    // the others, so that the product stays near the target.
    loop {
        let axes = (0..3).filter(|&k| open[k]);
        let (count, product) = axes.fold((0, 1.0), |(c, p), k| (c + 1, p * (side[k] / longest)));
        let density = match count {
            0 => return [1; 3],
            1 => target / product,
            2 => sqrt(target / product),
            _ => cbrt(target / product),
        };
        let share: [f64; 3] = core::array::from_fn(|k| density * (side[k] / longest));
        match (0..3)
            .filter(|&k| open[k] && share[k] < 1.0)
            .min_by(|&a, &b| share[a].total_cmp(&share[b]))
        {
            Some(k) => open[k] = false,
            None => return core::array::from_fn(|k| if open[k] { round(share[k]) } else { 1 }),
        }
    }
}
