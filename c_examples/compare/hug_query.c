#include "compare/hug_query.h"

#include "message.h"

static int choose_isa(void *self)
{
    const hug_query *q = (const hug_query *)self;
    hug_status status = hug_force_isa(q->isa);
    if (status != HUG_OK)
        message("instruction set %s: %s", q->isa, hug_status_string(status));
    return status == HUG_OK;
}

static int closest(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    size_t i;
    for (i = 0; i < n; i++)
        hug_intersect(q->built, &q->rays[i], &q->out->hits[i]);
    return 1;
}

static int closest_stream(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    hug_intersect_n(q->built, q->rays, 0, q->out->hits, 0, n);
    return 1;
}

static int occluded(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    size_t i;
    for (i = 0; i < n; i++)
        q->out->occluded[i] = (uint8_t)hug_occluded(q->built, &q->rays[i]);
    return 1;
}

static int occluded_stream(void *self, size_t n)
{
    hug_query *q = (hug_query *)self;
    hug_occluded_n(q->built, q->rays, 0, q->out->occluded, n);
    return 1;
}

void hug_query_enter(hug_query *q, int stream, contender *out)
{
    if (q->out->hits)
        out->run = stream ? closest_stream : closest;
    else
        out->run = stream ? occluded_stream : occluded;
    out->prepare = choose_isa;
    out->self = q;
}
