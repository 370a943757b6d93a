/* What compare prints, in the form that was asked for: as it comes, and at the end. */
#ifndef REPORT_H
#define REPORT_H

#include "compare/comparison.h"

/* What comes before everything, once. */
void report_begin(const settings *with);

/* A scene that was built; then each of its builds. */
void report_scene(const comparison *c);
void report_build(int format, const build_row *row);

/* A view of it; then each of its queries, with the build that answered. */
void report_view(const comparison *c);
void report_query(const comparison *c, const query_row *row, const build_row *build);

/* The differences of the view by class, and what the arbiter decided. Returns how
 * many were decided against hug. */
size_t report_decisions(const comparison *c);

/* Over all scenes, at the end. */
void report_summary(const settings *with, const results *found);

#endif
