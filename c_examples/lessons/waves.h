/* A mesh for programs that must not need a scene file: a square of side 1 around the
 * origin with waves on it, z up, that change with time. */
#ifndef WAVES_H
#define WAVES_H

#include <stddef.h>
#include <stdint.h>

#include "hug.h"

/* Squares along each side give that many vertices and triangles. */
#define WAVES_VERTICES(side) (((size_t)(side) + 1) * ((size_t)(side) + 1))
#define WAVES_TRIANGLES(side) (2 * (size_t)(side) * (size_t)(side))

/* Three floats a vertex; heights are below 0.1 either way. */
void waves_vertices(unsigned side, float time, float *vertices);

/* Three indices a triangle; they do not depend on time. */
void waves_indices(unsigned side, uint32_t *indices);

/* Both as a geometry that borrows them. */
hug_geometry waves_geometry(unsigned side, const float *vertices, const uint32_t *indices);

/* A descriptor of that one geometry, with defaults. */
hug_build_desc waves_desc(const hug_geometry *geometry);

/* The ray of a pixel of a picture of width x height, from above a corner. */
hug_ray waves_ray(unsigned x, unsigned y, unsigned width, unsigned height);

/* What the pixel looks like: grey by the light on it, 0 for a miss. */
unsigned char waves_shade(const hug_hit *hit);

/* FNV-1a over bytes, to compare results by one number. Start with WAVES_SEED. */
#define WAVES_SEED 0xcbf29ce484222325u
uint64_t waves_digest(uint64_t digest, const void *bytes, size_t count);

#endif
