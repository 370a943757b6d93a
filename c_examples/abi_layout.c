/* What it teaches: the structs of hug.h as a binding to another language needs them.
 * Prints how this compiler lays them out, one line each:
 *     STRUCT SIZE ALIGNMENT
 *     STRUCT.FIELD OFFSET
 * for a test to compare with the library's own idea of them. */
#include <stddef.h>
#include <stdio.h>

#include "hug.h"

/* C99 has no alignof: an offset after one char says the same. */
#define ALIGNMENT_PROBE(type) \
    typedef struct {          \
        char first;           \
        type second;          \
    } probe_##type

ALIGNMENT_PROBE(hug_geometry);
ALIGNMENT_PROBE(hug_build_desc);
ALIGNMENT_PROBE(hug_ray);
ALIGNMENT_PROBE(hug_hit);
ALIGNMENT_PROBE(hug_counters);
ALIGNMENT_PROBE(hug_ray_soa);
ALIGNMENT_PROBE(hug_hit_soa);
ALIGNMENT_PROBE(hug_level_stats);
ALIGNMENT_PROBE(hug_scene_stats);
ALIGNMENT_PROBE(hug_level_shares);
ALIGNMENT_PROBE(hug_voxel_histogram);
ALIGNMENT_PROBE(hug_scene_lengths);
ALIGNMENT_PROBE(hug_calls);
ALIGNMENT_PROBE(hug_profile);
ALIGNMENT_PROBE(hug_probe);
ALIGNMENT_PROBE(hug_nearest);
ALIGNMENT_PROBE(hug_advice);
ALIGNMENT_PROBE(hug_clusters);
ALIGNMENT_PROBE(hug_clusterings);

#define STRUCT(type)                                          \
    printf("%s %u %u\n", #type, (unsigned)sizeof(type),       \
           (unsigned)offsetof(probe_##type, second))
#define FIELD(type, field) printf("%s.%s %u\n", #type, #field, (unsigned)offsetof(type, field))

static void print_geometry(void)
{
    STRUCT(hug_geometry);
    FIELD(hug_geometry, vertices);
    FIELD(hug_geometry, vertex_count);
    FIELD(hug_geometry, vertex_stride);
    FIELD(hug_geometry, indices);
    FIELD(hug_geometry, triangle_count);
    FIELD(hug_geometry, index_type);
    FIELD(hug_geometry, mask);
}

static void print_build_desc(void)
{
    STRUCT(hug_build_desc);
    FIELD(hug_build_desc, struct_size);
    FIELD(hug_build_desc, geometries);
    FIELD(hug_build_desc, geometry_count);
    FIELD(hug_build_desc, structure);
    FIELD(hug_build_desc, gridding);
    FIELD(hug_build_desc, counts);
    FIELD(hug_build_desc, alpha);
    FIELD(hug_build_desc, world_alpha);
    FIELD(hug_build_desc, maxp);
    FIELD(hug_build_desc, max_depth);
    FIELD(hug_build_desc, filter_levels);
    FIELD(hug_build_desc, filter_share);
    FIELD(hug_build_desc, filter_thresholds);
    FIELD(hug_build_desc, connectivity);
    FIELD(hug_build_desc, delta);
    FIELD(hug_build_desc, hierarchy);
    FIELD(hug_build_desc, min_cluster);
    FIELD(hug_build_desc, max_refs);
    FIELD(hug_build_desc, flags);
    FIELD(hug_build_desc, alloc);
    FIELD(hug_build_desc, free);
    FIELD(hug_build_desc, user);
    FIELD(hug_build_desc, quality);
    FIELD(hug_build_desc, reserved);
    FIELD(hug_build_desc, parallel_for);
    FIELD(hug_build_desc, parallel_user);
    FIELD(hug_build_desc, progress);
    FIELD(hug_build_desc, progress_user);
    FIELD(hug_build_desc, clustering);
    FIELD(hug_build_desc, overlap_power);
    FIELD(hug_build_desc, orientation);
    FIELD(hug_build_desc, turn_below);
}

static void print_ray(void)
{
    STRUCT(hug_ray);
    FIELD(hug_ray, org);
    FIELD(hug_ray, tmin);
    FIELD(hug_ray, dir);
    FIELD(hug_ray, tmax);
    FIELD(hug_ray, mask);
    FIELD(hug_ray, flags);
    FIELD(hug_ray, skip_geom);
    FIELD(hug_ray, skip_prim);
}

static void print_hit(void)
{
    STRUCT(hug_hit);
    FIELD(hug_hit, t);
    FIELD(hug_hit, u);
    FIELD(hug_hit, v);
    FIELD(hug_hit, ng);
    FIELD(hug_hit, geom);
    FIELD(hug_hit, prim);
    FIELD(hug_hit, inst);
    FIELD(hug_hit, reserved);
}

static void print_ray_soa(void)
{
    STRUCT(hug_ray_soa);
    FIELD(hug_ray_soa, struct_size);
    FIELD(hug_ray_soa, org);
    FIELD(hug_ray_soa, dir);
    FIELD(hug_ray_soa, tmin);
    FIELD(hug_ray_soa, tmax);
    FIELD(hug_ray_soa, mask);
    FIELD(hug_ray_soa, skip_geom);
    FIELD(hug_ray_soa, skip_prim);
    FIELD(hug_ray_soa, flags);
}

static void print_hit_soa(void)
{
    STRUCT(hug_hit_soa);
    FIELD(hug_hit_soa, struct_size);
    FIELD(hug_hit_soa, t);
    FIELD(hug_hit_soa, u);
    FIELD(hug_hit_soa, v);
    FIELD(hug_hit_soa, ng);
    FIELD(hug_hit_soa, geom);
    FIELD(hug_hit_soa, prim);
    FIELD(hug_hit_soa, inst);
}

static void print_counters(void)
{
    STRUCT(hug_counters);
    FIELD(hug_counters, grids);
    FIELD(hug_counters, voxels);
    FIELD(hug_counters, tests);
    FIELD(hug_counters, hits);
}

static void print_level_stats(void)
{
    STRUCT(hug_level_stats);
    FIELD(hug_level_stats, objects);
    FIELD(hug_level_stats, grids);
    FIELD(hug_level_stats, voxels);
    FIELD(hug_level_stats, object_voxels);
    FIELD(hug_level_stats, grid_voxels);
    FIELD(hug_level_stats, object_refs);
    FIELD(hug_level_stats, grid_refs);
    FIELD(hug_level_stats, volume);
    FIELD(hug_level_stats, object_mean);
    FIELD(hug_level_stats, object_deviation);
    FIELD(hug_level_stats, object_mean_filled);
    FIELD(hug_level_stats, object_deviation_filled);
    FIELD(hug_level_stats, grid_mean);
    FIELD(hug_level_stats, grid_deviation);
    FIELD(hug_level_stats, grid_mean_filled);
    FIELD(hug_level_stats, grid_deviation_filled);
    FIELD(hug_level_stats, bytes);
}

static void print_scene_stats(void)
{
    STRUCT(hug_scene_stats);
    FIELD(hug_scene_stats, struct_size);
    FIELD(hug_scene_stats, structure);
    FIELD(hug_scene_stats, levels);
    FIELD(hug_scene_stats, triangles);
    FIELD(hug_scene_stats, dropped_non_finite);
    FIELD(hug_scene_stats, dropped_degenerate);
    FIELD(hug_scene_stats, counts);
    FIELD(hug_scene_stats, reserved);
    FIELD(hug_scene_stats, bytes);
    FIELD(hug_scene_stats, triangle_bytes);
    FIELD(hug_scene_stats, grid_bytes);
    FIELD(hug_scene_stats, voxel_bytes);
    FIELD(hug_scene_stats, ref_bytes);
    FIELD(hug_scene_stats, total);
    FIELD(hug_scene_stats, level);
    FIELD(hug_scene_stats, total_share);
    FIELD(hug_scene_stats, level_share);
    FIELD(hug_scene_stats, node_bytes);
}

static void print_level_shares(void)
{
    STRUCT(hug_level_shares);
    FIELD(hug_level_shares, objects);
    FIELD(hug_level_shares, objects_of_levels);
    FIELD(hug_level_shares, grids);
    FIELD(hug_level_shares, voxels);
    FIELD(hug_level_shares, pointers);
    FIELD(hug_level_shares, volume);
    FIELD(hug_level_shares, bytes);
    FIELD(hug_level_shares, object_voxels);
    FIELD(hug_level_shares, grid_voxels);
    FIELD(hug_level_shares, objects_per_grid);
    FIELD(hug_level_shares, objects_per_grid_printed);
    FIELD(hug_level_shares, distinct_per_voxel);
    FIELD(hug_level_shares, distinct_per_filled_voxel);
}

static void print_voxel_histogram(void)
{
    STRUCT(hug_voxel_histogram);
    FIELD(hug_voxel_histogram, struct_size);
    FIELD(hug_voxel_histogram, level);
    FIELD(hug_voxel_histogram, reserved);
    FIELD(hug_voxel_histogram, capacity);
    FIELD(hug_voxel_histogram, counts);
    FIELD(hug_voxel_histogram, cumulated);
    FIELD(hug_voxel_histogram, voxels);
    FIELD(hug_voxel_histogram, most);
}

static void print_scene_lengths(void)
{
    STRUCT(hug_scene_lengths);
    FIELD(hug_scene_lengths, struct_size);
    FIELD(hug_scene_lengths, capacity);
    FIELD(hug_scene_lengths, counts);
    FIELD(hug_scene_lengths, cumulated);
    FIELD(hug_scene_lengths, share);
    FIELD(hug_scene_lengths, triangles);
    FIELD(hug_scene_lengths, min);
    FIELD(hug_scene_lengths, max);
    FIELD(hug_scene_lengths, diagonal);
    FIELD(hug_scene_lengths, below_fifth);
}

static void print_calls(void)
{
    STRUCT(hug_calls);
    FIELD(hug_calls, grids);
    FIELD(hug_calls, voxels);
    FIELD(hug_calls, tests);
    FIELD(hug_calls, hits);
    FIELD(hug_calls, passed_1);
    FIELD(hug_calls, passed_2);
}

static void print_profile(void)
{
    STRUCT(hug_profile);
    FIELD(hug_profile, total);
    FIELD(hug_profile, level);
}

static void print_probe(void)
{
    STRUCT(hug_probe);
    FIELD(hug_probe, org);
    FIELD(hug_probe, radius);
    FIELD(hug_probe, mask);
    FIELD(hug_probe, flags);
    FIELD(hug_probe, skip_geom);
    FIELD(hug_probe, skip_prim);
}

static void print_nearest(void)
{
    STRUCT(hug_nearest);
    FIELD(hug_nearest, distance);
    FIELD(hug_nearest, u);
    FIELD(hug_nearest, v);
    FIELD(hug_nearest, point);
    FIELD(hug_nearest, geom);
    FIELD(hug_nearest, prim);
    FIELD(hug_nearest, inst);
    FIELD(hug_nearest, reserved);
}

static void print_advice(void)
{
    STRUCT(hug_advice);
    FIELD(hug_advice, struct_size);
    FIELD(hug_advice, triangles);
    FIELD(hug_advice, small);
    FIELD(hug_advice, variation);
    FIELD(hug_advice, occupied);
    FIELD(hug_advice, expected);
    FIELD(hug_advice, crowding);
    FIELD(hug_advice, prone);
    FIELD(hug_advice, structure);
    FIELD(hug_advice, filter_levels);
    FIELD(hug_advice, filter_share);
    FIELD(hug_advice, clustering);
    FIELD(hug_advice, reason);
}

static void print_clusters(void)
{
    STRUCT(hug_clusters);
    FIELD(hug_clusters, clusters);
    FIELD(hug_clusters, grids);
    FIELD(hug_clusters, objects);
    FIELD(hug_clusters, volume);
}

static void print_clusterings(void)
{
    STRUCT(hug_clusterings);
    FIELD(hug_clusterings, struct_size);
    FIELD(hug_clusterings, triangles);
    FIELD(hug_clusterings, filtered);
    FIELD(hug_clusterings, plane_pairs);
    FIELD(hug_clusterings, pairs);
    FIELD(hug_clusterings, projections);
    FIELD(hug_clusterings, components);
}

int main(void)
{
    print_geometry();
    print_build_desc();
    print_ray();
    print_hit();
    print_counters();
    print_ray_soa();
    print_hit_soa();
    print_level_stats();
    print_scene_stats();
    print_level_shares();
    print_voxel_histogram();
    print_scene_lengths();
    print_calls();
    print_profile();
    print_probe();
    print_nearest();
    print_advice();
    print_clusters();
    print_clusterings();
    return 0;
}
