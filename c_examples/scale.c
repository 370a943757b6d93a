/* What it teaches: as many triangles as memory holds. Builds a sheet of N triangles and
 * sends rays down onto it, each of which must hit the one triangle that lies there.
 *
 *     scale [TRIANGLES [MAX_REFS [STRUCTURE]]]
 *
 * 50000000, 4 and 0 (AUTO) if left out. A smaller MAX_REFS makes the bound smaller that
 * the build's scratch memory is allocated by, which is for the worst of soups; a sheet
 * needs two or three references a triangle. If there is too little memory, that is what
 * the build says, and the exit status is 3. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "hug.h"

#define RAYS 1000000u

/* A sheet of side x side squares of two triangles. */
typedef struct {
    uint32_t side;
    size_t triangles;
    float *vertices;
    uint32_t *indices;
} sheet;

/* Marsaglia's xorshift */
static uint32_t drawn = 2463534242u;

static uint32_t draw(void)
{
    drawn ^= drawn << 13;
    drawn ^= drawn >> 17;
    drawn ^= drawn << 5;
    return drawn;
}

static double seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static int make(sheet *s, size_t triangles)
{
    size_t x, y, rows;
    uint32_t *index;
    float *vertex;
    s->side = 1;
    while (2 * (size_t)s->side * s->side < triangles)
        s->side++;
    rows = (size_t)s->side + 1;
    s->triangles = 2 * (size_t)s->side * s->side;
    s->vertices = vertex = (float *)malloc(rows * rows * 3 * sizeof *vertex);
    s->indices = index = (uint32_t *)malloc(s->triangles * 3 * sizeof *index);
    if (!vertex || !index)
        return 0;
    for (y = 0; y < rows; y++) {
        for (x = 0; x < rows; x++, vertex += 3) {
            vertex[0] = (float)x;
            vertex[1] = (float)y;
            vertex[2] = (float)(draw() >> 24) / 64.0f;
        }
    }
    for (y = 0; y < s->side; y++) {
        for (x = 0; x < s->side; x++, index += 6) {
            uint32_t corner = (uint32_t)(y * rows + x), above = corner + (uint32_t)rows;
            index[0] = corner;
            index[1] = corner + 1;
            index[2] = above + 1;
            index[3] = corner;
            index[4] = above + 1;
            index[5] = above;
        }
    }
    return 1;
}

/* Down onto a square: right of its diagonal, or left of it. */
static int trace(const hug_scene *scene, const sheet *s)
{
    hug_ray ray = {{0, 0, 100}, 0, {0, 0, -1}, 1000, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_hit hit;
    uint32_t i;
    for (i = 0; i < RAYS; i++) {
        uint32_t x = draw() % s->side, y = draw() % s->side, half = draw() & 1;
        uint32_t expected = 2 * (y * s->side + x) + half;
        ray.org[0] = (float)x + (half ? 0.25f : 0.75f);
        ray.org[1] = (float)y + (half ? 0.75f : 0.25f);
        if (hug_intersect(scene, &ray, &hit) != 1 || hit.prim != expected) {
            fprintf(stderr, "scale: ray %" PRIu32 " hit %" PRIu32 ", not %" PRIu32 "\n", i,
                    hit.prim, expected);
            return 0;
        }
    }
    return 1;
}

int main(int argc, char **argv)
{
    size_t triangles = argc > 1 ? (size_t)strtoull(argv[1], NULL, 10) : 50000000u;
    size_t arena = 0, scratch = 0;
    sheet s;
    hug_geometry mesh;
    hug_build_desc desc;
    hug_scene *scene = NULL;
    hug_status status;
    double start;

    if (triangles == 0 || triangles > 1u << 30 || !make(&s, triangles)) {
        fprintf(stderr, "scale: no memory for so many triangles\n");
        return 2;
    }
    memset(&mesh, 0, sizeof mesh);
    mesh.vertices = s.vertices;
    mesh.vertex_count = ((size_t)s.side + 1) * (s.side + 1);
    mesh.indices = s.indices;
    mesh.index_type = HUG_INDEX_U32;
    mesh.triangle_count = s.triangles;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.geometries = &mesh;
    desc.geometry_count = 1;
    desc.max_refs = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 4;
    desc.structure = argc > 3 ? (uint32_t)strtoul(argv[3], NULL, 10) : HUG_STRUCTURE_AUTO;
    status = hug_measure(&desc, &arena, &scratch);
    printf("%zu triangles; at most %zu MB of arena and %zu MB of scratch: %s\n", s.triangles,
           arena >> 20, scratch >> 20, hug_status_string(status));
    fflush(stdout);
    start = seconds();
    status = hug_build(&desc, &scene);
    if (status != HUG_OK) {
        printf("refused: %s\n", hug_status_string(status));
        return 3;
    }
    hug_data(scene, &arena);
    printf("built in %.1f s of processor time: %zu MB\n", seconds() - start, arena >> 20);
    fflush(stdout);
    start = seconds();
    if (!trace(scene, &s))
        return 1;
    printf("%u rays in %.1f s, each hit its triangle\n", RAYS, seconds() - start);
    hug_free(scene);
    free(s.vertices);
    free(s.indices);
    return 0;
}
