//! The structs of include/hug.h are laid out by the C and C++ compilers as by
//! Rust's: sizes, alignments and the offset of every field.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::native::{library, make, run};
use hug::capi::types::{
    hug_build_desc, hug_counters, hug_geometry, hug_hit, hug_hit_soa, hug_level_shares,
    hug_level_stats, hug_ray, hug_ray_soa, hug_scene_stats,
};
use hug::capi::{
    hug_advice, hug_calls, hug_clusterings, hug_clusters, hug_nearest, hug_probe, hug_profile,
    hug_scene_lengths, hug_voxel_histogram,
};
use std::mem::{align_of, offset_of, size_of};
use std::process::Command;

/// The lines that abi_layout prints of a struct. The pattern without `..` makes
/// sure that no field is left out.
macro_rules! lines {
    ($($type:ident { $($field:ident),* $(,)? })*) => {
        [$({
            let _ = |whole: $type| { let $type { $($field: _),* } = whole; };
            let name = stringify!($type);
            let mut lines = vec![format!("{name} {} {}", size_of::<$type>(), align_of::<$type>())];
            $(lines.push(format!(
                "{name}.{} {}", stringify!($field), offset_of!($type, $field)
            ));)*
            lines
        }),*].concat()
    };
}

fn expected() -> Vec<String> {
    lines! {
        hug_geometry {
            vertices, vertex_count, vertex_stride, indices, triangle_count, index_type, mask,
        }
        hug_build_desc {
            struct_size, geometries, geometry_count, structure, gridding, counts, alpha,
            world_alpha, maxp, max_depth, filter_levels, filter_share, filter_thresholds,
            connectivity, delta, hierarchy, min_cluster, max_refs, flags, alloc, free, user,
            quality, reserved, parallel_for, parallel_user, progress, progress_user, clustering,
            overlap_power, orientation, turn_below,
        }
        hug_ray { org, tmin, dir, tmax, mask, flags, skip_geom, skip_prim }
        hug_hit { t, u, v, ng, geom, prim, inst, reserved }
        hug_counters { grids, voxels, tests, hits }
        hug_ray_soa { struct_size, org, dir, tmin, tmax, mask, skip_geom, skip_prim, flags }
        hug_hit_soa { struct_size, t, u, v, ng, geom, prim, inst }
        hug_level_stats {
            objects, grids, voxels, object_voxels, grid_voxels, object_refs, grid_refs, volume,
            object_mean, object_deviation, object_mean_filled, object_deviation_filled,
            grid_mean, grid_deviation, grid_mean_filled, grid_deviation_filled, bytes,
        }
        hug_scene_stats {
            struct_size, structure, levels, triangles, dropped_non_finite, dropped_degenerate,
            counts, reserved, bytes, triangle_bytes, grid_bytes, voxel_bytes, ref_bytes, total,
            level, total_share, level_share, node_bytes,
        }
        hug_level_shares {
            objects, objects_of_levels, grids, voxels, pointers, volume, bytes, object_voxels,
            grid_voxels, objects_per_grid, objects_per_grid_printed, distinct_per_voxel,
            distinct_per_filled_voxel,
        }
        hug_voxel_histogram {
            struct_size, level, reserved, capacity, counts, cumulated, voxels, most,
        }
        hug_scene_lengths {
            struct_size, capacity, counts, cumulated, share, triangles, min, max, diagonal,
            below_fifth,
        }
        hug_calls { grids, voxels, tests, hits, passed_1, passed_2 }
        hug_profile { total, level }
        hug_probe { org, radius, mask, flags, skip_geom, skip_prim }
        hug_nearest { distance, u, v, point, geom, prim, inst, reserved }
        hug_advice {
            struct_size, triangles, small, variation, occupied, expected, crowding, prone,
            structure, filter_levels, filter_share, clustering, reason,
        }
        hug_clusters { clusters, grids, objects, volume }
        hug_clusterings {
            struct_size, triangles, filtered, plane_pairs, pairs, projections, components,
        }
    }
}

#[test]
fn c_and_rust_agree() {
    library("staticlib", &["--features", "capi"], "release");
    for mode in ["c", "c++"] {
        let bin = make(mode, &["abi_layout"]);
        let printed = run(&mut Command::new(bin.join("abi_layout")));
        let printed: Vec<&str> = printed.lines().collect();
        assert_eq!(printed, expected(), "compiled as {mode}");
    }
}

/// Frozen, whatever the compilers agree on.
#[test]
fn rays_and_hits_keep_their_sizes() {
    assert_eq!((size_of::<hug_ray>(), align_of::<hug_ray>()), (48, 4));
    assert_eq!((size_of::<hug_hit>(), align_of::<hug_hit>()), (40, 4));
    assert_eq!((size_of::<hug_probe>(), align_of::<hug_probe>()), (32, 4));
    assert_eq!((size_of::<hug_nearest>(), align_of::<hug_nearest>()), (40, 4));
    let (ray, hit) = (size_of::<hug::Ray>(), size_of::<hug::Hit>());
    assert_eq!((ray, hit), (48, 40));
}
