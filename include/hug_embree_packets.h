/* hug_embree_packets.h - hug_embree.h for Embree's packets of 4, 8 and 16 rays and its
 * streams of single rays; hug_embree.h includes this file.
 *
 * A packet of n rays is arrays of n numbers, one array a field, in the order of RTCRay
 * and then RTCHit. RTCRayN and RTCRayHitN are Embree's names for a packet of any n: a
 * pointer to RTCRay4, RTCRayHit16, ... may be cast to them. As in Embree, lane i of a
 * packet takes part if valid[i] is -1, and nothing of a lane that does not is touched.
 *
 * hug has no packets of its own: these functions ask for one ray after the other. Rays
 * that go all ways take less time as a stream, hug_intersect_n; hug_embree_intersect1M
 * asks it for 64 rays at a time.
 */
#ifndef HUG_EMBREE_PACKETS_H
#define HUG_EMBREE_PACKETS_H

#include "hug_embree.h"

/* Fields of a packet, by their place: floats, but for those marked u, unsigned ints. */
enum {
    HUG_EMBREE_ORG, /* three */
    HUG_EMBREE_TNEAR = 3,
    HUG_EMBREE_DIR, /* three */
    HUG_EMBREE_TIME = 7,
    HUG_EMBREE_TFAR,
    HUG_EMBREE_MASK,  /* u */
    HUG_EMBREE_ID,    /* u */
    HUG_EMBREE_FLAGS, /* u */
    HUG_EMBREE_NG,    /* three */
    HUG_EMBREE_U = 15,
    HUG_EMBREE_V,
    HUG_EMBREE_PRIM, /* u */
    HUG_EMBREE_GEOM, /* u */
    HUG_EMBREE_INST, /* u, one for each level */
#ifdef RTC_GEOMETRY_INSTANCE_ARRAY /* Embree 4.4: behind them, one more for each */
    HUG_EMBREE_END = HUG_EMBREE_INST + 2 * RTC_MAX_INSTANCE_LEVEL_COUNT
#else
    HUG_EMBREE_END = HUG_EMBREE_INST + RTC_MAX_INSTANCE_LEVEL_COUNT
#endif
};

/* Where lane i of a field is, as floats and as unsigned ints. */
static inline float *hug_embree_at(const void *packet, int field, unsigned int n, unsigned int i)
{
    return (float *)packet + (size_t)field * n + i;
}
static inline unsigned int *hug_embree_uint_at(const void *packet, int field, unsigned int n,
                                               unsigned int i)
{
    return (unsigned int *)packet + (size_t)field * n + i;
}

/* Lane i of a packet of n rays as a hug_ray. */
static inline hug_ray hug_embree_ray_n(const struct RTCRayN *rays, unsigned int n, unsigned int i)
{
    hug_ray out;
    int k;
    for (k = 0; k < 3; k++) {
        out.org[k] = *hug_embree_at(rays, HUG_EMBREE_ORG + k, n, i);
        out.dir[k] = *hug_embree_at(rays, HUG_EMBREE_DIR + k, n, i);
    }
    out.tmin = *hug_embree_at(rays, HUG_EMBREE_TNEAR, n, i);
    out.tmax = *hug_embree_at(rays, HUG_EMBREE_TFAR, n, i);
    out.mask = *hug_embree_uint_at(rays, HUG_EMBREE_MASK, n, i);
    out.flags = 0;
    out.skip_geom = HUG_NONE;
    out.skip_prim = HUG_NONE;
    return out;
}

/* A hug_ray to lane i, at time 0, with id i and flags 0. */
static inline void hug_embree_to_ray_n(const hug_ray *ray, struct RTCRayN *out, unsigned int n,
                                       unsigned int i)
{
    int k;
    for (k = 0; k < 3; k++) {
        *hug_embree_at(out, HUG_EMBREE_ORG + k, n, i) = ray->org[k];
        *hug_embree_at(out, HUG_EMBREE_DIR + k, n, i) = ray->dir[k];
    }
    *hug_embree_at(out, HUG_EMBREE_TNEAR, n, i) = ray->tmin;
    *hug_embree_at(out, HUG_EMBREE_TIME, n, i) = 0.0f;
    *hug_embree_at(out, HUG_EMBREE_TFAR, n, i) = ray->tmax;
    *hug_embree_uint_at(out, HUG_EMBREE_MASK, n, i) = ray->mask;
    *hug_embree_uint_at(out, HUG_EMBREE_ID, n, i) = i;
    *hug_embree_uint_at(out, HUG_EMBREE_FLAGS, n, i) = 0;
}

/* Lane i of a packet that Embree has answered as a hug_hit. */
static inline hug_hit hug_embree_hit_n(const struct RTCRayHitN *of, unsigned int n, unsigned int i)
{
    hug_hit out;
    int k;
    out.t = *hug_embree_at(of, HUG_EMBREE_TFAR, n, i);
    out.geom = *hug_embree_uint_at(of, HUG_EMBREE_GEOM, n, i);
    out.reserved = 0;
    if (out.geom == RTC_INVALID_GEOMETRY_ID) {
        out.u = out.v = out.ng[0] = out.ng[1] = out.ng[2] = 0.0f;
        out.prim = out.inst = HUG_NONE;
        return out;
    }
    out.u = *hug_embree_at(of, HUG_EMBREE_U, n, i);
    out.v = *hug_embree_at(of, HUG_EMBREE_V, n, i);
    for (k = 0; k < 3; k++)
        out.ng[k] = *hug_embree_at(of, HUG_EMBREE_NG + k, n, i);
    out.prim = *hug_embree_uint_at(of, HUG_EMBREE_PRIM, n, i);
    out.inst = *hug_embree_uint_at(of, HUG_EMBREE_INST, n, i);
    return out;
}

/* Writes to lane i what rtcIntersectN would: see hug_embree_set_hit. */
static inline void hug_embree_set_hit_n(const hug_hit *hit, struct RTCRayHitN *out, unsigned int n,
                                        unsigned int i)
{
    int k;
    *hug_embree_uint_at(out, HUG_EMBREE_GEOM, n, i) = hit->geom;
    if (hit->geom == HUG_NONE)
        return;
    *hug_embree_at(out, HUG_EMBREE_TFAR, n, i) = hit->t;
    *hug_embree_at(out, HUG_EMBREE_U, n, i) = hit->u;
    *hug_embree_at(out, HUG_EMBREE_V, n, i) = hit->v;
    for (k = 0; k < 3; k++)
        *hug_embree_at(out, HUG_EMBREE_NG + k, n, i) = hit->ng[k];
    *hug_embree_uint_at(out, HUG_EMBREE_PRIM, n, i) = hit->prim;
    *hug_embree_uint_at(out, HUG_EMBREE_INST, n, i) = hit->inst;
    for (k = HUG_EMBREE_INST + 1; k < HUG_EMBREE_END; k++)
        *hug_embree_uint_at(out, k, n, i) = RTC_INVALID_GEOMETRY_ID;
}

/* A hug_ray to lane i, ready for rtcIntersect4, 8 or 16: the hit is that of a miss. */
static inline void hug_embree_to_rayhit_n(const hug_ray *ray, struct RTCRayHitN *out,
                                          unsigned int n, unsigned int i)
{
    int k;
    hug_embree_to_ray_n(ray, (struct RTCRayN *)out, n, i);
    for (k = HUG_EMBREE_NG; k < HUG_EMBREE_PRIM; k++)
        *hug_embree_at(out, k, n, i) = 0.0f;
    for (; k < HUG_EMBREE_END; k++)
        *hug_embree_uint_at(out, k, n, i) = RTC_INVALID_GEOMETRY_ID;
}

/* rtcIntersect4, 8 and 16, answered by hug. */
static inline void hug_embree_intersect_n(const int *valid, const hug_scene *scene,
                                          struct RTCRayHitN *rayhit, unsigned int n)
{
    unsigned int i;
    for (i = 0; i < n; i++) {
        hug_ray ray;
        hug_hit hit;
        if (valid[i] != -1)
            continue;
        ray = hug_embree_ray_n((const struct RTCRayN *)rayhit, n, i);
        hug_intersect(scene, &ray, &hit);
        hug_embree_set_hit_n(&hit, rayhit, n, i);
    }
}

/* rtcOccluded4, 8 and 16, answered by hug: tfar = -infinity where occluded. */
static inline void hug_embree_occluded_n(const int *valid, const hug_scene *scene,
                                         struct RTCRayN *rays, unsigned int n)
{
    unsigned int i;
    for (i = 0; i < n; i++) {
        hug_ray ray;
        if (valid[i] != -1)
            continue;
        ray = hug_embree_ray_n(rays, n, i);
        if (hug_occluded(scene, &ray))
            *hug_embree_at(rays, HUG_EMBREE_TFAR, n, i) = -INFINITY;
    }
}

static inline void hug_embree_intersect4(const int *valid, const hug_scene *scene,
                                         struct RTCRayHit4 *rayhit)
{
    hug_embree_intersect_n(valid, scene, (struct RTCRayHitN *)rayhit, 4);
}
static inline void hug_embree_intersect8(const int *valid, const hug_scene *scene,
                                         struct RTCRayHit8 *rayhit)
{
    hug_embree_intersect_n(valid, scene, (struct RTCRayHitN *)rayhit, 8);
}
static inline void hug_embree_intersect16(const int *valid, const hug_scene *scene,
                                          struct RTCRayHit16 *rayhit)
{
    hug_embree_intersect_n(valid, scene, (struct RTCRayHitN *)rayhit, 16);
}
static inline void hug_embree_occluded4(const int *valid, const hug_scene *scene,
                                        struct RTCRay4 *rays)
{
    hug_embree_occluded_n(valid, scene, (struct RTCRayN *)rays, 4);
}
static inline void hug_embree_occluded8(const int *valid, const hug_scene *scene,
                                        struct RTCRay8 *rays)
{
    hug_embree_occluded_n(valid, scene, (struct RTCRayN *)rays, 8);
}
static inline void hug_embree_occluded16(const int *valid, const hug_scene *scene,
                                         struct RTCRay16 *rays)
{
    hug_embree_occluded_n(valid, scene, (struct RTCRayN *)rays, 16);
}

/* Rays that hug_embree_intersect1M and hug_embree_occluded1M convert at a time. */
#define HUG_EMBREE_BATCH 64

/* rtcIntersect1M, answered by hug: count records at every stride bytes. */
static inline void hug_embree_intersect1M(const hug_scene *scene, struct RTCRayHit *rayhit,
                                          size_t count, size_t stride)
{
    hug_ray rays[HUG_EMBREE_BATCH];
    hug_hit hits[HUG_EMBREE_BATCH];
    char *first = (char *)rayhit;
    size_t i, n;
    for (; count; count -= n, first += n * stride) {
        n = count < HUG_EMBREE_BATCH ? count : HUG_EMBREE_BATCH;
        for (i = 0; i < n; i++)
            rays[i] = hug_embree_ray(&((struct RTCRayHit *)(void *)(first + i * stride))->ray);
        hug_intersect_n(scene, rays, 0, hits, 0, n);
        for (i = 0; i < n; i++)
            hug_embree_set_hit(&hits[i], (struct RTCRayHit *)(void *)(first + i * stride));
    }
}

/* rtcOccluded1M, answered by hug. */
static inline void hug_embree_occluded1M(const hug_scene *scene, struct RTCRay *first_ray,
                                         size_t count, size_t stride)
{
    hug_ray rays[HUG_EMBREE_BATCH];
    uint8_t occluded[HUG_EMBREE_BATCH];
    char *first = (char *)first_ray;
    size_t i, n;
    for (; count; count -= n, first += n * stride) {
        n = count < HUG_EMBREE_BATCH ? count : HUG_EMBREE_BATCH;
        for (i = 0; i < n; i++)
            rays[i] = hug_embree_ray((struct RTCRay *)(void *)(first + i * stride));
        hug_occluded_n(scene, rays, 0, occluded, n);
        for (i = 0; i < n; i++)
            hug_embree_set_occluded(occluded[i], (struct RTCRay *)(void *)(first + i * stride));
    }
}

#endif
