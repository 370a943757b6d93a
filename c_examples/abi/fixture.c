#define _POSIX_C_SOURCE 200809L
#include "abi/fixture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void make_vertices(fixture *f)
{
    int x, y;
    float *at = f->vertices;
    for (y = 0; y <= FIXTURE_SIDE; y++) {
        for (x = 0; x <= FIXTURE_SIDE; x++) {
            *at++ = (float)x;
            *at++ = (float)y;
            *at++ = 0.25f * (float)((3 * x + 5 * y) % 7);
        }
    }
}

static void make_indices(fixture *f)
{
    unsigned x, y, i;
    uint32_t *at = f->indices;
    for (y = 0; y < FIXTURE_SIDE; y++) {
        for (x = 0; x < FIXTURE_SIDE; x++) {
            uint32_t corner = y * (FIXTURE_SIDE + 1) + x;
            *at++ = corner;
            *at++ = corner + 1;
            *at++ = corner + FIXTURE_SIDE + 1;
            *at++ = corner + 1;
            *at++ = corner + FIXTURE_SIDE + 2;
            *at++ = corner + FIXTURE_SIDE + 1;
        }
    }
    for (i = 0; i < 3 * FIXTURE_TRIANGLES; i++)
        f->short_indices[i] = (uint16_t)f->indices[i];
}

void fixture_make(fixture *f)
{
    memset(f, 0, sizeof *f);
    make_vertices(f);
    make_indices(f);
    f->geometry.vertices = f->vertices;
    f->geometry.vertex_count = FIXTURE_VERTICES;
    f->geometry.indices = f->indices;
    f->geometry.index_type = HUG_INDEX_U32;
    f->geometry.triangle_count = FIXTURE_TRIANGLES;
    f->desc.struct_size = sizeof f->desc;
    f->desc.geometries = &f->geometry;
    f->desc.geometry_count = 1;
}

hug_ray fixture_ray(unsigned i)
{
    hug_ray ray = {{0, 0, 4}, 0, {0, 0, -1}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    /* from -0.5 to 9: beyond the sheet on both sides, and on its edges too */
    ray.org[0] = 0.5f * (float)(i % 20) - 0.5f;
    ray.org[1] = 0.5f * (float)(i / 20 % 20) - 0.5f;
    ray.dir[0] = 0.125f * (float)(i % 3);
    return ray;
}

void fixture_hits(const hug_scene *scene, hug_hit hits[FIXTURE_RAYS])
{
    unsigned i;
    for (i = 0; i < FIXTURE_RAYS; i++) {
        hug_ray ray = fixture_ray(i);
        hug_intersect(scene, &ray, &hits[i]);
    }
}

void *fixture_memory(size_t size)
{
    void *memory = NULL;
    if (posix_memalign(&memory, 64, size ? size : 1) != 0) {
        fprintf(stderr, "abi_errors: no memory\n");
        exit(2);
    }
    return memory;
}

hug_scene *fixture_build(const hug_build_desc *desc)
{
    hug_scene *scene = NULL;
    hug_status status = hug_build(desc, &scene);
    if (status != HUG_OK) {
        fprintf(stderr, "abi_errors: cannot build a scene to check with: %s\n",
                hug_status_string(status));
        exit(2);
    }
    return scene;
}

void fixture_structures(void (*check)(const hug_scene *scene))
{
    hug_structure structure;
    for (structure = HUG_STRUCTURE_AUTO; structure <= HUG_STRUCTURE_HUG; structure++) {
        fixture f;
        hug_scene *scene;
        fixture_make(&f);
        f.desc.structure = structure;
        scene = fixture_build(&f.desc);
        check(scene);
        hug_free(scene);
    }
}
