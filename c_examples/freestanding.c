/* What it teaches: hug without an operating system's libraries: no libc, no allocator,
 * static memory. Builds a tetrahedron and shoots at it; exits with 0 if all is right.
 * What it needs of the system, two calls of Linux, is in freestanding/linux.c. */
#include "freestanding/runtime.h"
#include "hug.h"

#define ARENA_BYTES (1u << 20)
#define SCRATCH_BYTES (1u << 20)

static unsigned char arena[ARENA_BYTES] __attribute__((aligned(64)));
static unsigned char scratch[SCRATCH_BYTES] __attribute__((aligned(64)));

/* A tetrahedron: the corner of a cube of side 1. */
static const float vertices[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const uint16_t indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

static int say(const char *text)
{
    runtime_write(text);
    return 0;
}

static const hug_scene *build(void)
{
    hug_geometry geometry;
    hug_build_desc desc;
    const hug_scene *scene = NULL;
    size_t arena_bytes = 0, scratch_bytes = 0;
    hug_status status;

    memset(&geometry, 0, sizeof geometry);
    geometry.vertices = vertices;
    geometry.vertex_count = 4;
    geometry.indices = indices;
    geometry.index_type = HUG_INDEX_U16;
    geometry.triangle_count = 4;

    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.geometries = &geometry;
    desc.geometry_count = 1;

    status = hug_measure(&desc, &arena_bytes, &scratch_bytes);
    if (status == HUG_OK && (arena_bytes > ARENA_BYTES || scratch_bytes > SCRATCH_BYTES)) {
        say("freestanding: four triangles need more than the static memory\n");
        return NULL;
    }
    if (status == HUG_OK)
        status = hug_build_into(&desc, scratch, scratch_bytes, arena, arena_bytes, &scene);
    if (status != HUG_OK) {
        say("freestanding: ");
        say(hug_status_string(status));
        say("\n");
    }
    return scene;
}

static int check_hits(const hug_scene *scene)
{
    /* down onto the slanted face x + y + z = 1, at x = y = 0.25 */
    hug_ray ray = {{0.25f, 0.25f, 2}, 0, {0, 0, -1}, 10, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_hit hit;
    if (!hug_intersect(scene, &ray, &hit))
        return say("freestanding: the ray missed\n");
    if (hit.t != 1.5f || hit.geom != 0 || hit.prim != 3)
        return say("freestanding: another hit than expected\n");
    if (!hug_occluded(scene, &ray))
        return say("freestanding: hit, but not occluded\n");
    ray.org[0] = 0.75f;
    ray.org[1] = 0.75f;
    if (hug_intersect(scene, &ray, &hit) || hug_occluded(scene, &ray))
        return say("freestanding: a ray beside the tetrahedron hit it\n");
    return 1;
}

/* A copy of the arena, opened in place, must be a scene too. */
static int check_reopened(const hug_scene *scene)
{
    const hug_scene *opened = NULL;
    size_t size = 0;
    const void *data = hug_data(scene, &size);
    if (!data || size > SCRATCH_BYTES)
        return say("freestanding: the arena cannot be copied\n");
    memcpy(scratch, data, size);
    if (hug_open(scratch, size, 0, &opened) != HUG_OK)
        return say("freestanding: the copied arena does not open\n");
    return check_hits(opened);
}

int runtime_main(void)
{
    const hug_scene *scene = build();
    if (!scene || !check_hits(scene) || !check_reopened(scene))
        return 1;
    say("freestanding: ok\n");
    return 0;
}
