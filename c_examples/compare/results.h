/* Everything that was measured, a row each, as it is printed. */
#ifndef RESULTS_H
#define RESULTS_H

#include <stddef.h>

#include "compare/differences.h"

/* Building one structure, or Embree's scene in one way. Times are medians. */
typedef struct {
    char scene[128];
    size_t triangles; /* that hug kept */
    const char *name; /* of the structure, or of Embree's build */
    int peer;         /* whether it is Embree's */
    unsigned threads;
    double cpu, wall; /* seconds of the process's CPU time, and by the wall */
    double reference_cpu, reference_wall; /* Embree's, medium quality, one thread */
    unsigned long long bytes, reference_bytes;
    unsigned long long grids, voxels, refs, triangle_bytes; /* of hug's arena */
} build_row;

/* One ray set through one contender. */
typedef struct {
    char scene[128], view[64];
    size_t triangles, rays; /* of the scene, of the set */
    const char *name;       /* of the structure, or of the peer */
    int peer;               /* whether it is one */
    int set, stream;
    const char *isa;                /* hug's; "" for a peer */
    double seconds, reference;      /* medians; Embree, a ray a call, default flags */
    double ratio_least, ratio_most; /* reference over own, round by round */
    size_t found[CLASS_COUNT];      /* hug from the reference, a peer from hug */
} query_row;

typedef struct {
    build_row *builds;
    size_t build_count;
    query_row *queries;
    size_t query_count;
} results;

/* Copies the row. Returns 1, or 0 after a message. */
int results_add_build(results *r, const build_row *row);
int results_add_query(results *r, const query_row *row);
void results_free(results *r);

/* closest, occluded, closest_stream or occluded_stream. */
const char *query_name(int set, int stream);

/* Reference over own, above 1: faster than Embree; 0 where there was no time to see. */
double ratio_of(double reference, double own);
double query_ratio(const query_row *row);
double build_ratio(const build_row *row);

/* Millions of them a second. */
double millions(size_t number, double seconds);

double bytes_per_triangle(unsigned long long bytes, size_t triangles);

#endif
