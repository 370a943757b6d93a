//! A descriptor's options as the library's.

use super::desc::slice;
use super::types::{
    HUG_BUILD_COMPACT, HUG_BUILD_FILL_UP, HUG_BUILD_KEEP_SCRATCH, HUG_BUILD_PLAIN_STEPS,
    HUG_BUILD_TREE, HUG_CLUSTERING_COMPONENTS, HUG_DELTA_MEAN, HUG_GRIDDING_HOMOGENEOUS,
    HUG_GRIDDING_MIXED, HUG_GRIDDING_OVERLAP, HUG_HIERARCHY_PAPER, HUG_ORIENTATION_HULL,
    HUG_ORIENTATION_SEARCH, HUG_ORIENTATION_VERTICES, HUG_QUALITY_FAST, HUG_QUALITY_HIGH,
    hug_build_desc,
};
use crate::Error;
use crate::options::{
    Clustering, Delta, Filter, Gridding, Hierarchy, MAX_LEVELS, Options, Orientation, Quality,
    Structure,
};

fn or<T: PartialEq + Default>(value: T, default: T) -> T {
    if value == T::default() { default } else { value }
}

/// # Safety
/// `filter_thresholds` is NULL or readable.
pub unsafe fn options(d: &hug_build_desc) -> Result<Options, Error> {
    let normal = Options::default();
    let flags = HUG_BUILD_PLAIN_STEPS
        | HUG_BUILD_COMPACT
        | HUG_BUILD_KEEP_SCRATCH
        | HUG_BUILD_FILL_UP
        | HUG_BUILD_TREE;
    if d.flags & !flags != 0 || d.reserved != 0 {
        return Err(Error::InvalidValue);
    }
    Ok(Options {
        structure: match d.structure {
            0 => Structure::Auto,
            1 => Structure::Uniform,
            2 => Structure::Recursive,
            3 => Structure::Hug,
            _ => return Err(Error::InvalidValue),
        },
        gridding: match d.gridding {
            0 => Gridding::Proportional,
            HUG_GRIDDING_HOMOGENEOUS => Gridding::Homogeneous,
            HUG_GRIDDING_OVERLAP => Gridding::Overlap,
            HUG_GRIDDING_MIXED => Gridding::Mixed,
            _ => return Err(Error::InvalidValue),
        },
        overlap_power: or(d.overlap_power, normal.overlap_power),
        counts: d.counts,
        alpha: or(d.alpha, normal.alpha),
        world_alpha: (d.world_alpha != 0.0).then_some(d.world_alpha),
        maxp: or(d.maxp, normal.maxp),
        max_depth: or(d.max_depth, normal.max_depth),
        fill_up: d.flags & HUG_BUILD_FILL_UP != 0,
        tree: d.flags & HUG_BUILD_TREE != 0,
        // SAFETY: by the caller.
        filter: unsafe { filter(d) }?,
        clustering: match d.clustering {
            0 => Clustering::Projections,
            HUG_CLUSTERING_COMPONENTS => Clustering::Components,
            _ => return Err(Error::InvalidValue),
        },
        connectivity: or(d.connectivity, normal.connectivity),
        delta: match d.delta {
            0 => Delta::Midpoint,
            HUG_DELTA_MEAN => Delta::Mean,
            _ => return Err(Error::InvalidValue),
        },
        hierarchy: match d.hierarchy {
            0 => Hierarchy::Nested,
            HUG_HIERARCHY_PAPER => Hierarchy::Paper,
            _ => return Err(Error::InvalidValue),
        },
        min_cluster: or(d.min_cluster, normal.min_cluster),
        orientation: match d.orientation {
            0 => Orientation::Aligned,
            HUG_ORIENTATION_VERTICES => Orientation::Vertices,
            HUG_ORIENTATION_HULL => Orientation::Hull,
            HUG_ORIENTATION_SEARCH => Orientation::Search,
            _ => return Err(Error::InvalidValue),
        },
        turn_below: or(d.turn_below, normal.turn_below),
        exit_boxes: d.flags & HUG_BUILD_PLAIN_STEPS == 0,
        max_refs: or(d.max_refs, normal.max_refs),
        quality: match d.quality {
            0 => Quality::Default,
            HUG_QUALITY_FAST => Quality::Fast,
            HUG_QUALITY_HIGH => Quality::High,
            _ => return Err(Error::InvalidValue),
        },
        compact: d.flags & HUG_BUILD_COMPACT != 0,
    })
}

/// # Safety
/// `filter_thresholds` is NULL or readable.
unsafe fn filter(d: &hug_build_desc) -> Result<Filter, Error> {
    if d.filter_thresholds.is_null() {
        return match d.filter_levels {
            0 | 2 => Ok(Filter::TwoLevels(or(d.filter_share, 0.05))),
            3 => Ok(Filter::ThreeLevels),
            _ => Err(Error::InvalidValue),
        };
    }
    if !(2..=MAX_LEVELS as u32).contains(&d.filter_levels) {
        return Err(Error::InvalidValue);
    }
    let count = d.filter_levels as usize - 1;
    let mut at = [0.0; MAX_LEVELS - 1];
    // SAFETY: readable by the caller.
    at[..count].copy_from_slice(unsafe { slice(d.filter_thresholds, count) }?);
    Ok(Filter::Thresholds { count, at })
}
