/* hug_find_fault names what a build does not take. */
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

static void expect_fault(const hug_build_desc *desc, hug_status status, uint32_t geom,
                         uint32_t prim)
{
    uint32_t found_geom = 7, found_prim = 7;
    hug_scene *scene;
    EXPECT(hug_build(desc, &scene), status);
    hug_free(scene);
    EXPECT(hug_find_fault(desc, &found_geom, &found_prim), status);
    REQUIRE(found_geom == geom && found_prim == prim);
}

void check_faults(void)
{
    fixture f;
    hug_geometry list[3];
    uint16_t wrong[3 * FIXTURE_TRIANGLES];
    uint32_t geom, prim;
    int i;
    fixture_make(&f);
    for (i = 0; i < 3; i++)
        list[i] = f.geometry;
    f.desc.geometries = list;
    f.desc.geometry_count = 3;
    expect_fault(&f.desc, HUG_OK, HUG_NONE, HUG_NONE);

    memcpy(wrong, f.short_indices, sizeof wrong);
    wrong[3 * 40 + 1] = wrong[3 * 90] = FIXTURE_VERTICES;
    list[1].indices = wrong;
    list[1].index_type = HUG_INDEX_U16;
    expect_fault(&f.desc, HUG_ERROR_INDEX_RANGE, 1, 40);
    wrong[3 * 40 + 1] = 0;
    expect_fault(&f.desc, HUG_ERROR_INDEX_RANGE, 1, 90);

    list[1] = f.geometry;
    list[2].vertex_stride = 10;
    expect_fault(&f.desc, HUG_ERROR_ALIGNMENT, 2, HUG_NONE);
    list[2] = f.geometry;
    list[0].vertices = NULL;
    expect_fault(&f.desc, HUG_ERROR_NULL, 0, HUG_NONE);
    list[0] = f.geometry;

    f.desc.alpha = -1;
    expect_fault(&f.desc, HUG_ERROR_INVALID_VALUE, HUG_NONE, HUG_NONE);
    f.desc.struct_size = 8;
    expect_fault(&f.desc, HUG_ERROR_STRUCT_SIZE, HUG_NONE, HUG_NONE);
    EXPECT(hug_find_fault(NULL, &geom, &prim), HUG_ERROR_NULL);
    EXPECT(hug_find_fault(&f.desc, NULL, &prim), HUG_ERROR_NULL);
    EXPECT(hug_find_fault(&f.desc, &geom, NULL), HUG_ERROR_NULL);
}
