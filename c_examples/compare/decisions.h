/* The differences of one view by class, and what the arbiter decided. */
#ifndef DECISIONS_H
#define DECISIONS_H

#include <stddef.h>
#include <stdio.h>

#include "compare/comparison.h"

/* Prints them, or that there are none. Returns how many were decided against hug. */
size_t print_decisions(FILE *to, const comparison *c);

#endif
