//! The C mirrors of counters and of a scene's statistics.
#![allow(non_camel_case_types)]

use super::types::{HUG_MAX_LEVELS, hug_structure};

/// What a query did, counted; the counted queries add to it.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_counters {
    /// Grids whose box was tested (the paper's #bbi).
    pub grids: u64,
    /// Voxels traversed (#vt): the steps of the walk.
    pub voxels: u64,
    /// Ray-triangle tests (#pit), one per reference met.
    pub tests: u64,
    /// Tests that were hits within the ray's range (#pi).
    pub hits: u64,
}

/// Section 3's statistics of one level of grids, or of all. "Objects" are
/// distinct triangles; "references" repeat a triangle for each voxel.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_level_stats {
    /// Distinct triangles referenced from this level (%obj).
    pub objects: u64,
    /// Grids (%grids).
    pub grids: u64,
    /// Voxels (%voxels).
    pub voxels: u64,
    /// Voxels that reference at least one triangle (%o).
    pub object_voxels: u64,
    /// Voxels that reference at least one grid (%g).
    pub grid_voxels: u64,
    /// References to triangles.
    pub object_refs: u64,
    /// References to grids; %ptrs counts both kinds.
    pub grid_refs: u64,
    /// Sum of the grids' volumes over the largest grid's volume (%vol / 100).
    pub volume: f64,
    /// Mean triangle references per voxel.
    pub object_mean: f64,
    /// Standard deviation of triangle references per voxel.
    pub object_deviation: f64,
    /// Mean triangle references per voxel that has any.
    pub object_mean_filled: f64,
    /// Standard deviation of triangle references per voxel that has any.
    pub object_deviation_filled: f64,
    /// Mean grid references per voxel.
    pub grid_mean: f64,
    /// Standard deviation of grid references per voxel.
    pub grid_deviation: f64,
    /// Mean grid references per voxel that has any.
    pub grid_mean_filled: f64,
    /// Standard deviation of grid references per voxel that has any.
    pub grid_deviation_filled: f64,
    /// Bytes of grids, voxels and references.
    pub bytes: u64,
}

/// Section 3's percentages of one level of grids, or of all.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_level_shares {
    /// %obj by its definition: of the scene's triangles, those that the level
    /// refers to. Sums to more than 100 where levels share triangles.
    pub objects: f64,
    /// %obj as the paper's tables print it: of the sum of the levels' triangles.
    pub objects_of_levels: f64,
    /// %grids.
    pub grids: f64,
    /// %voxels.
    pub voxels: f64,
    /// %ptrs.
    pub pointers: f64,
    /// %vol: of the largest grid's volume.
    pub volume: f64,
    /// Of the bytes of grids, voxels and references.
    pub bytes: f64,
    /// %o: of the level's voxels, those that refer to triangles.
    pub object_voxels: f64,
    /// %g: of the level's voxels, those that refer to grids.
    pub grid_voxels: f64,
    /// mu_og by its definition: distinct triangles a grid.
    pub objects_per_grid: f64,
    /// mu_og as figures 14 and 17 print it: %obj / %grids.
    pub objects_per_grid_printed: f64,
    /// mu_ov as figure 12 prints it: distinct triangles over voxels. By its
    /// definition it is hug_level_stats.object_mean.
    pub distinct_per_voxel: f64,
    /// mu'_ov likewise: over the voxels that refer to triangles.
    pub distinct_per_filled_voxel: f64,
}

/// What a scene is made of. Set struct_size before the call; a program compiled
/// against an older header passes a smaller one, and gets the fields it knows.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_scene_stats {
    /// sizeof(hug_scene_stats).
    pub struct_size: usize,
    /// The structure that was built; never HUG_STRUCTURE_AUTO.
    pub structure: hug_structure,
    /// Number of levels; 0 holds the deepest grids.
    pub levels: u32,
    /// Triangles in the scene.
    pub triangles: u64,
    /// Triangles left out of it for a coordinate that is not finite.
    pub dropped_non_finite: u64,
    /// Triangles left out of it for having no area.
    pub dropped_degenerate: u64,
    /// Voxels of the outermost grid.
    pub counts: [u32; 3],
    /// 0.
    pub reserved: u32,
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
    /// All levels together.
    pub total: hug_level_stats,
    /// Level by level.
    pub level: [hug_level_stats; HUG_MAX_LEVELS],
    /// All levels together, in percent: objects and volume are sums over them.
    pub total_share: hug_level_shares,
    /// Level by level, in percent.
    pub level_share: [hug_level_shares; HUG_MAX_LEVELS],
    /// Bytes of the tree of boxes.
    pub node_bytes: u64,
}
