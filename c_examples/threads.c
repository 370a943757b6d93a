/* What it teaches: whose threads. hug starts none; a program that has a pool lends it,
 * for the build through parallel_for, for rays by calling the queries from wherever it
 * likes, with no lock around them. The bytes that are built do not depend on the number
 * of threads, which this program checks. It also watches the build through progress,
 * and cancels one.
 *
 * usage: threads [THREADS]
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lessons/pool.h"
#include "lessons/waves.h"

#define SIDE 300
#define WIDTH 640u
#define TILE 32u
#define TILES (WIDTH / TILE)

typedef struct {
    const hug_scene *scene;
    unsigned char *pixels;
} picture;

static void render_tile(void *of, size_t index)
{
    picture *to = (picture *)of;
    unsigned left = (unsigned)(index % TILES) * TILE, top = (unsigned)(index / TILES) * TILE;
    unsigned x, y;
    for (y = top; y < top + TILE; y++)
        for (x = left; x < left + TILE; x++) {
            hug_ray ray = waves_ray(x, y, WIDTH, WIDTH);
            hug_hit hit;
            hug_intersect(to->scene, &ray, &hit);
            to->pixels[y * WIDTH + x] = waves_shade(&hit);
        }
}

/* Called on the thread that builds, with shares that never fall. */
static int32_t watch(void *user, double fraction)
{
    double *reached = (double *)user;
    *reached = fraction;
    return 0;
}

static int32_t cancel_half_way(void *user, double fraction)
{
    (void)user;
    return fraction > 0.5;
}

static int same_bytes(const hug_scene *a, const hug_scene *b)
{
    size_t a_size, b_size;
    const void *a_data = hug_data(a, &a_size), *b_data = hug_data(b, &b_size);
    return a_size == b_size && memcmp(a_data, b_data, a_size) == 0;
}

static int run(pool *threads, unsigned count, hug_build_desc *desc, unsigned char *pixels)
{
    hug_scene *alone = NULL, *together = NULL, *cancelled = NULL;
    picture to;
    double reached = 0;
    hug_status status = hug_build(desc, &alone);
    if (status == HUG_OK) {
        desc->parallel_for = pool_run;
        desc->parallel_user = threads;
        desc->progress = watch;
        desc->progress_user = &reached;
        status = hug_build(desc, &together);
    }
    if (status != HUG_OK) {
        fprintf(stderr, "threads: %s\n", hug_status_string(status));
        hug_free(alone);
        return 0;
    }
    if (same_bytes(alone, together) && reached == 1.0)
        printf("built on 1 and on %u threads: the same bytes\n", count);
    else
        status = HUG_ERROR_INTERNAL;

    to.scene = together;
    to.pixels = pixels;
    pool_run(threads, TILES * TILES, render_tile, &to);
    printf("picture %016llx\n",
           (unsigned long long)waves_digest(WAVES_SEED, pixels, WIDTH * WIDTH));

    desc->progress = cancel_half_way;
    if (hug_build(desc, &cancelled) == HUG_ERROR_CANCELLED && !cancelled)
        printf("cancelled half-way: %s\n", hug_status_string(HUG_ERROR_CANCELLED));
    else
        status = HUG_ERROR_INTERNAL;
    hug_free(alone);
    hug_free(together);
    return status == HUG_OK;
}

int main(int argc, char **argv)
{
    int wanted = argc > 1 ? atoi(argv[1]) : 4, ok = 0;
    float *vertices = (float *)malloc(3 * WAVES_VERTICES(SIDE) * sizeof(float));
    uint32_t *indices = (uint32_t *)malloc(3 * WAVES_TRIANGLES(SIDE) * sizeof(uint32_t));
    unsigned char *pixels = (unsigned char *)malloc(WIDTH * WIDTH);
    hug_geometry geometry;
    hug_build_desc desc;
    pool threads;
    if (wanted < 1 || wanted > POOL_MOST) {
        fprintf(stderr, "usage: threads [THREADS, 1 to %d]\n", POOL_MOST);
        return 2;
    }
    if (vertices && indices && pixels) {
        unsigned count = pool_start(&threads, (unsigned)wanted);
        waves_vertices(SIDE, 0.0f, vertices);
        waves_indices(SIDE, indices);
        geometry = waves_geometry(SIDE, vertices, indices);
        desc = waves_desc(&geometry);
        ok = run(&threads, count, &desc, pixels);
        pool_stop(&threads);
    }
    free(vertices);
    free(indices);
    free(pixels);
    return ok ? 0 : 1;
}
