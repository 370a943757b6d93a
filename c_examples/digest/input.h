/* A scene and rays for it, the same bits on every processor. */
#ifndef INPUT_H
#define INPUT_H

#include "hug.h"

#ifdef __cplusplus
extern "C" {
#endif

#define RAY_COUNT 2048

/* Two geometries: a soup of clusters, large triangles and repetitions; a mesh. */
const hug_geometry *input_geometries(size_t *count);

/* RAY_COUNT rays: across the scene, at vertices of the mesh, along axes, from far
 * away, and some that are no rays. */
const hug_ray *input_rays(void);

#ifdef __cplusplus
}
#endif

#endif
