/* One scene in hug's structures and in Embree, and what is found on it. */
#ifndef COMPARISON_H
#define COMPARISON_H

#include "compare/embree_side.h"
#include "compare/results.h"
#include "compare/settings.h"

typedef struct {
    const settings *with;
    const scene *from;
    hug_scene *built[COMPARED_COUNT];    /* NULL for those not asked for */
    embree_side embree[EMBREE_BUILDS];   /* closed for those */
    build_row builds[COMPARED_COUNT];    /* of the structures, for their lines of CSV */
    build_row peer_builds[EMBREE_BUILDS];
    build_row threaded_builds[COMPARED_COUNT]; /* on --threads; name NULL without */
    build_row threaded;                        /* Embree's */
    const char *view_name;
    tally tallies[COMPARED_COUNT][RAY_SET_COUNT]; /* of the view */
    results *found;
} comparison;

#endif
