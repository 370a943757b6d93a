/* What it teaches: hug without an allocator. The program says how much memory a build
 * needs (hug_measure), hands in two blocks of its own, here static arrays, and gets a
 * scene in one of them (hug_build_into). The scratch block is free again afterwards; the
 * scene is a block without pointers, which may be copied: the copy, opened, answers the
 * same. Nothing is freed, for nothing was allocated. Links against the library without
 * std, which could not allocate if it wanted to.
 *
 * usage: bare
 */
#include <stdio.h>
#include <string.h>

#include "lessons/waves.h"

#define SIDE 24

/* C99 has no alignas: a union of the library's alignment would need a type of that; so
 * the blocks are a little larger and are used from the first multiple of 64 on. */
static unsigned char scratch_block[2500000], arena_block[2500000], copy_block[300000];

static unsigned char *align64(unsigned char *at)
{
    return at + (64 - (uintptr_t)at % 64) % 64;
}

static int failed(const char *what, hug_status status)
{
    fprintf(stderr, "bare: %s: %s\n", what, hug_status_string(status));
    return 1;
}

int main(void)
{
    static float vertices[3 * WAVES_VERTICES(SIDE)];
    static uint32_t indices[3 * WAVES_TRIANGLES(SIDE)];
    hug_geometry geometry = waves_geometry(SIDE, vertices, indices);
    hug_build_desc desc = waves_desc(&geometry);
    unsigned char *scratch = align64(scratch_block), *arena = align64(arena_block);
    unsigned char *copy = align64(copy_block);
    size_t arena_bytes, scratch_bytes, size;
    const hug_scene *scene, *moved;
    const void *bytes;
    hug_status status;
    unsigned x, y, hits = 0;

    waves_vertices(SIDE, 0.0f, vertices);
    waves_indices(SIDE, indices);
    status = hug_measure(&desc, &arena_bytes, &scratch_bytes);
    if (status != HUG_OK)
        return failed("hug_measure", status);
    printf("%lu triangles: at most %lu bytes for the scene, %lu to build it in\n",
           (unsigned long)geometry.triangle_count, (unsigned long)arena_bytes,
           (unsigned long)scratch_bytes);
    if (scratch_bytes > sizeof scratch_block - 64 || arena_bytes > sizeof arena_block - 64)
        return failed("the static blocks", HUG_ERROR_BUFFER_TOO_SMALL);

    status = hug_build_into(&desc, scratch, scratch_bytes, arena, arena_bytes, &scene);
    if (status != HUG_OK)
        return failed("hug_build_into", status);
    memset(scratch, 0, scratch_bytes);
    bytes = hug_data(scene, &size);
    printf("it takes %lu bytes\n", (unsigned long)size);

    /* Elsewhere, the first place overwritten: still a scene. */
    if (size > sizeof copy_block - 64)
        return failed("the copy", HUG_ERROR_BUFFER_TOO_SMALL);
    memcpy(copy, bytes, size);
    memset(arena, 0, arena_bytes);
    status = hug_open(copy, size, 0, &moved);
    if (status != HUG_OK)
        return failed("hug_open", status);
    for (y = 0; y < 20; y++, putchar('\n'))
        for (x = 0; x < 60; x++) {
            hug_ray ray = waves_ray(x, 2 * y, 60, 40);
            hug_hit hit;
            hits += (unsigned)hug_intersect(moved, &ray, &hit);
            putchar(" .:-=+*#%@@@"[waves_shade(&hit) / 24]);
        }
    printf("%u of 1200 rays hit\n", hits);
    return hits ? 0 : 1;
}
