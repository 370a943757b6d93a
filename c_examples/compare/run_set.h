/* One ray set through every structure and form and through Embree. */
#ifndef RUN_SET_H
#define RUN_SET_H

#include "compare/embree_side.h"
#include "compare/ray_sets.h"
#include "compare/report.h"
#include "compare/settings.h"
#include "hug.h"

typedef struct {
    const settings *with;
    const scene *from;
    hug_scene *built[COMPARED_COUNT]; /* NULL for those not asked for */
    build_figures builds[COMPARED_COUNT];
    embree_side embree;
    tally tallies[COMPARED_COUNT][RAY_SET_COUNT];
} comparison;

/* Times, judges and prints one set, and fills its tallies. Returns 1, or 0 after a message. */
int run_set(comparison *c, int set, const ray_set *rays);

#endif
