/* All hits of a ray, and the triangle test on its own. */
#include <math.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

#define ROOM 64

/* Along the sheet, through many of its bumps. */
static hug_ray along(void)
{
    hug_ray ray = {{-1, 3.3f, 0.7f}, 0, {1, 0.01f, 0}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    return ray;
}

static int in_order(const hug_hit *hits, size_t count)
{
    size_t i;
    for (i = 1; i < count; i++) {
        const hug_hit *a = &hits[i - 1], *b = &hits[i];
        if (!(a->t < b->t || (a->t == b->t && (a->geom < b->geom ||
                                               (a->geom == b->geom && a->prim < b->prim)))))
            return 0;
    }
    return 1;
}

static void check_all(const hug_scene *scene)
{
    hug_ray ray = along();
    hug_hit all[ROOM], few[ROOM], closest;
    size_t count = 7, part, at;
    int32_t more = 7;
    REQUIRE(hug_intersect_all(scene, &ray, NULL, all, ROOM, &count, &more) == HUG_OK);
    REQUIRE(count > 8 && count < ROOM && more == 0 && in_order(all, count));
    REQUIRE(hug_intersect(scene, &ray, &closest) == 1);
    REQUIRE(memcmp(&closest, &all[0], sizeof closest) == 0);

    /* the first of them, with or without others */
    REQUIRE(hug_intersect_all(scene, &ray, NULL, few, count, &part, &more) == HUG_OK);
    REQUIRE(part == count && more == 0);
    REQUIRE(hug_intersect_all(scene, &ray, NULL, few, 3, &part, &more) == HUG_OK);
    REQUIRE(part == 3 && more == 1 && memcmp(few, all, 3 * sizeof *all) == 0);
    REQUIRE(hug_intersect_all(scene, &ray, NULL, few, 3, &part, NULL) == HUG_OK && part == 3);

    /* one call after the other, in the same room */
    at = 0;
    do {
        const hug_hit *last = at ? &few[2] : NULL;
        REQUIRE(hug_intersect_all(scene, &ray, last, few, 3, &part, &more) == HUG_OK);
        REQUIRE(at + part <= count && memcmp(few, &all[at], part * sizeof *few) == 0);
        at += part;
    } while (more && part == 3);
    REQUIRE(at == count);
    REQUIRE(hug_intersect_all(scene, &ray, &all[count - 1], few, 3, &part, &more) == HUG_OK);
    REQUIRE(part == 0 && more == 0);
}

static void check_bad_all(const hug_scene *scene)
{
    hug_ray ray = along(), bad = along();
    hug_hit hits[2], after;
    size_t count = 7;
    int32_t more = 7;
    memset(&after, 0, sizeof after);
    REQUIRE(hug_intersect_all(NULL, &ray, NULL, hits, 2, &count, &more) == HUG_ERROR_NULL);
    REQUIRE(count == 0 && more == 0);
    REQUIRE(hug_intersect_all(scene, NULL, NULL, hits, 2, &count, &more) == HUG_ERROR_NULL);
    REQUIRE(hug_intersect_all(scene, &ray, NULL, NULL, 2, &count, &more) == HUG_ERROR_NULL);
    REQUIRE(hug_intersect_all(scene, &ray, NULL, hits, 2, NULL, &more) == HUG_ERROR_NULL);
    REQUIRE(hug_intersect_all(scene, &ray, NULL, (hug_hit *)((char *)hits + 1), 1, &count, &more) ==
            HUG_ERROR_ALIGNMENT);
    REQUIRE(hug_intersect_all(scene, &ray, NULL, hits, SIZE_MAX / 8, &count, &more) ==
            HUG_ERROR_OVERFLOW);
    /* no room: only whether there are any */
    REQUIRE(hug_intersect_all(scene, &ray, NULL, NULL, 0, &count, &more) == HUG_OK);
    REQUIRE(count == 0 && more == 1);
    bad.tmax = NAN;
    REQUIRE(hug_intersect_all(scene, &bad, NULL, hits, 2, &count, &more) == HUG_OK);
    REQUIRE(count == 0 && more == 0);
    REQUIRE(hug_intersect_all(scene, &bad, NULL, NULL, 0, &count, &more) == HUG_OK && more == 0);
    after.t = NAN;
    REQUIRE(hug_intersect_all(scene, &ray, &after, hits, 2, &count, &more) == HUG_OK);
    REQUIRE(count == 0 && more == 0);
    /* a miss is followed by nothing, what lies before all hits by all of them */
    bad = along();
    bad.mask = 0;
    REQUIRE(hug_intersect(scene, &bad, &after) == 0);
    REQUIRE(hug_intersect_all(scene, &ray, &after, hits, 2, &count, &more) == HUG_OK);
    REQUIRE(count == 0 && more == 0);
    after.t = -INFINITY;
    REQUIRE(hug_intersect_all(scene, &ray, &after, hits, 2, &count, &more) == HUG_OK);
    REQUIRE(count == 2 && more == 1);
}

static void check_triangle(void)
{
    static const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const float flat[9] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
    float broken[9];
    hug_ray ray = {{0.25f, 0.5f, 2}, 0, {0, 0, -1}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_hit hit;
    REQUIRE(hug_intersect_triangle(&ray, corners, &hit) == 1);
    REQUIRE(hit.t == 2 && hit.u == 0.25f && hit.v == 0.5f && hit.ng[2] == 1 && hit.geom == 0 &&
            hit.prim == 0 && hit.inst == HUG_NONE);
    REQUIRE(hug_intersect_triangle(&ray, flat, &hit) == 0 && hit.geom == HUG_NONE && hit.t == 100);
    memcpy(broken, corners, sizeof broken);
    broken[4] = NAN;
    REQUIRE(hug_intersect_triangle(&ray, broken, &hit) == 0 && hit.geom == HUG_NONE);
    REQUIRE(hug_intersect_triangle(NULL, corners, &hit) == 0 && hit.t == INFINITY);
    REQUIRE(hug_intersect_triangle(&ray, NULL, &hit) == 0 && hit.t == INFINITY);
    REQUIRE(hug_intersect_triangle(&ray, corners, NULL) == 0);
    ray.flags = HUG_RAY_CULL_FRONT;
    REQUIRE(hug_intersect_triangle(&ray, corners, &hit) == 0);
    ray.flags = HUG_RAY_CULL_BACK;
    REQUIRE(hug_intersect_triangle(&ray, corners, &hit) == 1);
    ray.skip_geom = ray.skip_prim = 0;
    REQUIRE(hug_intersect_triangle(&ray, corners, &hit) == 0);
}

static void check_structure(const hug_scene *scene)
{
    check_all(scene);
    check_bad_all(scene);
}

void check_hits(void)
{
    fixture_structures(check_structure);
    check_triangle();
}
