/* Profiled queries: the hits of the others, and numbers that add up. */
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

static uint64_t sum_of_levels(const hug_profile *p)
{
    uint64_t sum = 0;
    unsigned i;
    for (i = 0; i < HUG_MAX_LEVELS; i++)
        sum += p->level[i].tests + p->level[i].grids + p->level[i].voxels + p->level[i].hits;
    return sum;
}

static void check_numbers(const hug_scene *scene)
{
    hug_profile profile;
    hug_counters counters;
    unsigned i;
    memset(&profile, 0, sizeof profile);
    memset(&counters, 0, sizeof counters);
    for (i = 0; i < FIXTURE_RAYS; i++) {
        hug_ray ray = fixture_ray(i);
        hug_hit plain, profiled;
        int32_t found = hug_intersect(scene, &ray, &plain);
        REQUIRE(hug_intersect_profiled(scene, &ray, &profiled, &profile) == found);
        REQUIRE(memcmp(&plain, &profiled, sizeof plain) == 0);
        REQUIRE(hug_occluded_profiled(scene, &ray, &profile) == found);
        hug_intersect_counted(scene, &ray, &plain, &counters);
        hug_occluded_counted(scene, &ray, &counters);
    }
    REQUIRE(profile.total.grids == counters.grids && profile.total.voxels == counters.voxels);
    REQUIRE(profile.total.tests == counters.tests && profile.total.hits == counters.hits);
    REQUIRE(sum_of_levels(&profile) ==
            counters.grids + counters.voxels + counters.tests + counters.hits);
    REQUIRE(profile.total.passed_1 <= profile.total.tests);
    REQUIRE(profile.total.passed_2 <= profile.total.passed_1 && profile.total.passed_2 > 0);
}

static void check_bad_pointers(const hug_scene *scene)
{
    hug_profile profile;
    hug_ray ray = fixture_ray(0);
    hug_hit hit, plain;
    /* of any alignment, as rays and hits */
    char bytes[sizeof profile + 1];
    int32_t found = hug_intersect(scene, &ray, &plain);
    memset(&profile, 0, sizeof profile);
    memset(bytes, 0, sizeof bytes);
    REQUIRE(hug_intersect_profiled(NULL, &ray, &hit, &profile) == 0);
    REQUIRE(hug_intersect_profiled(scene, NULL, &hit, &profile) == 0);
    REQUIRE(hug_intersect_profiled(scene, &ray, NULL, &profile) == 0);
    REQUIRE(hug_occluded_profiled(NULL, &ray, &profile) == 0);
    REQUIRE(hug_occluded_profiled(scene, NULL, &profile) == 0);
    REQUIRE(sum_of_levels(&profile) == 0 && profile.total.tests == 0);
    REQUIRE(hug_intersect_profiled(scene, &ray, &hit, NULL) == found);
    REQUIRE(memcmp(&hit, &plain, sizeof hit) == 0);
    REQUIRE(hug_occluded_profiled(scene, &ray, NULL) == found);
    REQUIRE(hug_occluded_profiled(scene, &ray, (hug_profile *)(void *)(bytes + 1)) == found);
    memcpy(&profile, bytes + 1, sizeof profile);
    REQUIRE(sum_of_levels(&profile) > 0);
    /* sums stop at the largest value */
    memset(&profile, 0xff, sizeof profile);
    REQUIRE(hug_occluded_profiled(scene, &ray, &profile) == found);
    REQUIRE(profile.total.voxels == UINT64_MAX && profile.level[0].tests == UINT64_MAX);
}

static void check_structure(const hug_scene *scene)
{
    check_numbers(scene);
    check_bad_pointers(scene);
}

void check_profiles(void)
{
    fixture_structures(check_structure);
}
