/* Building every structure and Embree's scenes, timed in rounds. */
#ifndef RUN_BUILDS_H
#define RUN_BUILDS_H

#include "compare/comparison.h"

/* Fills what was built, and prints and keeps its rows. Returns 1, or 0 after a
 * message; release in both cases. */
int run_builds(comparison *c);
void release_builds(comparison *c);

#endif
