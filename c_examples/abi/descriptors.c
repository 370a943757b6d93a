/* Bad descriptors. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"
#include "abi/refuse.h"

/* A descriptor of a later version of the library, with a field that this one lacks. */
typedef struct {
    hug_build_desc known;
    uint64_t later;
} later_desc;

static void check_nulls(const fixture *f)
{
    hug_scene *scene = NULL;
    size_t bytes;
    REFUSE(NULL, HUG_ERROR_NULL);
    EXPECT(hug_build(&f->desc, NULL), HUG_ERROR_NULL);
    EXPECT(hug_build(NULL, NULL), HUG_ERROR_NULL);
    EXPECT(hug_measure(&f->desc, NULL, &bytes), HUG_ERROR_NULL);
    EXPECT(hug_measure(&f->desc, &bytes, NULL), HUG_ERROR_NULL);
    EXPECT(hug_build(&f->desc, &scene), HUG_OK);
    hug_free(scene);
    hug_free(NULL);
}

static void check_struct_size(void)
{
    fixture f;
    later_desc later;
    hug_scene *scene = NULL;
    fixture_make(&f);
    f.desc.struct_size = 0;
    REFUSE(&f.desc, HUG_ERROR_STRUCT_SIZE);
    f.desc.struct_size = 8;
    REFUSE(&f.desc, HUG_ERROR_STRUCT_SIZE);
    f.desc.struct_size = sizeof f.desc - 1;
    REFUSE(&f.desc, HUG_ERROR_STRUCT_SIZE);
    f.desc.struct_size = offsetof(hug_build_desc, quality) - 8;
    REFUSE(&f.desc, HUG_ERROR_STRUCT_SIZE);
    /* a program of the first version: what follows is not looked at */
    f.desc.struct_size = offsetof(hug_build_desc, quality);
    f.desc.quality = 1000;
    EXPECT(hug_build(&f.desc, &scene), HUG_OK);
    hug_free(scene);
    f.desc.quality = 0;
    /* one of the version before clustering */
    f.desc.struct_size = offsetof(hug_build_desc, clustering);
    f.desc.clustering = 1000;
    EXPECT(hug_build(&f.desc, &scene), HUG_OK);
    hug_free(scene);
    f.desc.clustering = 0;
    f.desc.struct_size = sizeof f.desc;
    EXPECT(hug_build((const hug_build_desc *)(const void *)((const char *)&f.desc + 1), &scene),
           HUG_ERROR_ALIGNMENT);

    memset(&later, 0, sizeof later);
    later.known = f.desc;
    later.known.struct_size = sizeof later;
    EXPECT(hug_build(&later.known, &scene), HUG_OK);
    hug_free(scene);
    later.later = 1;
    REFUSE(&later.known, HUG_ERROR_STRUCT_SIZE);
}

static void check_enumerations(void)
{
    static const uint32_t beyond[] = {0, 1000, 0xffffffffu};
    size_t i;
    for (i = 0; i < sizeof beyond / sizeof *beyond; i++) {
        fixture f;
        fixture_make(&f);
        f.desc.structure = beyond[i] ? beyond[i] : HUG_STRUCTURE_HUG + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
        fixture_make(&f);
        f.desc.gridding = beyond[i] ? beyond[i] : HUG_GRIDDING_MIXED + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
        fixture_make(&f);
        f.desc.delta = beyond[i] ? beyond[i] : HUG_DELTA_MEAN + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
        fixture_make(&f);
        f.desc.hierarchy = beyond[i] ? beyond[i] : HUG_HIERARCHY_PAPER + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
        fixture_make(&f);
        f.desc.quality = beyond[i] ? beyond[i] : HUG_QUALITY_HIGH + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
        fixture_make(&f);
        f.desc.clustering = beyond[i] ? beyond[i] : HUG_CLUSTERING_COMPONENTS + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
        fixture_make(&f);
        f.geometry.index_type = beyond[i] ? beyond[i] : HUG_INDEX_U32 + 1;
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
    }
}

/* Sets one float of the descriptor, found by its offset, to a bad value. */
static void check_float(size_t offset, float value)
{
    fixture f;
    fixture_make(&f);
    memcpy((char *)&f.desc + offset, &value, sizeof value);
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
}

static void check_uint(size_t offset, uint32_t value)
{
    fixture f;
    fixture_make(&f);
    memcpy((char *)&f.desc + offset, &value, sizeof value);
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
}

static void check_ranges(void)
{
    static const size_t floats[] = {
        offsetof(hug_build_desc, alpha), offsetof(hug_build_desc, world_alpha),
        offsetof(hug_build_desc, filter_share), offsetof(hug_build_desc, connectivity),
        offsetof(hug_build_desc, overlap_power)};
    size_t i;
    for (i = 0; i < sizeof floats / sizeof *floats; i++) {
        check_float(floats[i], NAN);
        check_float(floats[i], INFINITY);
        check_float(floats[i], -1.0f);
    }
    check_float(offsetof(hug_build_desc, alpha), 0.05f);
    check_float(offsetof(hug_build_desc, alpha), 16.5f);
    check_float(offsetof(hug_build_desc, world_alpha), 16.5f);
    check_float(offsetof(hug_build_desc, filter_share), 1.5f);
    check_float(offsetof(hug_build_desc, overlap_power), 4.5f);
    check_uint(offsetof(hug_build_desc, max_depth), HUG_MAX_LEVELS + 1);
    check_uint(offsetof(hug_build_desc, filter_levels), 4);
    check_uint(offsetof(hug_build_desc, max_refs), 4097);
    check_uint(offsetof(hug_build_desc, reserved), 1);
    check_uint(offsetof(hug_build_desc, counts), 1); /* the other two stay 0 */
    check_uint(offsetof(hug_build_desc, counts), 2049);
}

static void check_flags(void)
{
    fixture f;
    fixture_make(&f);
    f.desc.flags = 32;
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
    f.desc.flags = HUG_BUILD_COMPACT | 0x80000000u;
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
    f.desc.structure = HUG_STRUCTURE_RECURSIVE;
    f.desc.alpha = 0.5f;
    f.desc.flags = HUG_BUILD_FILL_UP | HUG_BUILD_TREE;
    hug_free(fixture_build(&f.desc));
}

static void check_counts(void)
{
    fixture f;
    hug_scene_stats stats;
    hug_scene *scene;
    fixture_make(&f);
    f.desc.structure = HUG_STRUCTURE_UNIFORM;
    f.desc.counts[0] = 3;
    f.desc.counts[1] = 4;
    f.desc.counts[2] = 5;
    scene = fixture_build(&f.desc);
    memset(&stats, 0, sizeof stats);
    stats.struct_size = sizeof stats;
    EXPECT(hug_stats(scene, &stats), HUG_OK);
    REQUIRE(stats.counts[0] == 3 && stats.counts[1] == 4 && stats.counts[2] == 5);
    hug_free(scene);
    f.desc.counts[2] = 2049;
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
    f.desc.counts[2] = 0;
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
}

static void check_thresholds(void)
{
    static const float bad[][2] = {{2, 1}, {1, 1}, {-1, 1}, {NAN, 1}, {1, INFINITY}};
    static const float good[2] = {0.5f, 2};
    fixture f;
    size_t i;
    fixture_make(&f);
    f.desc.structure = HUG_STRUCTURE_HUG;
    f.desc.filter_levels = 3;
    f.desc.filter_thresholds = good;
    hug_free(fixture_build(&f.desc));
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        f.desc.filter_thresholds = bad[i];
        REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
    }
    f.desc.filter_thresholds = good;
    f.desc.filter_levels = HUG_MAX_LEVELS + 1;
    REFUSE(&f.desc, HUG_ERROR_INVALID_VALUE);
}

/* What is told of a scene before it is built. */
static void check_advice(void)
{
    fixture f;
    hug_advice advice;
    hug_clusterings found;
    size_t arena_bytes, scratch_bytes;
    void *scratch;
    hug_reason reason;
    fixture_make(&f);
    memset(&advice, 0, sizeof advice);
    memset(&found, 0, sizeof found);
    EXPECT(hug_advise(&f.desc, NULL), HUG_ERROR_NULL);
    EXPECT(hug_advise(&f.desc, &advice), HUG_ERROR_STRUCT_SIZE);
    advice.struct_size = sizeof advice;
    EXPECT(hug_advise(NULL, &advice), HUG_ERROR_NULL);
    f.desc.alpha = 17;
    EXPECT(hug_advise(&f.desc, &advice), HUG_ERROR_INVALID_VALUE);
    REQUIRE(advice.triangles == 0);
    f.desc.alpha = 0;
    EXPECT(hug_advise(&f.desc, &advice), HUG_OK);
    REQUIRE(advice.triangles > 0 && advice.structure != HUG_STRUCTURE_AUTO);
    REQUIRE(advice.prone == (advice.reason == HUG_REASON_CLUSTERED));
    for (reason = 0; reason <= HUG_REASON_CLUSTERED + 1; reason++)
        REQUIRE(strlen(hug_reason_string(reason)) > 10);

    f.desc.structure = HUG_STRUCTURE_HUG;
    EXPECT(hug_measure(&f.desc, &arena_bytes, &scratch_bytes), HUG_OK);
    scratch = malloc(scratch_bytes);
    REQUIRE(scratch != NULL);
    EXPECT(hug_survey(&f.desc, scratch, scratch_bytes, NULL), HUG_ERROR_NULL);
    EXPECT(hug_survey(&f.desc, NULL, scratch_bytes, &found), HUG_ERROR_NULL);
    EXPECT(hug_survey(&f.desc, scratch, scratch_bytes, &found), HUG_ERROR_STRUCT_SIZE);
    found.struct_size = sizeof found;
    EXPECT(hug_survey(&f.desc, (char *)scratch + 1, scratch_bytes - 1, &found),
           HUG_ERROR_ALIGNMENT);
    EXPECT(hug_survey(&f.desc, scratch, 64, &found), HUG_ERROR_BUFFER_TOO_SMALL);
    EXPECT(hug_survey(&f.desc, &found, sizeof found, &found), HUG_ERROR_OVERLAP);
    EXPECT(hug_survey(&f.desc, scratch, scratch_bytes, &found), HUG_OK);
    REQUIRE(found.triangles >= found.filtered && found.plane_pairs >= found.pairs);
    REQUIRE(found.components.volume >= 1 && found.projections.volume >= 1);
    free(scratch);
}

void check_descriptors(void)
{
    fixture f;
    fixture_make(&f);
    check_nulls(&f);
    check_struct_size();
    check_enumerations();
    check_ranges();
    check_flags();
    check_counts();
    check_thresholds();
    check_advice();
}
