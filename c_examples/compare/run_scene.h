/* One scene from its file to its last view. */
#ifndef RUN_SCENE_H
#define RUN_SCENE_H

#include "compare/results.h"
#include "compare/settings.h"

/* Measures, judges, prints and keeps. The views by name; none: what the settings'
 * camera says. Returns 1, or 0 after a message, also if an answer of hug is wrong. */
int run_scene(const settings *with, const char *what, char *const *views, size_t count,
              results *found);

#endif
