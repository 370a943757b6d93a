/* The same triangles in Embree, built in one of its ways. */
#ifndef EMBREE_SIDE_H
#define EMBREE_SIDE_H

#include "compare/peers.h"
#include "scene.h"

typedef struct {
    const scene *from; /* must outlive this */
    const embree_kind *kind;
    RTCDevice device; /* NULL: never opened, or closed */
    RTCScene built;
    long long held;                 /* bytes that the device holds now */
    unsigned long long scene_bytes; /* of the scene built last */
} embree_side;

/* The place must stay where it is: the device counts its memory there. Returns 1, or 0
 * after a message. Close in both cases. */
int embree_open(const scene *from, const embree_kind *kind, unsigned threads, embree_side *out);
void embree_close(embree_side *e);

/* Builds the scene, which embree_release must have released before.
 * Returns 1, or 0 after a message. */
int embree_build(embree_side *e);
void embree_release(embree_side *e);

#endif
