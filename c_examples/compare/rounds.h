/* Timing that is fair between contenders: rounds in which each runs once, in an
 * order that rotates, so that no one always follows the same other. */
#ifndef ROUNDS_H
#define ROUNDS_H

#include <stddef.h>

typedef struct {
    /* Not timed, before each run; NULL for nothing. */
    void (*prepare)(void *self);
    /* Timed: does the first n items. Returns 1, or 0 after a message. */
    int (*run)(void *self, size_t n);
    void *self;
    double *seconds; /* one a round */
} contender;

/* Runs every contender on the first warm items (0: no warm-up), then rounds times
 * on all n. Returns 1, or 0 as soon as a run failed. */
int rounds_run(const char *label, contender *contenders, size_t count, size_t n, size_t warm,
               unsigned rounds, double (*clock)(void));

#endif
