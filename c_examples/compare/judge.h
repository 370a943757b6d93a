/* Where the two libraries differ, who is right by exact arithmetic. */
#ifndef JUDGE_H
#define JUDGE_H

#include "compare/differences.h"

/* Adds every difference to *t; what is decided against hug is also printed in full
 * on standard error. Returns 1, or 0 after a message if the arbiter failed. */
int judge_hits(const trial *what, const hug_hit *ours, const hug_hit *theirs, tally *t);
int judge_occlusion(const trial *what, const uint8_t *ours, const uint8_t *theirs, tally *t);

#endif
