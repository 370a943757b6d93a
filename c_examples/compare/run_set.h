/* One ray set through every structure, form and instruction set, and through Embree. */
#ifndef RUN_SET_H
#define RUN_SET_H

#include "compare/comparison.h"

/* Times, judges, prints and keeps one set, and fills its tallies. Returns 1, or 0
 * after a message. */
int run_set(comparison *c, int set, const ray_set *rays);

#endif
