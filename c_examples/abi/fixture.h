/* The little scene that the checks use: a bumpy sheet over the square from 0 to
 * 8 in x and y, seen by rays from above. */
#ifndef FIXTURE_H
#define FIXTURE_H

#include <stddef.h>
#include <stdint.h>

#include "hug.h"

#define FIXTURE_SIDE 8
#define FIXTURE_VERTICES ((FIXTURE_SIDE + 1) * (FIXTURE_SIDE + 1))
#define FIXTURE_TRIANGLES (2 * FIXTURE_SIDE * FIXTURE_SIDE)
#define FIXTURE_RAYS 400

typedef struct {
    float vertices[3 * FIXTURE_VERTICES];
    uint32_t indices[3 * FIXTURE_TRIANGLES];
    uint16_t short_indices[3 * FIXTURE_TRIANGLES];
    hug_geometry geometry; /* with indices of 32 bits */
    hug_build_desc desc;   /* of this one geometry */
} fixture;

/* The descriptor points into the fixture: it must not be copied. */
void fixture_make(fixture *f);

/* Ray i of FIXTURE_RAYS; most hit the sheet, some pass beside it. */
hug_ray fixture_ray(unsigned i);

/* The hits of all the rays. */
void fixture_hits(const hug_scene *scene, hug_hit hits[FIXTURE_RAYS]);

/* Memory aligned to 64, no byte longer than size. Ends the program if there is none. */
void *fixture_memory(size_t size);

/* A built scene, by the default allocator. Ends the program if that fails. */
hug_scene *fixture_build(const hug_build_desc *desc);

/* Calls check with the fixture's scene in every structure, one after the other. */
void fixture_structures(void (*check)(const hug_scene *scene));

#endif
