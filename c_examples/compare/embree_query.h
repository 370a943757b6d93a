/* One ray set through Embree, a ray or a packet a call. */
#ifndef EMBREE_QUERY_H
#define EMBREE_QUERY_H

#include "compare/answers.h"
#include "compare/embree_side.h"
#include "compare/rounds.h"

/* Room for Embree's rays, which are in and out: written anew before each run, so all
 * peers can use the same. */
typedef struct {
    uint32_t *words;
    size_t count; /* rays */
    int occlusion;
} embree_records;

/* Returns 1, or 0 after a message. Free in both cases. */
int embree_records_make(size_t count, int occlusion, embree_records *out);
void embree_records_free(embree_records *r);

typedef struct {
    RTCScene built;
    unsigned width; /* 1, 8 or 16 */
    int coherent;   /* the rays of a packet go the same way: Embree is told */
    const hug_ray *rays;
    embree_records *records;
} embree_query;

/* What rounds_run times: the calls. Not timed: writing the records. */
void embree_query_enter(embree_query *q, contender *out);

/* Turns the last run's answers into hug's records. */
void embree_query_answers(const embree_query *q, answers *out);

#endif
