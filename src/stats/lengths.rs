//! How long a scene's triangles are (figure 4, and the charts of figures 5 to 9).

use crate::aabb::Aabb;
use crate::arena::View;
use crate::arena::layout::Triangle;
use crate::simd::fpenv;

/// The lengths of a scene's triangles: the diagonals of their boxes. All zeros
/// for an empty scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lengths {
    /// Triangles in the scene (#polys); those that the build dropped are not in it.
    pub count: u64,
    /// The smallest length.
    pub min: f64,
    /// The largest.
    pub max: f64,
    /// The diagonal of the scene's box.
    pub diagonal: f64,
    /// Triangles shorter than a fifth of the largest length.
    pub below_fifth: u64,
}

impl Lengths {
    /// Measures every triangle. Cost: linear in the triangles; no allocation.
    #[must_use]
    pub fn of(view: &View<'_>) -> Self {
        fpenv::with_default(|| {
            let count = view.triangles().len() as u64;
            if count == 0 {
                return Self::default();
            }
            let (mut min, mut max) = (f64::INFINITY, 0.0f64);
            for length in view.triangles().iter().map(length) {
                min = min.min(length);
                max = max.max(length);
            }
            let short = |t: &&Triangle| length(t) < 0.2 * max;
            let (lo, hi) = view.bounds();
            let below_fifth = view.triangles().iter().filter(short).count() as u64;
            Self { count, min, max, diagonal: Aabb { lo, hi }.diagonal(), below_fifth }
        })
    }

    /// min/max.
    #[must_use]
    pub fn min_over_max(&self) -> f64 {
        if self.max > 0.0 { self.min / self.max } else { 0.0 }
    }

    /// min/diag.
    #[must_use]
    pub fn min_over_diagonal(&self) -> f64 {
        if self.diagonal > 0.0 { self.min / self.diagonal } else { 0.0 }
    }

    /// %.2: the percentage of triangles shorter than a fifth of the largest length.
    #[must_use]
    pub fn percent_below_fifth(&self) -> f64 {
        100.0 * super::shares::ratio(self.below_fifth, self.count)
    }

    /// Counts the triangles of the scene measured by length, in classes of equal
    /// width from 0 to `share` of the largest length (the paper's charts stop at
    /// 0.2), the end itself included. Longer ones are in no class.
    pub fn histogram(&self, view: &View<'_>, share: f64, counts: &mut [u64]) {
        counts.fill(0);
        fpenv::with_default(|| {
            let end = share * self.max;
            // Neither NaN nor anything empty passes.
            let sensible = end > 0.0 && end < f64::INFINITY;
            if !sensible || counts.is_empty() {
                return;
            }
            let last = counts.len() - 1;
            for length in view.triangles().iter().map(length) {
                if length <= end {
                    let class = (length / end * counts.len() as f64) as usize;
                    counts[class.min(last)] += 1;
                }
            }
        });
    }
}

fn length(triangle: &Triangle) -> f64 {
    Aabb::of(&triangle.corners()).diagonal()
}
