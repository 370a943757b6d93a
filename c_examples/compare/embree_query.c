#define _POSIX_C_SOURCE 200809L
#include "compare/embree_query.h"

#include <stdlib.h>
#include <string.h>

#include "hug_embree.h"
#include "message.h"

#define MOST_WIDTH 16u
#define RAY_WORDS (sizeof(struct RTCRay) / sizeof(uint32_t))
#define RAYHIT_WORDS (sizeof(struct RTCRayHit) / sizeof(uint32_t))

/* A packet of w rays is the record of one with every word w times. */
typedef char packet8_is[sizeof(struct RTCRayHit8) == 8 * sizeof(struct RTCRayHit) ? 1 : -1];
typedef char packet16_is[sizeof(struct RTCRay16) == 16 * sizeof(struct RTCRay) ? 1 : -1];

static size_t record_words(int occlusion)
{
    return occlusion ? RAY_WORDS : RAYHIT_WORDS;
}

int embree_records_make(size_t count, int occlusion, embree_records *out)
{
    void *memory = NULL;
    size_t bytes = (count + MOST_WIDTH) * record_words(occlusion) * sizeof(uint32_t);
    memset(out, 0, sizeof *out);
    out->count = count;
    out->occlusion = occlusion;
    if (posix_memalign(&memory, 64, bytes) != 0) {
        message("no memory for Embree's %lu rays", (unsigned long)count);
        return 0;
    }
    memset(memory, 0, bytes);
    out->words = (uint32_t *)memory;
    return 1;
}

void embree_records_free(embree_records *r)
{
    free(r->words);
    memset(r, 0, sizeof *r);
}

/* Where the first word of a ray is; the next is width words on. */
static uint32_t *first_word(const embree_query *q, size_t ray)
{
    size_t words = record_words(q->records->occlusion);
    size_t lane = ray % q->width;
    return q->records->words + (ray - lane) * words + lane;
}

static void put(const embree_query *q, size_t ray, const void *record)
{
    uint32_t words[RAYHIT_WORDS], *to = first_word(q, ray);
    size_t i, count = record_words(q->records->occlusion);
    memcpy(words, record, count * sizeof *words);
    for (i = 0; i < count; i++)
        to[i * q->width] = words[i];
}

static void get(const embree_query *q, size_t ray, void *record)
{
    uint32_t words[RAYHIT_WORDS];
    const uint32_t *from = first_word(q, ray);
    size_t i, count = record_words(q->records->occlusion);
    for (i = 0; i < count; i++)
        words[i] = from[i * q->width];
    memcpy(record, words, count * sizeof *words);
}

static int write_records(void *self)
{
    const embree_query *q = (const embree_query *)self;
    size_t i;
    for (i = 0; i < q->records->count; i++) {
        struct RTCRayHit record;
        if (q->records->occlusion)
            hug_embree_to_ray(&q->rays[i], &record.ray);
        else
            hug_embree_to_rayhit(&q->rays[i], &record);
        put(q, i, &record);
    }
    return 1;
}

void embree_query_answers(const embree_query *q, answers *out)
{
    size_t i;
    for (i = 0; i < q->records->count; i++) {
        struct RTCRayHit record;
        get(q, i, &record);
        if (q->records->occlusion)
            out->occluded[i] = (uint8_t)hug_embree_occluded(&record.ray);
        else
            out->hits[i] = hug_embree_hit(&record);
    }
}

static struct RTCIntersectContext context_of(const embree_query *q)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (q->coherent)
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

static int closest(void *self, size_t n)
{
    embree_query *q = (embree_query *)self;
    struct RTCIntersectContext context = context_of(q);
    struct RTCRayHit *records = (struct RTCRayHit *)q->records->words;
    size_t i;
    for (i = 0; i < n; i++)
        rtcIntersect1(q->built, &context, &records[i]);
    return 1;
}

static int occluded(void *self, size_t n)
{
    embree_query *q = (embree_query *)self;
    struct RTCIntersectContext context = context_of(q);
    struct RTCRay *records = (struct RTCRay *)q->records->words;
    size_t i;
    for (i = 0; i < n; i++)
        rtcOccluded1(q->built, &context, &records[i]);
    return 1;
}

/* One packet; of a last one that is not full some lanes are off. */
static void packet(embree_query *q, struct RTCIntersectContext *context, const int *valid,
                   size_t ray)
{
    void *record = first_word(q, ray);
    if (q->records->occlusion && q->width == 8)
        rtcOccluded8(valid, q->built, context, (struct RTCRay8 *)record);
    else if (q->records->occlusion)
        rtcOccluded16(valid, q->built, context, (struct RTCRay16 *)record);
    else if (q->width == 8)
        rtcIntersect8(valid, q->built, context, (struct RTCRayHit8 *)record);
    else
        rtcIntersect16(valid, q->built, context, (struct RTCRayHit16 *)record);
}

static int packets(void *self, size_t n)
{
    embree_query *q = (embree_query *)self;
    struct RTCIntersectContext context = context_of(q);
    union {
        int lanes[MOST_WIDTH];
        struct RTCRay16 aligned; /* Embree loads whole vectors */
    } valid;
    size_t ray, lane;
    for (lane = 0; lane < MOST_WIDTH; lane++)
        valid.lanes[lane] = -1;
    for (ray = 0; ray + q->width <= n; ray += q->width)
        packet(q, &context, valid.lanes, ray);
    for (lane = n - ray; lane < MOST_WIDTH; lane++)
        valid.lanes[lane] = 0;
    if (ray < n)
        packet(q, &context, valid.lanes, ray);
    return 1;
}

void embree_query_enter(embree_query *q, contender *out)
{
    out->prepare = write_records;
    if (q->width > 1)
        out->run = packets;
    else
        out->run = q->records->occlusion ? occluded : closest;
    out->self = q;
}
