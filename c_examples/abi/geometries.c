/* Bad geometries, and odd ones that are none the less valid. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"
#include "abi/refuse.h"

static void check_nulls(void)
{
    fixture f;
    fixture_make(&f);
    f.geometry.vertices = NULL;
    REFUSE(&f.desc, HUG_ERROR_NULL);
    fixture_make(&f);
    f.geometry.indices = NULL;
    REFUSE(&f.desc, HUG_ERROR_NULL);
    fixture_make(&f);
    f.desc.geometries = NULL;
    REFUSE(&f.desc, HUG_ERROR_NULL);
}

static void check_alignment(void)
{
    fixture f;
    fixture_make(&f);
    f.geometry.vertex_stride = 14;
    REFUSE(&f.desc, HUG_ERROR_ALIGNMENT);
    f.geometry.vertex_stride = 8;
    REFUSE(&f.desc, HUG_ERROR_ALIGNMENT);
    fixture_make(&f);
    f.geometry.vertices = (const float *)(const void *)((const char *)f.vertices + 2);
    f.geometry.vertex_count--;
    REFUSE(&f.desc, HUG_ERROR_ALIGNMENT);
    fixture_make(&f);
    f.geometry.indices = (const char *)f.indices + 2;
    f.geometry.triangle_count--;
    REFUSE(&f.desc, HUG_ERROR_ALIGNMENT);
    fixture_make(&f);
    f.geometry.indices = (const char *)f.short_indices + 1;
    f.geometry.index_type = HUG_INDEX_U16;
    f.geometry.triangle_count--;
    REFUSE(&f.desc, HUG_ERROR_ALIGNMENT);
    fixture_make(&f);
    f.desc.geometries = (const hug_geometry *)(const void *)((const char *)&f.geometry + 1);
    REFUSE(&f.desc, HUG_ERROR_ALIGNMENT);
}

static void check_sizes(void)
{
    fixture f;
    fixture_make(&f);
    f.desc.geometry_count = (size_t)-1;
    REFUSE(&f.desc, HUG_ERROR_OVERFLOW);
    fixture_make(&f);
    f.geometry.vertex_count = (size_t)-1;
    REFUSE(&f.desc, HUG_ERROR_OVERFLOW);
    fixture_make(&f);
    f.geometry.vertex_stride = (size_t)-4;
    REFUSE(&f.desc, HUG_ERROR_OVERFLOW);
    fixture_make(&f);
    f.geometry.triangle_count = (size_t)-1;
    REFUSE(&f.desc, HUG_ERROR_OVERFLOW);
    fixture_make(&f);
    f.geometry.triangle_count = (size_t)1 << 31;
    REFUSE(&f.desc, HUG_ERROR_LIMIT);
}

static void check_indices(void)
{
    fixture f;
    fixture_make(&f);
    f.indices[3 * FIXTURE_TRIANGLES - 1] = FIXTURE_VERTICES;
    REFUSE_BUILD(&f.desc, HUG_ERROR_INDEX_RANGE);
    f.indices[3 * FIXTURE_TRIANGLES - 1] = 0xffffffffu;
    REFUSE_BUILD(&f.desc, HUG_ERROR_INDEX_RANGE);
    fixture_make(&f);
    f.geometry.index_type = HUG_INDEX_U16;
    f.geometry.indices = f.short_indices;
    f.short_indices[0] = 0xffff;
    REFUSE_BUILD(&f.desc, HUG_ERROR_INDEX_RANGE);
    fixture_make(&f);
    f.geometry.index_type = HUG_INDEX_NONE;
    f.geometry.triangle_count = FIXTURE_VERTICES / 3 + 1;
    REFUSE(&f.desc, HUG_ERROR_INDEX_RANGE);
}

/* More references than max_refs allows, at counts that leave no other way out. */
static void check_limit(void)
{
    static const float vertices[9] = {0, 0, 0, 1, 0, 1, 0, 1, 1};
    fixture f;
    int axis;
    fixture_make(&f);
    f.geometry.vertices = vertices;
    f.geometry.vertex_count = 3;
    f.geometry.index_type = HUG_INDEX_NONE;
    f.geometry.triangle_count = 1;
    f.desc.structure = HUG_STRUCTURE_UNIFORM;
    f.desc.max_refs = 1;
    for (axis = 0; axis < 3; axis++)
        f.desc.counts[axis] = 16;
    REFUSE_BUILD(&f.desc, HUG_ERROR_LIMIT);
}

/* Indices of 16 and of 32 bits, and a stride, must make the same scene. */
static void check_layouts(void)
{
    fixture f;
    float wide[5 * FIXTURE_VERTICES];
    hug_hit expected[FIXTURE_RAYS], hits[FIXTURE_RAYS];
    hug_scene *scene;
    int i;
    fixture_make(&f);
    scene = fixture_build(&f.desc);
    fixture_hits(scene, expected);
    hug_free(scene);
    for (i = 0; i < FIXTURE_VERTICES; i++) {
        memcpy(wide + 5 * i, f.vertices + 3 * i, 3 * sizeof(float));
        wide[5 * i + 3] = wide[5 * i + 4] = NAN;
    }
    f.geometry.vertices = wide;
    f.geometry.vertex_stride = 5 * sizeof(float);
    f.geometry.index_type = HUG_INDEX_U16;
    f.geometry.indices = f.short_indices;
    scene = fixture_build(&f.desc);
    fixture_hits(scene, hits);
    REQUIRE(memcmp(expected, hits, sizeof hits) == 0);
    hug_free(scene);
}

/* Triangles that are not finite or have no area are dropped and counted, and the
 * ids of the others stay. */
static void check_dropped(void)
{
    fixture f;
    hug_scene_stats stats;
    hug_scene *scene;
    hug_ray ray = {{7.9f, 7.9f, 4}, 0, {0, 0, -1}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_hit hit;
    fixture_make(&f);
    f.vertices[2] = NAN;          /* of triangle 0 only */
    f.vertices[3 * 8] = INFINITY; /* of triangles 14 and 15 */
    f.indices[3 * 40] = f.indices[3 * 40 + 1];
    scene = fixture_build(&f.desc);
    memset(&stats, 0, sizeof stats);
    stats.struct_size = sizeof stats;
    EXPECT(hug_stats(scene, &stats), HUG_OK);
    REQUIRE(stats.dropped_non_finite == 3);
    REQUIRE(stats.dropped_degenerate == 1);
    REQUIRE(stats.triangles == FIXTURE_TRIANGLES - 4);
    REQUIRE(hug_intersect(scene, &ray, &hit) == 1 && hit.prim == FIXTURE_TRIANGLES - 1);
    hug_free(scene);
}

static void check_empty_scene(const hug_build_desc *desc)
{
    hug_scene *scene = fixture_build(desc);
    hug_ray ray = fixture_ray(50);
    hug_hit hit;
    float lower[3], upper[3];
    REQUIRE(hug_intersect(scene, &ray, &hit) == 0 && hit.geom == HUG_NONE && hit.t == ray.tmax);
    REQUIRE(hug_occluded(scene, &ray) == 0);
    EXPECT(hug_bounds(scene, lower, upper), HUG_OK);
    REQUIRE(lower[0] == INFINITY && upper[2] == -INFINITY);
    hug_free(scene);
}

static void check_empty(void)
{
    fixture f;
    hug_structure structure;
    for (structure = HUG_STRUCTURE_AUTO; structure <= HUG_STRUCTURE_HUG; structure++) {
        fixture_make(&f);
        f.desc.structure = structure;
        f.geometry.triangle_count = 0;
        check_empty_scene(&f.desc);
        f.geometry.vertices = NULL;
        f.geometry.vertex_count = 0;
        f.geometry.indices = NULL;
        check_empty_scene(&f.desc);
        f.desc.geometries = NULL;
        f.desc.geometry_count = 0;
        check_empty_scene(&f.desc);
    }
}

void check_geometries(void)
{
    check_nulls();
    check_alignment();
    check_sizes();
    check_indices();
    check_limit();
    check_layouts();
    check_dropped();
    check_empty();
}
