#define _POSIX_C_SOURCE 200809L
#include "compare/queries.h"

#include <stdlib.h>
#include <string.h>

#include "hug_embree.h"
#include "message.h"

static int out_of_memory(size_t count)
{
    message("no memory for the answers to %lu rays", (unsigned long)count);
    return 0;
}

int hug_query_make(const hug_scene *built, const hug_ray *rays, size_t count, int occlusion,
                   hug_query *out)
{
    memset(out, 0, sizeof *out);
    out->built = built;
    out->rays = rays;
    out->count = count;
    /* one more, so that no rays is no special case */
    if (occlusion)
        out->occluded = (uint8_t *)calloc(count + 1, 1);
    else
        out->hits = (hug_hit *)calloc(count + 1, sizeof *out->hits);
    return out->occluded || out->hits || out_of_memory(count);
}

void hug_query_free(hug_query *q)
{
    free(q->hits);
    free(q->occluded);
    memset(q, 0, sizeof *q);
}

static int intersect_single(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    size_t i;
    for (i = 0; i < n; i++)
        hug_intersect(q->built, &q->rays[i], &q->hits[i]);
    return 1;
}

static int intersect_stream(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    hug_intersect_n(q->built, q->rays, 0, q->hits, 0, n);
    return 1;
}

static int occluded_single(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    size_t i;
    for (i = 0; i < n; i++)
        q->occluded[i] = (uint8_t)hug_occluded(q->built, &q->rays[i]);
    return 1;
}

static int occluded_stream(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    hug_occluded_n(q->built, q->rays, 0, q->occluded, n);
    return 1;
}

void hug_query_enter(hug_query *q, int stream, contender *out)
{
    if (q->hits)
        out->run = stream ? intersect_stream : intersect_single;
    else
        out->run = stream ? occluded_stream : occluded_single;
    out->prepare = NULL;
    out->self = q;
}

int embree_query_make(RTCScene built, const hug_ray *rays, size_t count, int occlusion,
                      embree_query *out)
{
    void *records = NULL;
    size_t size = occlusion ? sizeof *out->occluded : sizeof *out->rayhits;
    memset(out, 0, sizeof *out);
    out->built = built;
    out->rays = rays;
    out->count = count;
    if (posix_memalign(&records, 64, (count + 1) * size) != 0)
        return out_of_memory(count);
    if (occlusion) {
        out->occluded = (struct RTCRay *)records;
        out->flags = (uint8_t *)calloc(count + 1, 1);
    } else {
        out->rayhits = (struct RTCRayHit *)records;
        out->hits = (hug_hit *)calloc(count + 1, sizeof *out->hits);
    }
    return out->flags || out->hits || out_of_memory(count);
}

void embree_query_free(embree_query *q)
{
    free(q->rayhits);
    free(q->occluded);
    free(q->hits);
    free(q->flags);
    memset(q, 0, sizeof *q);
}

static void set_rayhits(void *self)
{
    embree_query *q = (embree_query *)self;
    size_t i;
    for (i = 0; i < q->count; i++)
        hug_embree_to_rayhit(&q->rays[i], &q->rayhits[i]);
}

static void set_rays(void *self)
{
    embree_query *q = (embree_query *)self;
    size_t i;
    for (i = 0; i < q->count; i++)
        hug_embree_to_ray(&q->rays[i], &q->occluded[i]);
}

static int intersect(void *self, size_t n)
{
    embree_query *q = (embree_query *)self;
    struct RTCIntersectContext context;
    size_t i;
    rtcInitIntersectContext(&context);
    for (i = 0; i < n; i++)
        rtcIntersect1(q->built, &context, &q->rayhits[i]);
    return 1;
}

static int occluded(void *self, size_t n)
{
    embree_query *q = (embree_query *)self;
    struct RTCIntersectContext context;
    size_t i;
    rtcInitIntersectContext(&context);
    for (i = 0; i < n; i++)
        rtcOccluded1(q->built, &context, &q->occluded[i]);
    return 1;
}

void embree_query_enter(embree_query *q, contender *out)
{
    out->prepare = q->rayhits ? set_rayhits : set_rays;
    out->run = q->rayhits ? intersect : occluded;
    out->self = q;
}

void embree_query_finish(embree_query *q)
{
    size_t i;
    for (i = 0; i < q->count; i++) {
        if (q->rayhits)
            q->hits[i] = hug_embree_hit(&q->rayhits[i]);
        else
            q->flags[i] = (uint8_t)hug_embree_occluded(&q->occluded[i]);
    }
}
