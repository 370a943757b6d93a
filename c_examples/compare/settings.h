/* What compare's command line asks for. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <stdint.h>

#include "camera.h"
#include "compare/isas.h"
#include "compare/ray_sets.h"
#include "hug.h"

/* The structures that can be compared, each in the place of its HUG_STRUCTURE_*. */
#define COMPARED_COUNT 4

#define MOST_ROUNDS 1000
#define MOST_THREADS 1024

/* Bits of settings.queries: single forms first, then streams. */
enum { QUERY_CLOSEST, QUERY_OCCLUDED, QUERY_CLOSEST_STREAM, QUERY_OCCLUDED_STREAM, QUERY_COUNT };

enum { FORMAT_TEXT, FORMAT_CSV, FORMAT_MARKDOWN };

typedef struct {
    const char *scene_name; /* NULL with --all */
    isa_list isas;
    camera_options camera;
    hug_build_desc build; /* what every structure is built with */
    unsigned structures;  /* bit i: the structure i of HUG_STRUCTURE_* */
    unsigned sets;        /* bit i: ray set i */
    unsigned queries;     /* bit i: QUERY_* */
    unsigned peers;       /* bit i: PEER_*, always with the reference */
    unsigned rounds, build_rounds, threads;
    uint32_t size;
    int all, every_view, format, help;
    int argc; /* the command line itself */
    char **argv;
} settings;

/* Returns 1, or 0 after a message. */
int settings_read(int argc, char **argv, settings *out);

/* Whether this set is to be asked in this form. */
int settings_asks(const settings *with, int set, int stream);

extern const char settings_help[];

#endif
