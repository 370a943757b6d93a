/* Where the two libraries differ, by class, and who is right by exact arithmetic. */
#ifndef JUDGE_H
#define JUDGE_H

#include <stddef.h>
#include <stdint.h>

#include "hug.h"
#include "scene.h"

/* One hits and the other misses; t differs by more than 1e-4 of the larger; t does
 * not, but the triangle does (a tie). */
enum { CLASS_HIT, CLASS_T, CLASS_TIE, CLASS_COUNT };

typedef struct {
    size_t found[CLASS_COUNT];
    /* by verdict: KIT_BOTH both are right, KIT_OURS hug alone, KIT_THEIRS hug is wrong */
    size_t decided[CLASS_COUNT][3];
    size_t inconsistent; /* answers of hug that differ from hug's own in another form */
} tally;

/* What is judged, for the arbiter and for messages. */
typedef struct {
    const scene *from;
    const hug_scene *built;
    const char *structure, *set;
    const hug_ray *rays;
    size_t count;
} trial;

/* Adds every difference to *t; what is decided against hug is also printed in full
 * on standard error. Returns 1, or 0 after a message if the arbiter failed. */
int judge_hits(const trial *what, const hug_hit *ours, const hug_hit *theirs, tally *t);
int judge_occlusion(const trial *what, const uint8_t *ours, const uint8_t *theirs, tally *t);

/* hug's answers in one form and in another must be the same bits: counts and prints
 * those that are not. other names the second form. */
void judge_same_hits(const trial *what, const char *other, const hug_hit *a, const hug_hit *b,
                     tally *t);
void judge_same_occlusion(const trial *what, const char *other, const uint8_t *a,
                          const uint8_t *b, tally *t);

/* How many differences there are, and how many were decided against hug. */
size_t tally_found(const tally *t);
size_t tally_wrong(const tally *t);

#endif
