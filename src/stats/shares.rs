//! A level's part of the whole, in percent.

use super::level::Level;

/// The percentages of section 3, of one level or of all.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares {
    /// %obj by its definition: of the scene's triangles, those that the level
    /// refers to. Sums to more than 100 where levels share triangles.
    pub objects: f64,
    /// %obj as figures 14 and 17 print it: of the sum of the levels' triangles,
    /// so that it sums to 100.
    pub objects_of_levels: f64,
    /// %grids.
    pub grids: f64,
    /// %voxels.
    pub voxels: f64,
    /// %ptrs, to triangles and to grids.
    pub pointers: f64,
    /// %vol: of the largest grid's volume; the sum over the levels, which the
    /// paper judges a HUG by, is that of the total.
    pub volume: f64,
    /// Of the bytes of grids, voxels and references.
    pub bytes: f64,
    /// %o: of the level's voxels, those that refer to triangles.
    pub object_voxels: f64,
    /// %g: of the level's voxels, those that refer to grids.
    pub grid_voxels: f64,
}

impl Shares {
    pub(super) fn new(level: &Level, total: &Level, triangles: u64) -> Self {
        let percent = |part, whole| 100.0 * ratio(part, whole);
        Self {
            objects: percent(level.objects, triangles),
            objects_of_levels: percent(level.objects, total.objects),
            grids: percent(level.grids, total.grids),
            voxels: percent(level.voxels, total.voxels),
            pointers: percent(level.pointers(), total.pointers()),
            volume: 100.0 * level.volume,
            bytes: percent(level.bytes, total.bytes),
            object_voxels: percent(level.object_voxels, level.voxels),
            grid_voxels: percent(level.grid_voxels, level.voxels),
        }
    }

    /// What figures 14 and 17 print as mu_og: %obj / %grids. Objects a grid, as
    /// section 3 has it, are [`Level::objects_per_grid`].
    #[must_use]
    pub fn objects_per_grid_printed(&self) -> f64 {
        if self.grids > 0.0 { self.objects_of_levels / self.grids } else { 0.0 }
    }
}

/// Zero where there is nothing to divide by.
pub(super) fn ratio(part: u64, whole: u64) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}
