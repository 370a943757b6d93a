/* What a scene and the library say of themselves. */
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

static void check_stats(const hug_scene *scene, hug_structure structure)
{
    union {
        hug_scene_stats stats;
        char bytes[sizeof(hug_scene_stats) + 8];
    } memory;
    hug_scene_stats *stats = &memory.stats;
    size_t size;
    memset(&memory, 0, sizeof memory);
    EXPECT(hug_stats(scene, stats), HUG_ERROR_STRUCT_SIZE);
    stats->struct_size = sizeof *stats - 1;
    EXPECT(hug_stats(scene, stats), HUG_ERROR_STRUCT_SIZE);
    stats->struct_size = sizeof *stats;
    EXPECT(hug_stats(NULL, stats), HUG_ERROR_NULL);
    EXPECT(hug_stats(scene, NULL), HUG_ERROR_NULL);
    EXPECT(hug_stats(scene, (hug_scene_stats *)(void *)(memory.bytes + 1)), HUG_ERROR_ALIGNMENT);
    EXPECT(hug_stats(scene, stats), HUG_OK);
    hug_data(scene, &size);
    REQUIRE(stats->structure == structure);
    REQUIRE(stats->triangles == FIXTURE_TRIANGLES);
    REQUIRE(stats->levels >= 1 && stats->levels <= HUG_MAX_LEVELS);
    REQUIRE(stats->bytes == size);
    REQUIRE(stats->total.objects == FIXTURE_TRIANGLES);
    REQUIRE(stats->total.object_refs >= FIXTURE_TRIANGLES);
}

static void check_bounds(const hug_scene *scene)
{
    float lower[3], upper[3];
    EXPECT(hug_bounds(NULL, lower, upper), HUG_ERROR_NULL);
    EXPECT(hug_bounds(scene, NULL, upper), HUG_ERROR_NULL);
    EXPECT(hug_bounds(scene, lower, NULL), HUG_ERROR_NULL);
    EXPECT(hug_bounds(scene, lower, upper), HUG_OK);
    REQUIRE(lower[0] == 0 && lower[1] == 0 && lower[2] == 0);
    REQUIRE(upper[0] == FIXTURE_SIDE && upper[1] == FIXTURE_SIDE && upper[2] == 1.5f);
}

static void check_data(const hug_scene *scene)
{
    size_t size = 7;
    REQUIRE(hug_data(NULL, &size) == NULL && size == 0);
    REQUIRE(hug_data(NULL, NULL) == NULL);
    REQUIRE(hug_data(scene, NULL) == (const void *)scene);
    REQUIRE(hug_data(scene, &size) == (const void *)scene && size > 0);
}

static void check_strings(void)
{
    hug_status status;
    for (status = HUG_OK; status <= HUG_ERROR_UNFINISHED; status++)
        REQUIRE(hug_status_string(status) && *hug_status_string(status) &&
                strcmp(hug_status_string(status), hug_status_string(-1)) != 0);
    REQUIRE(hug_status_string(INT32_MIN) && hug_status_string(INT32_MAX));
    REQUIRE(hug_version() && strchr(hug_version(), '.'));
    REQUIRE(hug_abi_version() == 1);
}

/* The instruction set changes no bit of a hit. */
static void check_isa(const hug_scene *scene)
{
    static hug_hit before[FIXTURE_RAYS], after[FIXTURE_RAYS];
    const char *isa = hug_isa();
    REQUIRE(isa && *isa);
    EXPECT(hug_force_isa(NULL), HUG_ERROR_NULL);
    EXPECT(hug_force_isa(""), HUG_ERROR_INVALID_VALUE);
    EXPECT(hug_force_isa("port"), HUG_ERROR_INVALID_VALUE);
    EXPECT(hug_force_isa("portable "), HUG_ERROR_INVALID_VALUE);
    REQUIRE(strcmp(hug_isa(), isa) == 0);
    fixture_hits(scene, before);
    EXPECT(hug_force_isa("portable"), HUG_OK);
    REQUIRE(strcmp(hug_isa(), "portable") == 0);
    fixture_hits(scene, after);
    REQUIRE(memcmp(before, after, sizeof before) == 0);
    EXPECT(hug_force_isa(isa), HUG_OK);
    REQUIRE(strcmp(hug_isa(), isa) == 0);
}

void check_statistics(void)
{
    hug_structure structure;
    for (structure = HUG_STRUCTURE_UNIFORM; structure <= HUG_STRUCTURE_HUG; structure++) {
        fixture f;
        hug_scene *scene;
        fixture_make(&f);
        f.desc.structure = structure;
        scene = fixture_build(&f.desc);
        check_stats(scene, structure);
        check_bounds(scene);
        check_data(scene);
        check_isa(scene);
        hug_free(scene);
    }
    check_strings();
}
