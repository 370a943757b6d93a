/* Filters and culling: what is offered, what is accepted, what is passed through. */
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

typedef struct {
    unsigned calls, modulus;
    size_t highest;
    int coherent; /* the ray is that of the index, the hit one of it */
} asked;

static int32_t accept(void *user, size_t index, const hug_ray *ray, const hug_hit *hit)
{
    asked *a = (asked *)user;
    hug_ray expected = fixture_ray((unsigned)index);
    a->calls++;
    if (index > a->highest)
        a->highest = index;
    a->coherent = a->coherent && memcmp(ray, &expected, sizeof expected) == 0 &&
                  hit->geom == 0 && hit->prim < FIXTURE_TRIANGLES && hit->t >= ray->tmin &&
                  hit->t <= ray->tmax;
    return hit->prim % a->modulus == 0;
}

static asked nobody(unsigned modulus)
{
    asked a = {0, 0, 0, 1};
    a.modulus = modulus;
    return a;
}

/* Streams answer as single calls, and those accept the first hit that all hits have. */
static void check_filters(const hug_scene *scene)
{
    static hug_ray rays[FIXTURE_RAYS];
    static hug_hit plain[FIXTURE_RAYS], hits[FIXTURE_RAYS];
    static uint8_t flags[FIXTURE_RAYS];
    unsigned i, modulus, accepted;
    int same = 1;
    asked a;
    fixture_hits(scene, plain);
    for (i = 0; i < FIXTURE_RAYS; i++)
        rays[i] = fixture_ray(i);
    for (modulus = 1; modulus < 4; modulus++) {
        a = nobody(modulus);
        hug_intersect_n_filtered(scene, rays, 0, hits, 0, FIXTURE_RAYS, accept, &a);
        REQUIRE(a.coherent && a.calls > 0 && a.highest > FIXTURE_RAYS / 2);
        hug_occluded_n_filtered(scene, rays, 0, flags, FIXTURE_RAYS, accept, &a);
        REQUIRE(a.coherent);
        accepted = 0;
        for (i = 0; i < FIXTURE_RAYS; i++) {
            hug_hit all[8], expected = plain[i];
            size_t count, j;
            hug_intersect_all(scene, &rays[i], NULL, all, 8, &count, NULL);
            for (j = 0; j < count && all[j].prim % modulus; j++)
                ;
            if (j < count) {
                expected = all[j];
                accepted++;
            }
            same = same && flags[i] == (j < count) &&
                   (j < count ? memcmp(&hits[i], &expected, sizeof expected) == 0
                              : hits[i].geom == HUG_NONE && hits[i].t == rays[i].tmax);
        }
        REQUIRE(same && accepted > 0);
    }
    a = nobody(1);
    REQUIRE(hug_intersect_filtered(scene, &rays[0], &hits[0], accept, &a) ==
            (plain[0].geom != HUG_NONE));
    REQUIRE(memcmp(&hits[0], &plain[0], sizeof plain[0]) == 0 && a.coherent);
    REQUIRE(hug_occluded_filtered(scene, &rays[0], accept, &a) == (plain[0].geom != HUG_NONE));
}

static void check_nulls(const hug_scene *scene)
{
    hug_ray ray = fixture_ray(50);
    hug_hit plain, hit;
    uint8_t flag = 7;
    asked a = nobody(1);
    REQUIRE(hug_intersect(scene, &ray, &plain) == 1);
    /* no filter accepts everything */
    REQUIRE(hug_intersect_filtered(scene, &ray, &hit, NULL, NULL) == 1);
    REQUIRE(memcmp(&plain, &hit, sizeof hit) == 0);
    REQUIRE(hug_occluded_filtered(scene, &ray, NULL, NULL) == 1);
    memset(&hit, 0, sizeof hit);
    hug_intersect_n_filtered(scene, &ray, 0, &hit, 0, 1, NULL, NULL);
    REQUIRE(memcmp(&plain, &hit, sizeof hit) == 0);
    hug_occluded_n_filtered(scene, &ray, 0, &flag, 1, NULL, NULL);
    REQUIRE(flag == 1);
    /* nobody is asked about nothing */
    REQUIRE(hug_intersect_filtered(NULL, &ray, &hit, accept, &a) == 0 && hit.geom == HUG_NONE);
    REQUIRE(hug_intersect_filtered(scene, NULL, &hit, accept, &a) == 0 && hit.geom == HUG_NONE);
    REQUIRE(hug_intersect_filtered(scene, &ray, NULL, accept, &a) == 0);
    REQUIRE(hug_occluded_filtered(NULL, &ray, accept, &a) == 0);
    REQUIRE(hug_occluded_filtered(scene, NULL, accept, &a) == 0);
    hit.geom = flag = 7;
    hug_intersect_n_filtered(NULL, &ray, 0, &hit, 0, 1, accept, &a);
    hug_intersect_n_filtered(scene, NULL, 0, &hit, 0, 1, accept, &a);
    hug_intersect_n_filtered(scene, &ray, 0, NULL, 0, 1, accept, &a);
    hug_intersect_n_filtered(scene, &ray, 0, &hit, 0, 0, accept, &a);
    hug_occluded_n_filtered(NULL, &ray, 0, &flag, 1, accept, &a);
    hug_occluded_n_filtered(scene, NULL, 0, &flag, 1, accept, &a);
    hug_occluded_n_filtered(scene, &ray, 0, NULL, 1, accept, &a);
    hug_occluded_n_filtered(scene, &ray, 0, &flag, 0, accept, &a);
    REQUIRE(hit.geom == 7 && flag == 7 && a.calls == 0);
}

/* The sheet is seen from above, where its normals point; from below it is not. */
static void check_culling(const hug_scene *scene)
{
    static hug_ray rays[FIXTURE_RAYS];
    static hug_hit plain[FIXTURE_RAYS], hits[FIXTURE_RAYS];
    unsigned i, down;
    int same = 1;
    for (down = 0; down < 2; down++) {
        uint32_t keep = down ? HUG_RAY_CULL_BACK : HUG_RAY_CULL_FRONT;
        uint32_t lose = HUG_RAY_CULL_BACK + HUG_RAY_CULL_FRONT - keep;
        for (i = 0; i < FIXTURE_RAYS; i++) {
            rays[i] = fixture_ray(i);
            rays[i].dir[0] = 0;
            if (!down) {
                rays[i].org[2] = -1;
                rays[i].dir[2] = 1;
            }
            hug_intersect(scene, &rays[i], &plain[i]);
            rays[i].flags = keep;
            same = same && hug_occluded(scene, &rays[i]) == (plain[i].geom != HUG_NONE);
        }
        hug_intersect_n(scene, rays, 0, hits, 0, FIXTURE_RAYS);
        REQUIRE(same && memcmp(plain, hits, sizeof hits) == 0);
        for (i = 0; i < FIXTURE_RAYS; i++) {
            rays[i].flags = i % 2 ? lose : HUG_RAY_CULL_BACK | HUG_RAY_CULL_FRONT;
            same = same && hug_intersect(scene, &rays[i], &hits[i]) == 0;
        }
        REQUIRE(same);
    }
    /* other bits change nothing */
    rays[0] = fixture_ray(50);
    rays[0].flags = ~(uint32_t)(HUG_RAY_CULL_BACK | HUG_RAY_CULL_FRONT);
    REQUIRE(hug_intersect(scene, &rays[0], &hits[0]) == 1);
}

static void check_structure(const hug_scene *scene)
{
    check_filters(scene);
    check_nulls(scene);
    check_culling(scene);
}

void check_filtered(void)
{
    fixture_structures(check_structure);
}
