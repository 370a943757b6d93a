/* Building every structure and Embree's scene, timed in rounds. */
#ifndef RUN_BUILDS_H
#define RUN_BUILDS_H

#include "compare/run_set.h"

/* Fills built, builds and embree. Returns 1, or 0 after a message; release in
 * both cases. */
int run_builds(comparison *c);
void release_builds(comparison *c);

#endif
