/* hug_embree.h - converters between hug's records and Embree's, for programs
 * that use both or that move from one to the other.
 *
 * Header only, C99 and C++11. Include <embree3/rtcore.h> (or Embree 4's) first,
 * or nothing: then this file includes Embree 3's.
 *
 * What differs between the two:
 *
 * - Range. hug accepts tmin <= t <= tmax, both ends included. Embree accepts
 *   tnear < t <= tfar, with RTC_SCENE_FLAG_ROBUST tnear <= t <= tfar. hug takes
 *   any tmin; Embree treats a negative tnear as 0.
 * - Mask. hug always honours it: mask 0 meets nothing. Embree honours it only if
 *   built so (RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED), and Debian's is not. A
 *   program that leaves RTCRay.mask unset must set it to 0xffffffff for hug.
 * - Flags, id, time. hug has no motion blur and ignores RTCRay's time, id and
 *   flags; hug_ray.flags becomes 0.
 * - Skipped triangle. Embree has no counterpart to skip_geom and skip_prim:
 *   they become HUG_NONE one way and are lost the other way.
 * - Miss. hug writes a whole hit record, with t = tmax. Embree leaves its record
 *   alone, geomID being RTC_INVALID_GEOMETRY_ID from the start.
 * - Bits. hug's t, u, v are exact but for one rounding; Embree's are not, so the
 *   two agree to a tolerance, and where triangles meet may name different ones.
 * - Alignment. hug's records are aligned to 4, Embree's to 16: convert, never
 *   cast a pointer from one to the other.
 *
 * docs/from-embree.md maps Embree's functions to hug's.
 *
 * The same in both: direction of any length, P = (1-u-v) v0 + u v1 + v v2,
 * Ng = (v1-v0) x (v2-v0) not normalised, 0xffffffff for "no id".
 */
#ifndef HUG_EMBREE_H
#define HUG_EMBREE_H

#ifndef RTC_VERSION
#include <embree3/rtcore.h>
#endif
#include <math.h>

#include "hug.h"

/* RTCRay to hug_ray. The mask is copied as it is: see "Mask" above. */
static inline hug_ray hug_embree_ray(const struct RTCRay *ray)
{
    hug_ray out;
    out.org[0] = ray->org_x;
    out.org[1] = ray->org_y;
    out.org[2] = ray->org_z;
    out.tmin = ray->tnear;
    out.dir[0] = ray->dir_x;
    out.dir[1] = ray->dir_y;
    out.dir[2] = ray->dir_z;
    out.tmax = ray->tfar;
    out.mask = ray->mask;
    out.flags = 0;
    out.skip_geom = HUG_NONE;
    out.skip_prim = HUG_NONE;
    return out;
}

/* hug_ray to RTCRay, at time 0, with id and flags 0. The skipped triangle is lost. */
static inline void hug_embree_to_ray(const hug_ray *ray, struct RTCRay *out)
{
    out->org_x = ray->org[0];
    out->org_y = ray->org[1];
    out->org_z = ray->org[2];
    out->tnear = ray->tmin;
    out->dir_x = ray->dir[0];
    out->dir_y = ray->dir[1];
    out->dir_z = ray->dir[2];
    out->time = 0.0f;
    out->tfar = ray->tmax;
    out->mask = ray->mask;
    out->id = 0;
    out->flags = 0;
}

/* hug_hit to RTCHit; t has no place there. A miss gives invalid ids and zeros. */
static inline void hug_embree_to_hit(const hug_hit *hit, struct RTCHit *out)
{
    unsigned int level;
    out->Ng_x = hit->ng[0];
    out->Ng_y = hit->ng[1];
    out->Ng_z = hit->ng[2];
    out->u = hit->u;
    out->v = hit->v;
    out->primID = hit->prim;
    out->geomID = hit->geom;
    out->instID[0] = hit->inst;
    for (level = 1; level < RTC_MAX_INSTANCE_LEVEL_COUNT; level++)
        out->instID[level] = RTC_INVALID_GEOMETRY_ID;
}

/* hug_ray to an RTCRayHit ready for rtcIntersect1: the hit is that of a miss. */
static inline void hug_embree_to_rayhit(const hug_ray *ray, struct RTCRayHit *out)
{
    hug_hit miss;
    miss.t = ray->tmax;
    miss.u = miss.v = miss.ng[0] = miss.ng[1] = miss.ng[2] = 0.0f;
    miss.geom = miss.prim = miss.inst = HUG_NONE;
    miss.reserved = 0;
    hug_embree_to_ray(ray, &out->ray);
    hug_embree_to_hit(&miss, &out->hit);
}

/* Writes what rtcIntersect1 would: on a hit tfar, Ng, u, v and the ids; on a
 * miss geomID becomes RTC_INVALID_GEOMETRY_ID and the rest, tfar too, stays. */
static inline void hug_embree_set_hit(const hug_hit *hit, struct RTCRayHit *out)
{
    if (hit->geom == HUG_NONE) {
        out->hit.geomID = RTC_INVALID_GEOMETRY_ID;
        return;
    }
    out->ray.tfar = hit->t;
    hug_embree_to_hit(hit, &out->hit);
}

/* The result of rtcIntersect1 as a hug_hit. For a miss t is tfar, which is the
 * ray's tmax as long as nothing but rtcIntersect1 wrote it. */
static inline hug_hit hug_embree_hit(const struct RTCRayHit *rayhit)
{
    hug_hit out;
    out.t = rayhit->ray.tfar;
    out.reserved = 0;
    if (rayhit->hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        out.u = out.v = out.ng[0] = out.ng[1] = out.ng[2] = 0.0f;
        out.geom = out.prim = out.inst = HUG_NONE;
        return out;
    }
    out.u = rayhit->hit.u;
    out.v = rayhit->hit.v;
    out.ng[0] = rayhit->hit.Ng_x;
    out.ng[1] = rayhit->hit.Ng_y;
    out.ng[2] = rayhit->hit.Ng_z;
    out.geom = rayhit->hit.geomID;
    out.prim = rayhit->hit.primID;
    out.inst = rayhit->hit.instID[0];
    return out;
}

/* Writes what rtcOccluded1 would: tfar = -infinity if occluded, else nothing. */
static inline void hug_embree_set_occluded(int32_t occluded, struct RTCRay *out)
{
    if (occluded)
        out->tfar = -INFINITY;
}

/* The result of rtcOccluded1: 1 or 0. The ray's own tfar must not be -infinity. */
static inline int32_t hug_embree_occluded(const struct RTCRay *ray)
{
    return ray->tfar == -INFINITY;
}

/* rtcIntersect1, answered by hug. Returns 1 for a hit, 0 for a miss. */
static inline int32_t hug_embree_intersect1(const hug_scene *scene, struct RTCRayHit *rayhit)
{
    hug_ray ray = hug_embree_ray(&rayhit->ray);
    hug_hit hit;
    int32_t found = hug_intersect(scene, &ray, &hit);
    hug_embree_set_hit(&hit, rayhit);
    return found;
}

/* rtcOccluded1, answered by hug. Returns 1 if occluded, else 0. */
static inline int32_t hug_embree_occluded1(const hug_scene *scene, struct RTCRay *ray)
{
    hug_ray copy = hug_embree_ray(ray);
    int32_t occluded = hug_occluded(scene, &copy);
    hug_embree_set_occluded(occluded, ray);
    return occluded;
}

#include "hug_embree_packets.h"

#endif
