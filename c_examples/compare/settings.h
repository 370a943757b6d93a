/* What compare's command line asks for. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <stdint.h>

#include "camera.h"
#include "compare/ray_sets.h"

/* The structures that can be compared, each in the place of its HUG_STRUCTURE_*. */
#define COMPARED_COUNT 4

#define MOST_ROUNDS 1000

enum { FORM_SINGLE, FORM_STREAM, FORM_COUNT };

typedef struct {
    const char *scene_name;
    const char *isa; /* NULL: what the library chooses */
    camera_options camera;
    unsigned structures; /* bit i: the structure i of HUG_STRUCTURE_* */
    unsigned sets;       /* bit i: ray set i */
    unsigned forms;      /* bit i: query form i */
    unsigned rounds, build_rounds;
    uint32_t size;
    int csv, help;
} settings;

/* Returns 1, or 0 after a message. */
int settings_read(int argc, char **argv, settings *out);

extern const char settings_help[];

#endif
