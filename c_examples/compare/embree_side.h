/* The same triangles in Embree: one thread, medium quality, default flags. */
#ifndef EMBREE_SIDE_H
#define EMBREE_SIDE_H

#include <embree3/rtcore.h>

#include "scene.h"

typedef struct {
    const scene *from; /* must outlive this */
    RTCDevice device;
    RTCScene built;
    long long bytes; /* that the device holds now */
} embree_side;

/* Returns 1, or 0 after a message. Close in both cases. */
int embree_open(const scene *from, embree_side *out);
void embree_close(embree_side *e);

/* Builds the scene, which embree_release must have released before.
 * Returns 1, or 0 after a message. */
int embree_build(embree_side *e);
void embree_release(embree_side *e);

#endif
