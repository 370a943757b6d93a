/* What a library answers to one ray set: closest hits, or occlusion. */
#ifndef ANSWERS_H
#define ANSWERS_H

#include <stddef.h>
#include <stdint.h>

#include "hug.h"

typedef struct {
    hug_hit *hits;     /* closest hits, */
    uint8_t *occluded; /* or occlusion; the other is NULL */
    size_t count;
} answers;

/* Returns 1, or 0 after a message. Free in both cases. */
int answers_make(size_t count, int occlusion, answers *out);
void answers_free(answers *a);

/* Both of the same kind and count. */
void answers_copy(answers *to, const answers *from);

#endif
