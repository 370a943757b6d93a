/* What it teaches: moving single rays over from Embree. Checks the converters of
 * hug_embree.h: what goes to Embree's records and back is the same, and hits, misses and
 * occlusion follow Embree's conventions. Embree's header is enough, the library is not
 * linked. */
#include <stdio.h>
#include <string.h>

#include "hug_embree.h"

static int failures;

static void require(int condition, const char *what)
{
    if (condition)
        return;
    fprintf(stderr, "embree_records: %s\n", what);
    failures++;
}

static hug_scene *build_triangle(void)
{
    static const float vertices[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    hug_geometry geometry;
    hug_build_desc desc;
    hug_scene *scene = NULL;
    hug_status status;
    memset(&geometry, 0, sizeof geometry);
    geometry.vertices = vertices;
    geometry.vertex_count = 3;
    geometry.triangle_count = 1;
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.geometries = &geometry;
    desc.geometry_count = 1;
    status = hug_build(&desc, &scene);
    require(status == HUG_OK, hug_status_string(status));
    return scene;
}

static void check_round_trip(const hug_ray *ray, const hug_hit *hit)
{
    struct RTCRayHit rayhit;
    hug_ray ray_back;
    hug_hit hit_back;
    hug_embree_to_rayhit(ray, &rayhit);
    ray_back = hug_embree_ray(&rayhit.ray);
    require(memcmp(&ray_back, ray, sizeof ray_back) == 0, "a ray changed on its way");
    require(rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID, "a new ray has a hit");
    hug_embree_set_hit(hit, &rayhit);
    require(rayhit.ray.tfar == hit->t, "a hit did not set tfar");
    hit_back = hug_embree_hit(&rayhit);
    require(memcmp(&hit_back, hit, sizeof hit_back) == 0, "a hit changed on its way");
}

static void check_queries(const hug_scene *scene, const hug_ray *hitting, const hug_ray *missing)
{
    struct RTCRayHit rayhit;
    hug_hit expected, got;

    hug_intersect(scene, hitting, &expected);
    hug_embree_to_rayhit(hitting, &rayhit);
    require(hug_embree_intersect1(scene, &rayhit) == 1, "the ray misses");
    got = hug_embree_hit(&rayhit);
    require(memcmp(&got, &expected, sizeof got) == 0, "not the hit of hug_intersect");

    hug_intersect(scene, missing, &expected);
    hug_embree_to_rayhit(missing, &rayhit);
    require(hug_embree_intersect1(scene, &rayhit) == 0, "the other ray hits");
    require(rayhit.ray.tfar == missing->tmax, "a miss changed tfar");
    got = hug_embree_hit(&rayhit);
    require(memcmp(&got, &expected, sizeof got) == 0, "not the miss of hug_intersect");

    hug_embree_to_rayhit(hitting, &rayhit);
    require(!hug_embree_occluded(&rayhit.ray), "a new ray is occluded");
    require(hug_embree_occluded1(scene, &rayhit.ray) == 1, "the ray is not occluded");
    require(rayhit.ray.tfar < 0 && hug_embree_occluded(&rayhit.ray), "tfar is not -infinity");
    hug_embree_to_rayhit(missing, &rayhit);
    require(hug_embree_occluded1(scene, &rayhit.ray) == 0, "the other ray is occluded");
    require(rayhit.ray.tfar == missing->tmax, "a free ray changed tfar");
}

int main(void)
{
    hug_ray hitting = {{0.25f, 0.5f, 2}, 0, {0, 0, -1}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_ray missing = hitting;
    hug_scene *scene = build_triangle();
    hug_hit hit;
    missing.org[0] = 2;
    require(hug_intersect(scene, &hitting, &hit) == 1, "hug_intersect misses");
    check_round_trip(&hitting, &hit);
    check_queries(scene, &hitting, &missing);
    hug_free(scene);
    if (!failures)
        printf("embree_records: ok\n");
    return failures ? 1 : 0;
}
