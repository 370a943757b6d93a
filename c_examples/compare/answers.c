#include "compare/answers.h"

#include <stdlib.h>
#include <string.h>

#include "message.h"

int answers_make(size_t count, int occlusion, answers *out)
{
    memset(out, 0, sizeof *out);
    out->count = count;
    /* one more, so that no rays is no special case */
    if (occlusion)
        out->occluded = (uint8_t *)calloc(count + 1, 1);
    else
        out->hits = (hug_hit *)calloc(count + 1, sizeof *out->hits);
    if (!out->occluded && !out->hits)
        message("no memory for the answers to %lu rays", (unsigned long)count);
    return out->occluded || out->hits;
}

void answers_free(answers *a)
{
    free(a->hits);
    free(a->occluded);
    memset(a, 0, sizeof *a);
}

void answers_copy(answers *to, const answers *from)
{
    if (from->hits)
        memcpy(to->hits, from->hits, from->count * sizeof *from->hits);
    else
        memcpy(to->occluded, from->occluded, from->count);
}
