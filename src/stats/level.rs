//! What one level of grids holds.

use super::moments::Moments;
use super::shares::ratio;
use crate::arena::View;
use crate::arena::layout::{Grid, LIST_HEAD, REF_WORDS};

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

    /// Mean number of triangles in a grid of the level (mu_og by section 3; for
    /// what figures 14 and 17 print see [`super::Shares::objects_per_grid_printed`]).
    #[must_use]
    pub fn objects_per_grid(&self) -> f64 {
        ratio(self.objects, self.grids)
    }

    /// Distinct triangles over voxels: what figure 12 prints as mu_ov (0.952). By
    /// section 3 it is [`Level::objects_per_voxel`], which counts a triangle in
    /// each voxel that refers to it.
    #[must_use]
    pub fn distinct_per_voxel(&self) -> f64 {
        ratio(self.objects, self.voxels)
    }

    /// The same over the voxels that refer to triangles: figure 12's mu'_ov.
    #[must_use]
    pub fn distinct_per_filled_voxel(&self) -> f64 {
        ratio(self.objects, self.object_voxels)
    }

    /// References of both kinds (%ptrs).
    #[must_use]
    pub fn pointers(&self) -> u64 {
        self.object_refs + self.grid_refs
    }

    pub(super) fn add(&mut self, grid: &Grid, view: &View<'_>) {
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

    pub(super) fn join(&mut self, other: &Self) {
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
