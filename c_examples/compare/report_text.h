/* Tables to read. */
#ifndef REPORT_TEXT_H
#define REPORT_TEXT_H

#include "compare/comparison.h"

void text_scene(const comparison *c);
void text_build(const build_row *row);
void text_view(const char *name);
void text_query(const query_row *row);
void text_summary(const results *found);

#endif
