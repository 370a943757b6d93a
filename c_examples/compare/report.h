/* What compare prints: CSV, or tables with the same figures. */
#ifndef REPORT_H
#define REPORT_H

#include <stddef.h>

#include "compare/judge.h"
#include "scene.h"

/* What building took, for hug's structure and for Embree. */
typedef struct {
    const char *structure;
    size_t triangles; /* that hug kept */
    double hug_seconds, embree_seconds;
    unsigned long long hug_bytes, embree_bytes;
} build_figures;

/* What one ray set took, in one form of query. */
typedef struct {
    const char *set, *query;
    size_t rays;
    double hug_seconds, embree_seconds; /* medians */
    double ratio_least, ratio_most;     /* of Embree's time and hug's, round by round */
} query_figures;

/* dropped: triangles that no structure of hug has. */
void report_begin(int csv, const scene *s, size_t dropped);
void report_build(int csv, const build_figures *build);
void report_queries(int csv);
void report_line(int csv, const scene *s, const build_figures *build, const query_figures *query,
                 const tally *t);

/* The differences of one structure and ray set by class, and what the arbiter
 * decided: to standard output, with CSV to standard error. report_decided comes
 * first, and says so if there are none at all. */
void report_decided(int csv, int any);
void report_decisions(int csv, const build_figures *build, const char *set, const tally *t);

#endif
