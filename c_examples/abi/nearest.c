/* The nearest point: where it is, and probes that find nothing. */
#include <math.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

static hug_probe probe_at(float x, float y, float z, float radius)
{
    hug_probe probe = {{0, 0, 0}, 0, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    probe.org[0] = x;
    probe.org[1] = y;
    probe.org[2] = z;
    probe.radius = radius;
    return probe;
}

static int is_nothing(const hug_nearest *near, float distance)
{
    return near->geom == HUG_NONE && near->prim == HUG_NONE && near->inst == HUG_NONE &&
           near->distance == distance && near->u == 0 && near->v == 0 && near->point[0] == 0 &&
           near->point[1] == 0 && near->point[2] == 0 && near->reserved == 0;
}

static void check_places(const hug_scene *scene)
{
    /* vertex (0, 0) of the sheet has z = 0, and nothing is as near to a point beyond it */
    hug_probe probe = probe_at(-3, 0, -4, 6);
    hug_nearest near;
    REQUIRE(hug_closest_point(scene, &probe, &near) == 1);
    REQUIRE(near.distance == 5 && near.point[0] == 0 && near.point[1] == 0 && near.point[2] == 0);
    REQUIRE(near.geom == 0 && near.prim == 0 && near.u == 0 && near.v == 0);
    REQUIRE(near.inst == HUG_NONE && near.reserved == 0);
    probe.radius = 5;
    REQUIRE(hug_closest_point(scene, &probe, &near) == 1);
    probe.radius = nextafterf(5, 0);
    REQUIRE(hug_closest_point(scene, &probe, &near) == 0 && is_nothing(&near, probe.radius));
    probe.radius = INFINITY;
    probe.skip_geom = probe.skip_prim = 0;
    REQUIRE(hug_closest_point(scene, &probe, &near) == 1 && near.prim != 0);
    probe = probe_at(0, 0, 0, 0);
    REQUIRE(hug_closest_point(scene, &probe, &near) == 1 && near.distance == 0);
}

static void check_bad(const hug_scene *scene)
{
    hug_probe good = probe_at(1, 1, 1, 10), probe;
    hug_nearest near;
    int i;
    REQUIRE(hug_closest_point(scene, &good, &near) == 1);
    REQUIRE(hug_closest_point(NULL, &good, &near) == 0 && is_nothing(&near, INFINITY));
    REQUIRE(hug_closest_point(scene, NULL, &near) == 0 && is_nothing(&near, INFINITY));
    REQUIRE(hug_closest_point(scene, &good, NULL) == 0);
    for (i = 0; i < 3; i++) {
        probe = good;
        probe.org[i] = NAN;
        REQUIRE(hug_closest_point(scene, &probe, &near) == 0 && is_nothing(&near, 10));
        probe.org[i] = -INFINITY;
        REQUIRE(hug_closest_point(scene, &probe, &near) == 0 && is_nothing(&near, 10));
    }
    probe = good;
    probe.radius = -1;
    REQUIRE(hug_closest_point(scene, &probe, &near) == 0 && is_nothing(&near, -1));
    probe.radius = NAN;
    REQUIRE(hug_closest_point(scene, &probe, &near) == 0 && near.geom == HUG_NONE);
    probe = good;
    probe.mask = 0;
    REQUIRE(hug_closest_point(scene, &probe, &near) == 0 && is_nothing(&near, 10));
}

static void check_structure(const hug_scene *scene)
{
    check_places(scene);
    check_bad(scene);
}

void check_nearest(void)
{
    fixture_structures(check_structure);
}
