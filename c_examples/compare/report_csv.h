/* A line a query; builds and decisions are in the columns of each. */
#ifndef REPORT_CSV_H
#define REPORT_CSV_H

#include "compare/comparison.h"

void csv_begin(const settings *with);
/* threaded: Embree's build on --threads, and hug_threaded, or NULL, hug's; printed only
 * if that is above 1. */
void csv_query(const settings *with, const query_row *row, const build_row *build,
               const build_row *threaded, const build_row *hug_threaded);
/* More lines, whose scene is "geomean" or "minimum"; query is "build" for builds. */
void csv_summary(const settings *with, const results *found);

#endif
