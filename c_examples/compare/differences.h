/* Where answers to the same rays differ, by class. */
#ifndef DIFFERENCES_H
#define DIFFERENCES_H

#include <stddef.h>
#include <stdint.h>

#include "compare/answers.h"
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

/* The class of a difference, or CLASS_COUNT for none. */
int difference_class(const hug_hit *ours, const hug_hit *theirs);

/* Counts where another's answers differ from exact ones, by class; nothing is decided. */
void differences_count(const answers *exact, const answers *theirs, tally *t);

/* hug's answers in one form and in another must be the same bits: counts and prints
 * those that are not. other names the second form. */
void differences_within(const trial *what, const char *other, const answers *a,
                        const answers *b, tally *t);

/* How many differences there are, and how many were decided against hug. */
size_t tally_found(const tally *t);
size_t tally_wrong(const tally *t);

#endif
