/* The structures by name, and building one from a scene. */
#ifndef STRUCTURES_H
#define STRUCTURES_H

#include "hug.h"
#include "scene.h"

#define STRUCTURE_COUNT 4

/* By HUG_STRUCTURE_*: auto, uniform, recursive, hug. */
extern const char *const structure_names[STRUCTURE_COUNT];

/* Builds what the options ask for; zeros are defaults, size and geometries are filled
 * in here. Returns 1, or 0 after a message. */
int structure_build(const scene *s, const hug_build_desc *options, hug_scene **out);

/* Returns 1, or 0 after a message. */
int structure_stats(const hug_scene *built, hug_scene_stats *out);

#endif
