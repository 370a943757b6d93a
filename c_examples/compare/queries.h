/* One ray set through one library in one form: what rounds_run times, and the
 * answers. Closest hits for every set but the shadow rays. */
#ifndef QUERIES_H
#define QUERIES_H

#include <embree3/rtcore.h>
#include <stddef.h>
#include <stdint.h>

#include "compare/rounds.h"
#include "hug.h"

typedef struct {
    const hug_scene *built;
    const hug_ray *rays;
    size_t count;
    hug_hit *hits;     /* closest hits, */
    uint8_t *occluded; /* or occlusion; the other is NULL */
} hug_query;

typedef struct {
    RTCScene built;
    const hug_ray *rays;
    size_t count;
    struct RTCRayHit *rayhits; /* Embree's rays are in and out: set anew before each run */
    struct RTCRay *occluded;
    hug_hit *hits;  /* the answers, after embree_query_finish */
    uint8_t *flags;
} embree_query;

/* Returns 1, or 0 after a message. Free in both cases. */
int hug_query_make(const hug_scene *built, const hug_ray *rays, size_t count, int occlusion,
                   hug_query *out);
void hug_query_free(hug_query *q);

/* A call a ray, or one call for all of them. */
void hug_query_enter(hug_query *q, int stream, contender *out);

int embree_query_make(RTCScene built, const hug_ray *rays, size_t count, int occlusion,
                      embree_query *out);
void embree_query_enter(embree_query *q, contender *out);
/* Turns the last run's answers into hug's records. */
void embree_query_finish(embree_query *q);
void embree_query_free(embree_query *q);

#endif
