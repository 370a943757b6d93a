//! The statistics of sections 2 and 3, view-independent ones: resources and
//! occupancy level by level, voxels by what they hold, objects by length.
//!
//! The paper's tables do not always follow its definitions: figure 12 counts
//! objects where figures 14 and 17 count references, %obj sums to 100 for the
//! recursive grid although levels share objects, and mu_og of figures 14 and 17
//! is %obj / %grids. Here "objects" are distinct triangles and "references" are
//! pointers; what is named without further words follows section 3, and the
//! printed readings have names of their own.

mod histogram;
mod lengths;
mod level;
mod moments;
mod shape;
mod shares;

pub use histogram::{Occupancy, cumulated};
pub use lengths::Lengths;
pub use level::Level;
pub use moments::Moments;
pub use shape::{GridFrame, GridShape};
pub use shares::Shares;

use crate::arena::View;
use crate::arena::layout::Grid;
use crate::options::{MAX_LEVELS, Structure};
use crate::simd::fpenv;

/// What a scene is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stats {
    /// The structure; never [`Structure::Auto`].
    pub structure: Structure,
    /// Triangles in the scene.
    pub triangles: u64,
    /// Triangles left out for a coordinate that is not finite.
    pub dropped_non_finite: u64,
    /// Triangles left out for having no area.
    pub dropped_degenerate: u64,
    /// Voxels of the outermost grid; zeros for an empty scene.
    pub counts: [u32; 3],
    /// Bytes of the arena, whole.
    pub bytes: u64,
    /// Bytes of the triangles' section.
    pub triangle_bytes: u64,
    /// Bytes of the grids' section.
    pub grid_bytes: u64,
    /// Bytes of the voxels' section.
    pub voxel_bytes: u64,
    /// Bytes of the references' section.
    pub ref_bytes: u64,
    /// Bytes of the tree of boxes.
    pub node_bytes: u64,
    /// All levels together; its `objects` counts a triangle once per level.
    pub total: Level,
    level: [Level; MAX_LEVELS],
    levels: usize,
}

impl Stats {
    /// Counts everything in a scene. Cost: linear in the arena; no
    /// allocation.
    #[must_use]
    pub fn of(view: &View<'_>) -> Self {
        fpenv::with_default(|| Self::count(view))
    }

    fn count(view: &View<'_>) -> Self {
        let h = view.header();
        let grids = view.grids();
        let levels = h.levels as usize;
        let mut level = [Level::default(); MAX_LEVELS];
        for grid in grids {
            level[grid.level as usize].add(grid, view);
        }
        let largest = grids.iter().map(Grid::volume).fold(0.0, f64::max);
        let mut total = Level::default();
        for (number, level) in level[..levels].iter_mut().enumerate() {
            level.volume /= largest;
            level.objects = u64::from(h.objects[number]);
            total.join(level);
        }
        Self {
            structure: match h.structure {
                1 => Structure::Uniform,
                2 => Structure::Recursive,
                _ => Structure::Hug,
            },
            triangles: h.triangles.count,
            dropped_non_finite: h.dropped_non_finite,
            dropped_degenerate: h.dropped_degenerate,
            counts: grids.first().map_or([0; 3], |g| g.n.map(u32::from)),
            bytes: h.bytes,
            triangle_bytes: h.triangles.count * 48,
            grid_bytes: h.grids.count * size_of::<Grid>() as u64,
            voxel_bytes: h.voxels.count * 4,
            ref_bytes: h.refs.count * 4,
            node_bytes: h.nodes.count * h.counts().node() as u64,
            total,
            level,
            levels,
        }
    }

    /// The levels, deepest first.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.level[..self.levels]
    }

    /// A level's part of the whole, or that of [`Stats::total`].
    #[must_use]
    pub fn shares(&self, level: &Level) -> Shares {
        fpenv::with_default(|| Shares::new(level, &self.total, self.triangles))
    }
}
