//! Voxels by the number of triangles they refer to (figures 13, 15, 16, 18, 19).

use crate::arena::View;
use crate::simd::fpenv;

/// How full the voxels of a level are, or those of all levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Occupancy {
    /// Voxels.
    pub voxels: u64,
    /// Most triangles that one of them refers to.
    pub most: u64,
}

impl Occupancy {
    /// Counts the voxels of `level`, or with `None` of all levels: `counts[i]`
    /// becomes the number of those that refer to `i` triangles, and the last
    /// element also counts those that refer to more. Nothing is counted for a level
    /// that the scene does not have. Cost: linear in the arena; no allocation.
    pub fn count(view: &View<'_>, level: Option<usize>, counts: &mut [u64]) -> Self {
        counts.fill(0);
        let mut seen = Self::default();
        let last = counts.len().saturating_sub(1);
        for grid in view.grids() {
            if level.is_some_and(|level| level != usize::from(grid.level)) {
                continue;
            }
            seen.voxels += grid.voxels();
            let first = grid.first as usize;
            for voxel in first..first + grid.voxels() as usize {
                let (objects, _) = view.sections().counts(voxel);
                seen.most = seen.most.max(objects);
                if let Some(count) = counts.get_mut(last.min(objects as usize)) {
                    *count += 1;
                }
            }
        }
        seen
    }

    /// The whole histogram: as [`Occupancy::count`], up to the fullest voxel.
    #[cfg(feature = "alloc")]
    #[must_use]
    pub fn histogram(view: &View<'_>, level: Option<usize>) -> alloc::vec::Vec<u64> {
        let most = Self::count(view, level, &mut []).most;
        let mut counts = alloc::vec![0; most as usize + 1];
        Self::count(view, level, &mut counts);
        counts
    }
}

/// The cumulated distribution of a histogram: `percent[i]` becomes the
/// percentage of `whole` that `counts[..=i]` holds, zeros if `whole` is 0. As many
/// elements are written as both slices have.
pub fn cumulated(counts: &[u64], whole: u64, percent: &mut [f64]) {
    fpenv::with_default(|| {
        let mut sum = 0u64;
        for (to, count) in percent.iter_mut().zip(counts) {
            sum = sum.saturating_add(*count);
            *to = 100.0 * super::shares::ratio(sum, whole);
        }
    });
}
