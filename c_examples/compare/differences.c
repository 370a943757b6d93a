#include "compare/differences.h"

#include <math.h>
#include <string.h>

#include "compare/judge_print.h"

int difference_class(const hug_hit *ours, const hug_hit *theirs)
{
    float larger = fmaxf(fabsf(ours->t), fabsf(theirs->t));
    if ((ours->geom == HUG_NONE) != (theirs->geom == HUG_NONE))
        return CLASS_HIT;
    if (ours->geom == HUG_NONE)
        return CLASS_COUNT;
    /* written so that a NaN is a difference */
    if (!(fabsf(ours->t - theirs->t) <= 1e-4f * larger))
        return CLASS_T;
    return ours->prim != theirs->prim || ours->geom != theirs->geom ? CLASS_TIE : CLASS_COUNT;
}

void differences_count(const answers *exact, const answers *theirs, tally *t)
{
    size_t i;
    for (i = 0; i < exact->count; i++) {
        int class_of = CLASS_COUNT;
        if (exact->hits)
            class_of = difference_class(&exact->hits[i], &theirs->hits[i]);
        else if (!exact->occluded[i] != !theirs->occluded[i])
            class_of = CLASS_HIT;
        if (class_of != CLASS_COUNT)
            t->found[class_of]++;
    }
}

/* Not by memcmp of the whole: what differs is printed ray by ray. */
void differences_within(const trial *what, const char *other, const answers *a,
                        const answers *b, tally *t)
{
    size_t i, wrong = 0;
    for (i = 0; i < what->count; i++) {
        const char *why = "hug contradicts itself";
        if (a->hits && memcmp(&a->hits[i], &b->hits[i], sizeof a->hits[i]) != 0)
            print_hits(what, wrong++, why, i, &a->hits[i], other, &b->hits[i]);
        else if (a->occluded && a->occluded[i] != b->occluded[i])
            print_occlusion(what, wrong++, why, i, a->occluded[i], other, b->occluded[i]);
    }
    t->inconsistent += wrong;
}

size_t tally_found(const tally *t)
{
    size_t found = t->inconsistent;
    int i;
    for (i = 0; i < CLASS_COUNT; i++)
        found += t->found[i];
    return found;
}

size_t tally_wrong(const tally *t)
{
    size_t wrong = t->inconsistent;
    int i;
    for (i = 0; i < CLASS_COUNT; i++)
        wrong += t->decided[i][KIT_THEIRS];
    return wrong;
}
