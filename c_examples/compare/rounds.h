/* Timing that is fair between contenders: rounds in which each runs once, each round
 * beginning with another and going on in other steps; the first is in their order. */
#ifndef ROUNDS_H
#define ROUNDS_H

#include <stddef.h>

typedef struct {
    /* Not timed, before each run; NULL for nothing. Returns 1, or 0 after a message. */
    int (*prepare)(void *self);
    /* Timed: does the first n items. Returns 1, or 0 after a message. */
    int (*run)(void *self, size_t n);
    void *self;
    /* Not timed, after each run but the warm-up; NULL for nothing. */
    int (*finish)(void *owner, unsigned round);
    void *owner;
    double *seconds; /* one a round, by the clock that is given */
    double *wall;    /* the same by the wall, or NULL */
} contender;

/* Runs every contender on the first warm items (0: no warm-up), then rounds times
 * on all n. Returns 1, or 0 as soon as a run failed. */
int rounds_run(const char *label, contender *contenders, size_t count, size_t n, size_t warm,
               unsigned rounds, double (*clock)(void));

#endif
