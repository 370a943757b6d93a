/* A traced frame: per primary ray the hit and the steps, and what tracing cost. */
#ifndef FRAME_H
#define FRAME_H

#include <stddef.h>
#include <stdint.h>

#include "hug.h"
#include "hug_kit.h"

typedef struct {
    uint32_t size; /* pixels along each side */
    size_t count;  /* size * size */
    hug_ray *rays; /* in tiles; pixel i of them is at xy[2 i], xy[2 i + 1] */
    uint32_t *xy;
    hug_hit *hits;
    uint32_t *steps; /* voxels that the ray visited */
    double seconds;  /* thread CPU time of hug_intersect_n over all rays */
} frame;

/* Traces the view. Returns 1, or 0 after a message. Free in both cases. */
int frame_trace(const hug_scene *built, const kit_view *view, uint32_t size, frame *out);
void frame_free(frame *f);

#endif
