/* A ray and two answers in full, in numbers that can be typed in again. */
#ifndef JUDGE_PRINT_H
#define JUDGE_PRINT_H

#include "compare/differences.h"

/* Prints at most PRINT_MOST of the cases of a trial; nth counts them from 0. */
#define PRINT_MOST 100u

void print_hits(const trial *what, size_t nth, const char *why, size_t ray, const hug_hit *ours,
                const char *other, const hug_hit *theirs);
void print_occlusion(const trial *what, size_t nth, const char *why, size_t ray, int ours,
                     const char *other, int theirs);

#endif
