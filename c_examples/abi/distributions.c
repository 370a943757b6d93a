/* Histograms of voxels and of lengths: what they say, and what they refuse. */
#include <stddef.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

#define CLASSES 64
#define UNTOUCHED 7

typedef struct {
    uint64_t counts[CLASSES];
    double cumulated[CLASSES];
} arrays;

static void fill(arrays *a)
{
    unsigned i;
    for (i = 0; i < CLASSES; i++) {
        a->counts[i] = UNTOUCHED;
        a->cumulated[i] = UNTOUCHED;
    }
}

/* Whether the sum of the counts is whole, and the distribution reaches it. */
static int adds_up(const arrays *a, uint64_t whole)
{
    uint64_t sum = 0;
    double last = 0;
    unsigned i;
    for (i = 0; i < CLASSES; i++) {
        sum += a->counts[i];
        if (a->cumulated[i] < last || a->cumulated[i] > 100)
            return 0;
        last = a->cumulated[i];
    }
    return sum == whole && last == 100;
}

static hug_voxel_histogram histogram_of(uint32_t level, arrays *a)
{
    hug_voxel_histogram h;
    memset(&h, 0, sizeof h);
    h.struct_size = sizeof h;
    h.level = level;
    h.capacity = CLASSES;
    h.counts = a->counts;
    h.cumulated = a->cumulated;
    return h;
}

static void check_histograms(const hug_scene *scene)
{
    static arrays a;
    hug_scene_stats stats;
    uint32_t level;
    memset(&stats, 0, sizeof stats);
    stats.struct_size = sizeof stats;
    EXPECT(hug_stats(scene, &stats), HUG_OK);
    for (level = 0; level <= stats.levels; level++) {
        int all = level == stats.levels;
        const hug_level_stats *expected = all ? &stats.total : &stats.level[level];
        hug_voxel_histogram h = histogram_of(all ? HUG_ALL_LEVELS : level, &a);
        fill(&a);
        EXPECT(hug_histogram(scene, &h), HUG_OK);
        if (expected->voxels == 0) { /* a filter may leave a level without objects */
            REQUIRE(h.voxels == 0 && h.most == 0 && a.counts[0] == 0 && a.cumulated[0] == 0);
            continue;
        }
        REQUIRE(h.voxels == expected->voxels && adds_up(&a, h.voxels));
        REQUIRE(a.counts[0] == expected->voxels - expected->object_voxels);
        REQUIRE(h.most > 0 && h.most < CLASSES && a.counts[h.most] > 0);
        h.capacity = 2;
        fill(&a);
        EXPECT(hug_histogram(scene, &h), HUG_OK);
        REQUIRE(a.counts[1] == expected->object_voxels && a.counts[2] == UNTOUCHED);
        REQUIRE(a.cumulated[1] == 100 && a.cumulated[2] == UNTOUCHED);
        h.counts = NULL;
        h.cumulated = NULL;
        EXPECT(hug_histogram(scene, &h), HUG_OK);
        REQUIRE(h.voxels == expected->voxels);
    }
}

static void check_bad_histograms(const hug_scene *scene)
{
    static arrays a;
    hug_voxel_histogram good = histogram_of(HUG_ALL_LEVELS, &a), h = good;
    union {
        hug_voxel_histogram first;
        char bytes[sizeof(hug_voxel_histogram) + 8];
    } memory;
    fill(&a);
    memset(&memory, 0, sizeof memory);
    EXPECT(hug_histogram(NULL, &h), HUG_ERROR_NULL);
    EXPECT(hug_histogram(scene, NULL), HUG_ERROR_NULL);
    EXPECT(hug_histogram(scene, (hug_voxel_histogram *)(void *)(memory.bytes + 1)),
           HUG_ERROR_ALIGNMENT);
    EXPECT(hug_histogram(scene, &memory.first), HUG_ERROR_STRUCT_SIZE);
    h.struct_size--;
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_STRUCT_SIZE);
    h = good;
    h.level = HUG_MAX_LEVELS;
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_INVALID_VALUE);
    h = good;
    h.reserved = 1;
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_INVALID_VALUE);
    h = good;
    h.counts = NULL;
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_NULL);
    h = good;
    h.counts = (uint64_t *)(void *)((char *)a.counts + 1);
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_ALIGNMENT);
    h = good;
    h.cumulated = (double *)(void *)(a.counts + 1);
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_OVERLAP);
    h = good;
    h.capacity = SIZE_MAX / 8 + 1;
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_OVERFLOW);
    h.capacity = SIZE_MAX / 8;
    EXPECT(hug_histogram(scene, &h), HUG_ERROR_OVERFLOW);
    REQUIRE(h.voxels == 0 && a.counts[0] == UNTOUCHED && a.cumulated[0] == UNTOUCHED);
}

static void check_lengths(const hug_scene *scene)
{
    static arrays a;
    hug_scene_lengths good, l;
    memset(&good, 0, sizeof good);
    good.struct_size = sizeof good;
    good.capacity = CLASSES;
    good.counts = a.counts;
    good.cumulated = a.cumulated;
    good.share = 1;
    fill(&a);
    l = good;
    EXPECT(hug_lengths(scene, &l), HUG_OK);
    REQUIRE(l.triangles == FIXTURE_TRIANGLES && adds_up(&a, FIXTURE_TRIANGLES));
    REQUIRE(0 < l.min && l.min <= l.max && l.max <= l.diagonal);
    REQUIRE(l.below_fifth == 0 && a.counts[0] == 0 && a.counts[CLASSES - 1] > 0);
    l = good;
    l.share = 0;
    EXPECT(hug_lengths(scene, &l), HUG_OK);
    REQUIRE(a.cumulated[CLASSES - 1] == 0);
    EXPECT(hug_lengths(NULL, &l), HUG_ERROR_NULL);
    EXPECT(hug_lengths(scene, NULL), HUG_ERROR_NULL);
    l.struct_size--;
    EXPECT(hug_lengths(scene, &l), HUG_ERROR_STRUCT_SIZE);
    l = good;
    l.share = -1;
    EXPECT(hug_lengths(scene, &l), HUG_ERROR_INVALID_VALUE);
    l.share = l.share / 0.0;
    EXPECT(hug_lengths(scene, &l), HUG_ERROR_INVALID_VALUE);
    l.share = l.share * 0;
    EXPECT(hug_lengths(scene, &l), HUG_ERROR_INVALID_VALUE);
    l = good;
    l.counts = NULL;
    EXPECT(hug_lengths(scene, &l), HUG_ERROR_NULL);
    l.cumulated = NULL;
    EXPECT(hug_lengths(scene, &l), HUG_OK);
}

/* A program that knows the first version of hug_scene_stats only. */
static void check_older_stats(const hug_scene *scene)
{
    hug_scene_stats stats;
    memset(&stats, UNTOUCHED, sizeof stats);
    stats.struct_size = offsetof(hug_scene_stats, total_share);
    EXPECT(hug_stats(scene, &stats), HUG_OK);
    REQUIRE(stats.triangles == FIXTURE_TRIANGLES && stats.total.objects >= FIXTURE_TRIANGLES);
    REQUIRE(*(const unsigned char *)&stats.total_share == UNTOUCHED);
    stats.struct_size = sizeof stats;
    EXPECT(hug_stats(scene, &stats), HUG_OK);
    REQUIRE(stats.total_share.voxels == 100 && stats.total_share.volume >= 99.999);
    stats.struct_size = offsetof(hug_scene_stats, total_share) - 1;
    EXPECT(hug_stats(scene, &stats), HUG_ERROR_STRUCT_SIZE);
}

static void check_structure(const hug_scene *scene)
{
    check_histograms(scene);
    check_bad_histograms(scene);
    check_lengths(scene);
    check_older_stats(scene);
}

void check_distributions(void)
{
    fixture_structures(check_structure);
}
