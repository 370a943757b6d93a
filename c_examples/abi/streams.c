/* Streams: arrays for each component, and counted and profiled ones. */
#include <math.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

/* An array for each component: the results of single calls; arrays that are missing
 * stand for what the header says, or are not written. */
static void check_arrays(const hug_scene *scene)
{
    static hug_hit single[FIXTURE_RAYS];
    static float org[3][FIXTURE_RAYS], dir[3][FIXTURE_RAYS], tmin[FIXTURE_RAYS],
        tmax[FIXTURE_RAYS], t[FIXTURE_RAYS], u[FIXTURE_RAYS], v[FIXTURE_RAYS],
        ng[3][FIXTURE_RAYS];
    static uint32_t mask[FIXTURE_RAYS], skip_geom[FIXTURE_RAYS], skip_prim[FIXTURE_RAYS],
        culled[FIXTURE_RAYS],
        geom[FIXTURE_RAYS], prim[FIXTURE_RAYS], inst[FIXTURE_RAYS];
    static uint8_t flags[FIXTURE_RAYS];
    hug_ray_soa rays = {sizeof rays, {org[0], org[1], org[2]}, {dir[0], dir[1], dir[2]},
                        tmin, tmax, mask, skip_geom, skip_prim, NULL};
    hug_hit_soa hits = {sizeof hits, t, u, v, {ng[0], ng[1], ng[2]}, geom, prim, inst};
    hug_ray_soa few = {sizeof few, {org[0], org[1], org[2]}, {dir[0], dir[1], dir[2]},
                       NULL, NULL, NULL, NULL, NULL, NULL};
    hug_hit_soa only = {sizeof only, NULL, NULL, NULL, {NULL, NULL, NULL}, NULL, prim, NULL};
    hug_ray_soa bad;
    hug_hit_soa bad_hits;
    unsigned i, k;
    int same = 1;
    fixture_hits(scene, single);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        hug_ray ray = fixture_ray(i);
        for (k = 0; k < 3; k++) {
            org[k][i] = ray.org[k];
            dir[k][i] = ray.dir[k];
        }
        tmin[i] = ray.tmin;
        tmax[i] = ray.tmax;
        mask[i] = ray.mask;
        skip_geom[i] = ray.skip_geom;
        skip_prim[i] = ray.skip_prim;
    }
    REQUIRE(hug_intersect_soa(scene, &rays, &hits, FIXTURE_RAYS) == HUG_OK);
    REQUIRE(hug_occluded_soa(scene, &rays, flags, FIXTURE_RAYS) == HUG_OK);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        hug_hit hit = {t[i], u[i], v[i], {ng[0][i], ng[1][i], ng[2][i]},
                       geom[i], prim[i], inst[i], 0};
        same = same && memcmp(&hit, &single[i], sizeof hit) == 0 &&
               flags[i] == (single[i].geom != HUG_NONE);
    }
    REQUIRE(same);

    /* flags, and a caller whose header does not know them yet */
    for (i = 0; i < FIXTURE_RAYS; i++)
        culled[i] = i % 2 ? 0 : HUG_RAY_CULL_BACK | HUG_RAY_CULL_FRONT;
    rays.flags = culled;
    REQUIRE(hug_intersect_soa(scene, &rays, &hits, FIXTURE_RAYS) == HUG_OK);
    for (i = 0; i < FIXTURE_RAYS; i++)
        same = same && geom[i] == (i % 2 ? single[i].geom : HUG_NONE);
    REQUIRE(same);
    rays.struct_size = offsetof(hug_ray_soa, flags);
    REQUIRE(hug_intersect_soa(scene, &rays, &hits, FIXTURE_RAYS) == HUG_OK);
    for (i = 0; i < FIXTURE_RAYS; i++)
        same = same && geom[i] == single[i].geom;
    REQUIRE(same);
    rays.struct_size = sizeof rays;

    memset(prim, 7, sizeof prim);
    memset(geom, 7, sizeof geom);
    REQUIRE(hug_intersect_soa(scene, &few, &only, FIXTURE_RAYS) == HUG_OK);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        hug_ray ray = fixture_ray(i);
        hug_hit hit;
        ray.tmin = 0;
        ray.tmax = INFINITY;
        ray.mask = 0xffffffffu;
        ray.skip_geom = ray.skip_prim = HUG_NONE;
        hug_intersect(scene, &ray, &hit);
        same = same && prim[i] == hit.prim && geom[i] == 0x07070707u;
    }
    REQUIRE(same);

    REQUIRE(hug_intersect_soa(NULL, &rays, &hits, 1) == HUG_ERROR_NULL);
    REQUIRE(hug_intersect_soa(scene, NULL, &hits, 1) == HUG_ERROR_NULL);
    REQUIRE(hug_intersect_soa(scene, &rays, NULL, 1) == HUG_ERROR_NULL);
    REQUIRE(hug_occluded_soa(NULL, &rays, flags, 1) == HUG_ERROR_NULL);
    REQUIRE(hug_occluded_soa(scene, NULL, flags, 1) == HUG_ERROR_NULL);
    REQUIRE(hug_occluded_soa(scene, &rays, NULL, 1) == HUG_ERROR_NULL);
    bad = rays;
    bad.dir[1] = NULL;
    REQUIRE(hug_intersect_soa(scene, &bad, &hits, 1) == HUG_ERROR_NULL);
    bad = rays;
    bad.struct_size = offsetof(hug_ray_soa, flags) - sizeof(size_t);
    REQUIRE(hug_occluded_soa(scene, &bad, flags, 1) == HUG_ERROR_STRUCT_SIZE);
    bad_hits = hits;
    bad_hits.struct_size = 0;
    REQUIRE(hug_intersect_soa(scene, &rays, &bad_hits, 1) == HUG_ERROR_STRUCT_SIZE);
}

/* A counted stream counts what single calls do. */
static void check_counted_streams(const hug_scene *scene)
{
    static hug_ray rays[FIXTURE_RAYS];
    static hug_hit single[FIXTURE_RAYS], hits[FIXTURE_RAYS];
    static uint8_t flags[FIXTURE_RAYS];
    hug_counters one = {0, 0, 0, 0}, all = {0, 0, 0, 0};
    unsigned i;
    for (i = 0; i < FIXTURE_RAYS; i++) {
        rays[i] = fixture_ray(i);
        hug_intersect_counted(scene, &rays[i], &single[i], &one);
    }
    hug_intersect_n_counted(scene, rays, 0, hits, 0, FIXTURE_RAYS, &all);
    REQUIRE(memcmp(single, hits, sizeof single) == 0);
    REQUIRE(all.voxels > 0 && memcmp(&one, &all, sizeof all) == 0);
    for (i = 0; i < FIXTURE_RAYS; i++)
        hug_occluded_counted(scene, &rays[i], &one);
    hug_occluded_n_counted(scene, rays, 0, flags, FIXTURE_RAYS, &all);
    REQUIRE(memcmp(&one, &all, sizeof all) == 0);

    hug_intersect_n_counted(NULL, rays, 0, hits, 0, 1, &all);
    hug_intersect_n_counted(scene, NULL, 0, hits, 0, 1, &all);
    hug_intersect_n_counted(scene, rays, 0, NULL, 0, 1, &all);
    hug_occluded_n_counted(NULL, rays, 0, flags, 1, &all);
    hug_occluded_n_counted(scene, NULL, 0, flags, 1, &all);
    hug_occluded_n_counted(scene, rays, 0, NULL, 1, &all);
    REQUIRE(memcmp(&one, &all, sizeof all) == 0);
    hug_intersect_n_counted(scene, rays, 0, hits, 0, FIXTURE_RAYS, NULL);
    REQUIRE(memcmp(single, hits, sizeof single) == 0);
    memset(flags, 7, sizeof flags);
    hug_occluded_n_counted(scene, rays, 0, flags, FIXTURE_RAYS, NULL);
    for (i = 0; i < FIXTURE_RAYS; i++)
        REQUIRE(flags[i] == (single[i].geom != HUG_NONE));
}

/* A profiled stream counts what single calls do, on the same levels. */
static void check_profiled_streams(const hug_scene *scene)
{
    static hug_ray rays[FIXTURE_RAYS];
    static hug_hit single[FIXTURE_RAYS], hits[FIXTURE_RAYS];
    static uint8_t flags[FIXTURE_RAYS];
    hug_profile one, all;
    unsigned i;
    memset(&one, 0, sizeof one);
    memset(&all, 0, sizeof all);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        rays[i] = fixture_ray(i);
        hug_intersect_profiled(scene, &rays[i], &single[i], &one);
    }
    hug_intersect_n_profiled(scene, rays, 0, hits, 0, FIXTURE_RAYS, &all);
    REQUIRE(memcmp(single, hits, sizeof single) == 0);
    REQUIRE(all.total.passed_2 > 0 && memcmp(&one, &all, sizeof all) == 0);
    for (i = 0; i < FIXTURE_RAYS; i++)
        hug_occluded_profiled(scene, &rays[i], &one);
    hug_occluded_n_profiled(scene, rays, 0, flags, FIXTURE_RAYS, &all);
    REQUIRE(memcmp(&one, &all, sizeof all) == 0);
    for (i = 0; i < FIXTURE_RAYS; i++)
        REQUIRE(flags[i] == (single[i].geom != HUG_NONE));

    hug_intersect_n_profiled(NULL, rays, 0, hits, 0, 1, &all);
    hug_intersect_n_profiled(scene, NULL, 0, hits, 0, 1, &all);
    hug_intersect_n_profiled(scene, rays, 0, NULL, 0, 1, &all);
    hug_occluded_n_profiled(NULL, rays, 0, flags, 1, &all);
    hug_occluded_n_profiled(scene, NULL, 0, flags, 1, &all);
    hug_occluded_n_profiled(scene, rays, 0, NULL, 1, &all);
    REQUIRE(memcmp(&one, &all, sizeof all) == 0);
    memset(hits, 7, sizeof hits);
    hug_intersect_n_profiled(scene, rays, 0, hits, 0, FIXTURE_RAYS, NULL);
    REQUIRE(memcmp(single, hits, sizeof single) == 0);
    memset(flags, 7, sizeof flags);
    hug_occluded_n_profiled(scene, rays, 0, flags, FIXTURE_RAYS, NULL);
    for (i = 0; i < FIXTURE_RAYS; i++)
        REQUIRE(flags[i] == (single[i].geom != HUG_NONE));
}

static void check_structure(const hug_scene *scene)
{
    check_arrays(scene);
    check_counted_streams(scene);
    check_profiled_streams(scene);
}

void check_streams(void)
{
    fixture_structures(check_structure);
}
