/* Geometric means and minima over the scenes and views that were measured. */
#ifndef SUMMARY_H
#define SUMMARY_H

#include "compare/results.h"

typedef struct {
    size_t count;         /* ratios that went in */
    double mean, least;   /* of the ratios to Embree; 0 without any */
    const char *scene;    /* of the least */
    const char *view;     /* the same; "" for a build */
    double bytes;         /* builds: geometric mean of bytes per triangle */
    double wall;          /* builds: geometric mean of the ratios by the wall */
    double mega;          /* builds: of millions of triangles a second of CPU time */
} summary;

/* Whether no row before this one is of the same contender; for first_query: and set. */
int first_contender(const results *r, size_t row);
int first_query(const results *r, size_t row);
int first_build(const results *r, size_t row);

/* Over all rows of the same contender, and ray set. */
summary sum_queries(const results *r, const query_row *like);
summary sum_builds(const results *r, const build_row *like);

/* The row of a contender's query in another set: the first one, or NULL. */
const query_row *same_in_set(const results *r, const query_row *like, int set);

#endif
