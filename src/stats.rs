//! The statistics of section 3: resources and occupancy, level by level.
//!
//! The paper's tables do not always follow its definitions: figure 12 counts
//! objects where figures 14 and 17 count references, and %obj sums to 100 for
//! the recursive grid although references repeat objects. Here "objects" are
//! distinct triangles and "references" are pointers; the means and deviations
//! per voxel are over references.

use crate::arena::View;
use crate::arena::layout::{Grid, LIST_HEAD, REF_WORDS};
use crate::options::{MAX_LEVELS, Structure};
use crate::simd::fpenv;

/// A mean and a standard deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// The mean.
    pub mean: f64,
    /// The standard deviation, of the whole population.
    pub deviation: f64,
}

impl Moments {
    fn new(count: u64, sum: u64, squares: u128) -> Self {
        if count == 0 {
            return Self::default();
        }
        fpenv::with_default(|| {
            let mean = sum as f64 / count as f64;
            let variance = (squares as f64 / count as f64 - mean * mean).max(0.0);
            Self { mean, deviation: crate::math::sqrt(variance) }
        })
    }
}

/// One level of grids, or all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Level {
    /// Distinct triangles referenced from the level (%obj).
    pub objects: u64,
    /// Grids (%grids).
    pub grids: u64,
    /// Voxels (%voxels).
    pub voxels: u64,
    /// Voxels that refer to triangles (%o).
    pub object_voxels: u64,
    /// Voxels that refer to grids (%g).
    pub grid_voxels: u64,
    /// References to triangles.
    pub object_refs: u64,
    /// References to grids; %ptrs counts both kinds.
    pub grid_refs: u64,
    /// Sum of the grids' volumes over the largest grid's (%vol / 100).
    pub volume: f64,
    /// Bytes of grids, voxels and references.
    pub bytes: u64,
    object_squares: u128,
    grid_squares: u128,
}

impl Level {
    /// Triangle references per voxel (mu_ov, sigma_ov).
    #[must_use]
    pub fn objects_per_voxel(&self) -> Moments {
        Moments::new(self.voxels, self.object_refs, self.object_squares)
    }

    /// Triangle references per voxel that has any (mu'_ov, sigma'_ov).
    #[must_use]
    pub fn objects_per_filled_voxel(&self) -> Moments {
        Moments::new(self.object_voxels, self.object_refs, self.object_squares)
    }

    /// Grid references per voxel (mu_gv, sigma_gv).
    #[must_use]
    pub fn grids_per_voxel(&self) -> Moments {
        Moments::new(self.voxels, self.grid_refs, self.grid_squares)
    }

    /// Grid references per voxel that has any (mu'_gv, sigma'_gv).
    #[must_use]
    pub fn grids_per_filled_voxel(&self) -> Moments {
        Moments::new(self.grid_voxels, self.grid_refs, self.grid_squares)
    }

    /// Mean number of triangles in a grid of the level (mu_og by section 3; the
    /// printed figures 14 and 17 show %obj / %grids instead).
    #[must_use]
    pub fn objects_per_grid(&self) -> f64 {
        if self.grids == 0 { 0.0 } else { self.objects as f64 / self.grids as f64 }
    }

    fn add(&mut self, grid: &Grid, view: &View<'_>) {
        self.grids += 1;
        self.voxels += grid.voxels();
        self.volume += grid.volume();
        let first = grid.first as usize;
        let mut words = grid.voxels();
        for voxel in first..first + grid.voxels() as usize {
            let (objects, grids) = view.sections().counts(voxel);
            if objects > 0 || grids > 1 {
                words += LIST_HEAD as u64 + REF_WORDS as u64 * (objects + grids);
            }
            self.object_refs += objects;
            self.grid_refs += grids;
            self.object_voxels += u64::from(objects > 0);
            self.grid_voxels += u64::from(grids > 0);
            self.object_squares += u128::from(objects) * u128::from(objects);
            self.grid_squares += u128::from(grids) * u128::from(grids);
        }
        self.bytes += size_of::<Grid>() as u64 + 4 * words;
    }

    fn join(&mut self, other: &Self) {
        self.objects += other.objects;
        self.grids += other.grids;
        self.voxels += other.voxels;
        self.object_voxels += other.object_voxels;
        self.grid_voxels += other.grid_voxels;
        self.object_refs += other.object_refs;
        self.grid_refs += other.grid_refs;
        self.volume += other.volume;
        self.bytes += other.bytes;
        self.object_squares += other.object_squares;
        self.grid_squares += other.grid_squares;
    }
}

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
}
