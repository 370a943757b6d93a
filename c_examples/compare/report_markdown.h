/* The tables of PERFORMANCE.md. */
#ifndef REPORT_MARKDOWN_H
#define REPORT_MARKDOWN_H

#include "compare/comparison.h"

void markdown_summary(const settings *with, const results *found);

#endif
