/* What it teaches: moving packets over from Embree. Checks hug_embree.h against Embree
 * itself: packets of 4, 8 and 16 rays and streams of single rays, asked of both on the
 * same mesh. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hug_embree.h"
#include "lessons/waves.h"

#define SIDE 60
#define RAYS (16 * 40)

static int failures;

static void require(int condition, const char *what, unsigned n, unsigned i)
{
    if (condition)
        return;
    fprintf(stderr, "embree_packets: packets of %u, ray %u: %s\n", n, i, what);
    failures++;
}

/* Room for a packet of any width, aligned as Embree wants it. */
typedef union {
    struct RTCRayHit4 of4;
    struct RTCRayHit8 of8;
    struct RTCRayHit16 of16;
    struct RTCRay16 rays;
} packet;

typedef struct {
    RTCScene embree;
    hug_scene *hug;
    hug_ray rays[RAYS];
} fixture;

static void embree_intersect(unsigned n, const int *valid, RTCScene scene, packet *p)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (n == 4)
        rtcIntersect4(valid, scene, &context, &p->of4);
    else if (n == 8)
        rtcIntersect8(valid, scene, &context, &p->of8);
    else
        rtcIntersect16(valid, scene, &context, &p->of16);
}

static void hug_answers(unsigned n, const int *valid, const hug_scene *scene, packet *p)
{
    if (n == 4)
        hug_embree_intersect4(valid, scene, &p->of4);
    else if (n == 8)
        hug_embree_intersect8(valid, scene, &p->of8);
    else
        hug_embree_intersect16(valid, scene, &p->of16);
}

static void embree_occluded(unsigned n, const int *valid, RTCScene scene, packet *p)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (n == 4)
        rtcOccluded4(valid, scene, &context, (struct RTCRay4 *)p);
    else if (n == 8)
        rtcOccluded8(valid, scene, &context, (struct RTCRay8 *)p);
    else
        rtcOccluded16(valid, scene, &context, &p->rays);
}

static void hug_occlusion(unsigned n, const int *valid, const hug_scene *scene, packet *p)
{
    if (n == 4)
        hug_embree_occluded4(valid, scene, (struct RTCRay4 *)p);
    else if (n == 8)
        hug_embree_occluded8(valid, scene, (struct RTCRay8 *)p);
    else
        hug_embree_occluded16(valid, scene, &p->rays);
}

/* As close as Embree's own rounding lets them be, or on two triangles of one edge. */
static int alike(const hug_hit *a, const hug_hit *b)
{
    if (a->geom != b->geom)
        return 0;
    if (a->geom == HUG_NONE)
        return a->t == b->t;
    if (fabsf(a->t - b->t) > 1e-4f * a->t)
        return 0;
    return a->prim != b->prim || (fabsf(a->u - b->u) < 0.01f && fabsf(a->v - b->v) < 0.01f &&
                                  fabsf(a->ng[2] - b->ng[2]) <= 1e-3f * fabsf(a->ng[2]) &&
                                  a->inst == b->inst);
}

static void check_packet(const fixture *f, unsigned n, const hug_ray *rays)
{
    packet ours, theirs, before;
    RTC_ALIGN(64) int valid[16]; /* as Embree wants it */
    unsigned i;
    memset(&ours, 0xa5, sizeof ours);
    for (i = 0; i < n; i++) {
        hug_ray back;
        valid[i] = i % 3 == 1 ? 0 : -1;
        hug_embree_to_rayhit_n(&rays[i], (struct RTCRayHitN *)&ours, n, i);
        back = hug_embree_ray_n((const struct RTCRayN *)&ours, n, i);
        require(memcmp(&back, &rays[i], sizeof back) == 0, "changed on its way", n, i);
    }
    before = theirs = ours;
    hug_answers(n, valid, f->hug, &ours);
    embree_intersect(n, valid, f->embree, &theirs);
    for (i = 0; i < n; i++) {
        hug_hit exact, our = hug_embree_hit_n((const struct RTCRayHitN *)&ours, n, i);
        hug_hit their = hug_embree_hit_n((const struct RTCRayHitN *)&theirs, n, i);
        hug_hit old = hug_embree_hit_n((const struct RTCRayHitN *)&before, n, i);
        hug_intersect(f->hug, &rays[i], &exact);
        require(memcmp(&our, valid[i] ? &exact : &old, sizeof our) == 0, "another hit", n, i);
        /* Without AVX-512, Embree 3.13.5 answers the rays of a packet of 16 that are not valid. */
        require(!valid[i] || alike(&our, &their), "Embree's hit is far from it", n, i);
    }

    ours = theirs = before;
    hug_occlusion(n, valid, f->hug, &ours);
    embree_occluded(n, valid, f->embree, &theirs);
    for (i = 0; i < n; i++)
        require(*hug_embree_at(&ours, HUG_EMBREE_TFAR, n, i) ==
                    *hug_embree_at(valid[i] ? &theirs : &before, HUG_EMBREE_TFAR, n, i),
                "another occlusion", n, i);
}

static void check_streams(const fixture *f)
{
    static struct RTCRayHit closest[RAYS], reference[RAYS];
    static struct RTCRay shadows[RAYS];
    struct RTCIntersectContext context;
    unsigned i;
    for (i = 0; i < RAYS; i++) {
        hug_embree_to_rayhit(&f->rays[i], &closest[i]);
        hug_embree_to_ray(&f->rays[i], &shadows[i]);
        reference[i] = closest[i];
    }
    hug_embree_intersect1M(f->hug, closest, RAYS, sizeof *closest);
    hug_embree_occluded1M(f->hug, shadows, RAYS, sizeof *shadows);
    rtcInitIntersectContext(&context);
    rtcIntersect1M(f->embree, &context, reference, RAYS, sizeof *reference);
    for (i = 0; i < RAYS; i++) {
        hug_hit exact, our = hug_embree_hit(&closest[i]), their = hug_embree_hit(&reference[i]);
        hug_intersect(f->hug, &f->rays[i], &exact);
        require(memcmp(&our, &exact, sizeof our) == 0, "another hit", 1, i);
        require(alike(&our, &their), "Embree's hit is far from it", 1, i);
        require(hug_embree_occluded(&shadows[i]) == (exact.geom != HUG_NONE), "occlusion", 1, i);
    }
}

static RTCScene embree_scene(RTCDevice device, const float *vertices, const uint32_t *indices)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    RTCScene scene = rtcNewScene(device);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices,
                               0, 3 * sizeof(float), WAVES_VERTICES(SIDE));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices, 0,
                               3 * sizeof(uint32_t), WAVES_TRIANGLES(SIDE));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, 0);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
    return scene;
}

int main(void)
{
    /* One float more than there are: Embree loads 16 bytes a vertex. */
    static float vertices[3 * WAVES_VERTICES(SIDE) + 1];
    static uint32_t indices[3 * WAVES_TRIANGLES(SIDE)];
    static fixture f;
    RTCDevice device = rtcNewDevice("threads=1");
    hug_geometry geometry = waves_geometry(SIDE, vertices, indices);
    hug_build_desc desc = waves_desc(&geometry);
    unsigned i, n;
    waves_vertices(SIDE, 1.0f, vertices);
    waves_indices(SIDE, indices);
    if (!device || hug_build(&desc, &f.hug) != HUG_OK) {
        fprintf(stderr, "embree_packets: no device, or no scene\n");
        return 1;
    }
    f.embree = embree_scene(device, vertices, indices);
    for (i = 0; i < RAYS; i++)
        f.rays[i] = waves_ray(i % 32, i / 32, 32, RAYS / 32);
    for (n = 4; n <= 16; n *= 2)
        for (i = 0; i + n <= RAYS; i += n)
            check_packet(&f, n, f.rays + i);
    check_streams(&f);
    hug_free(f.hug);
    rtcReleaseScene(f.embree);
    rtcReleaseDevice(device);
    if (!failures)
        printf("embree_packets: ok\n");
    return failures ? 1 : 0;
}
