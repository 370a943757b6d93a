/* Queries: NULL, strides, and rays that must miss. */
#include <math.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

/* A ray and its hit as a caller might keep them. */
typedef struct {
    uint32_t before;
    hug_ray ray;
    hug_hit hit;
    uint32_t after;
} pixel;

static int is_miss(const hug_hit *hit, float t)
{
    return hit->geom == HUG_NONE && hit->prim == HUG_NONE && hit->inst == HUG_NONE &&
           hit->t == t && hit->u == 0 && hit->v == 0 && hit->ng[0] == 0 && hit->ng[1] == 0 &&
           hit->ng[2] == 0 && hit->reserved == 0;
}

static void check_nulls(const hug_scene *scene)
{
    hug_ray ray = fixture_ray(50);
    hug_hit hit;
    hug_counters counters;
    uint8_t flag = 7;
    memset(&counters, 0, sizeof counters);
    REQUIRE(hug_intersect(NULL, &ray, &hit) == 0 && is_miss(&hit, INFINITY));
    REQUIRE(hug_intersect(scene, NULL, &hit) == 0 && is_miss(&hit, INFINITY));
    REQUIRE(hug_intersect(scene, &ray, NULL) == 0);
    REQUIRE(hug_occluded(NULL, &ray) == 0);
    REQUIRE(hug_occluded(scene, NULL) == 0);
    REQUIRE(hug_intersect_counted(NULL, &ray, &hit, &counters) == 0);
    REQUIRE(hug_intersect_counted(scene, NULL, &hit, &counters) == 0);
    REQUIRE(hug_intersect_counted(scene, &ray, NULL, &counters) == 0);
    REQUIRE(hug_intersect_counted(scene, &ray, &hit, NULL) == 1);
    REQUIRE(hug_occluded_counted(NULL, &ray, &counters) == 0);
    REQUIRE(hug_occluded_counted(scene, NULL, &counters) == 0);
    REQUIRE(hug_occluded_counted(scene, &ray, NULL) == 1);
    REQUIRE(counters.grids == 0 && counters.voxels == 0 && counters.tests == 0);

    hit.geom = 7;
    hug_intersect_n(NULL, &ray, 0, &hit, 0, 1);
    hug_intersect_n(scene, NULL, 0, &hit, 0, 1);
    hug_intersect_n(scene, &ray, 0, NULL, 0, 1);
    hug_intersect_n(scene, &ray, 0, &hit, 0, 0);
    REQUIRE(hit.geom == 7);
    hug_occluded_n(NULL, &ray, 0, &flag, 1);
    hug_occluded_n(scene, NULL, 0, &flag, 1);
    hug_occluded_n(scene, &ray, 0, NULL, 1);
    hug_occluded_n(scene, &ray, 0, &flag, 0);
    REQUIRE(flag == 7);
}

/* As many steps as are counted suffice, one fewer do not. */
static void check_budgets(const hug_scene *scene)
{
    uint64_t most = 0;
    unsigned i;
    EXPECT(hug_most_steps(NULL, &most), HUG_ERROR_NULL);
    EXPECT(hug_most_steps(scene, NULL), HUG_ERROR_NULL);
    EXPECT(hug_most_steps(scene, &most), HUG_OK);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        hug_ray ray = fixture_ray(i);
        hug_hit expected, hit;
        hug_counters c;
        uint64_t steps;
        int32_t found;
        memset(&c, 0, sizeof c);
        found = hug_intersect_counted(scene, &ray, &expected, &c);
        steps = c.grids + c.voxels + c.tests;
        REQUIRE(steps <= most);
        REQUIRE(hug_intersect_within(scene, &ray, &hit, steps) == found);
        REQUIRE(memcmp(&hit, &expected, sizeof hit) == 0);
        REQUIRE(hug_occluded_within(scene, &ray, most) == found);
        if (steps > 0) {
            REQUIRE(hug_intersect_within(scene, &ray, &hit, steps - 1) == HUG_TRUNCATED);
            REQUIRE(is_miss(&hit, ray.tmax));
            REQUIRE(hug_occluded_within(scene, &ray, 0) == HUG_TRUNCATED);
        }
        REQUIRE(hug_intersect_within(scene, NULL, &hit, most) == 0);
        REQUIRE(hug_intersect_within(scene, &ray, NULL, most) == 0);
        REQUIRE(hug_intersect_within(NULL, &ray, &hit, most) == 0 && is_miss(&hit, INFINITY));
        REQUIRE(hug_occluded_within(NULL, &ray, most) == 0);
        REQUIRE(hug_occluded_within(scene, NULL, most) == 0);
    }
}

/* Packed, and as fields of one array: the results of single calls, and nothing else
 * of the array is written. */
static void check_strides(const hug_scene *scene)
{
    static hug_ray rays[FIXTURE_RAYS];
    static hug_hit single[FIXTURE_RAYS], packed[FIXTURE_RAYS];
    static pixel pixels[FIXTURE_RAYS];
    static uint8_t flags[FIXTURE_RAYS];
    unsigned i, hits = 0;
    int same = 1;
    for (i = 0; i < FIXTURE_RAYS; i++) {
        rays[i] = pixels[i].ray = fixture_ray(i);
        pixels[i].before = pixels[i].after = i;
    }
    fixture_hits(scene, single);
    hug_intersect_n(scene, rays, 0, packed, 0, FIXTURE_RAYS);
    REQUIRE(memcmp(single, packed, sizeof single) == 0);
    hug_intersect_n(scene, &pixels[0].ray, sizeof(pixel), &pixels[0].hit, sizeof(pixel),
                    FIXTURE_RAYS);
    hug_occluded_n(scene, &pixels[0].ray, sizeof(pixel), flags, FIXTURE_RAYS);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        int hit = single[i].geom != HUG_NONE;
        same = same && memcmp(&pixels[i].hit, &single[i], sizeof single[i]) == 0 &&
               memcmp(&pixels[i].ray, &rays[i], sizeof rays[i]) == 0 && pixels[i].before == i &&
               pixels[i].after == i && flags[i] == hit && hug_occluded(scene, &rays[i]) == hit;
        hits += (unsigned)hit;
    }
    REQUIRE(same);
    REQUIRE(hits > FIXTURE_RAYS / 2 && hits < FIXTURE_RAYS);
}

static void check_misses(const hug_scene *scene)
{
    static const size_t floats[] = {0, 4, 8, 12, 16, 20, 24, 28}; /* offsets of org to tmax */
    static const float bad[] = {NAN, INFINITY, -INFINITY};
    hug_ray good = fixture_ray(50), ray;
    hug_hit hit;
    size_t i, j;
    REQUIRE(hug_intersect(scene, &good, &hit) == 1);
    for (i = 0; i < sizeof floats / sizeof *floats; i++) {
        int limit = floats[i] == offsetof(hug_ray, tmin) || floats[i] == offsetof(hug_ray, tmax);
        for (j = 0; j < (limit ? 1u : 3u); j++) {
            ray = good;
            memcpy((char *)&ray + floats[i], &bad[j], sizeof bad[j]);
            REQUIRE(hug_intersect(scene, &ray, &hit) == 0 && hit.geom == HUG_NONE);
            REQUIRE(hug_occluded(scene, &ray) == 0);
        }
    }
    ray = good;
    ray.dir[0] = ray.dir[1] = ray.dir[2] = 0;
    REQUIRE(hug_intersect(scene, &ray, &hit) == 0 && is_miss(&hit, ray.tmax));
    ray = good;
    ray.tmin = 2 * ray.tmax;
    REQUIRE(hug_intersect(scene, &ray, &hit) == 0 && is_miss(&hit, ray.tmax));
    ray = good;
    ray.mask = 0;
    REQUIRE(hug_intersect(scene, &ray, &hit) == 0 && is_miss(&hit, ray.tmax));
}

/* Both ends of the range belong to it; the skipped triangle does not. */
static void check_range(const hug_scene *scene)
{
    hug_ray ray = fixture_ray(50);
    hug_hit first, hit;
    ray.org[0] = ray.org[1] = 2.25f; /* inside a triangle, not on an edge */
    ray.tmin = -INFINITY;
    ray.tmax = INFINITY;
    REQUIRE(hug_intersect(scene, &ray, &first) == 1);
    ray.tmin = ray.tmax = first.t;
    REQUIRE(hug_intersect(scene, &ray, &hit) == 1 && hit.prim == first.prim);
    ray.tmin = ray.tmax = nextafterf(first.t, INFINITY);
    REQUIRE(hug_intersect(scene, &ray, &hit) == 0);
    ray.tmin = 0;
    ray.tmax = 100;
    ray.skip_geom = first.geom;
    ray.skip_prim = first.prim;
    REQUIRE(hug_intersect(scene, &ray, &hit) == 0);
    ray.skip_prim = first.prim + 1;
    REQUIRE(hug_intersect(scene, &ray, &hit) == 1 && hit.prim == first.prim);
}

static void check_counters(const hug_scene *scene)
{
    hug_ray ray = fixture_ray(50);
    hug_hit plain, counted;
    hug_counters once, twice;
    memset(&once, 0, sizeof once);
    hug_intersect(scene, &ray, &plain);
    REQUIRE(hug_intersect_counted(scene, &ray, &counted, &once) == 1);
    REQUIRE(memcmp(&plain, &counted, sizeof plain) == 0);
    REQUIRE(once.grids > 0 && once.voxels > 0 && once.tests > 0 && once.hits > 0);
    twice = once;
    hug_intersect_counted(scene, &ray, &counted, &twice);
    REQUIRE(twice.grids == 2 * once.grids && twice.voxels == 2 * once.voxels &&
            twice.tests == 2 * once.tests && twice.hits == 2 * once.hits);
    memset(&twice, 0xff, sizeof twice);
    REQUIRE(hug_occluded_counted(scene, &ray, &twice) == 1);
    REQUIRE(twice.voxels == UINT64_MAX); /* full, not wrapped */
}

static void check_structure(const hug_scene *scene)
{
    check_nulls(scene);
    check_strides(scene);
    check_misses(scene);
    check_range(scene);
    check_counters(scene);
    check_budgets(scene);
}

void check_queries(void)
{
    fixture_structures(check_structure);
}
