/* What it teaches: the shortest complete use of hug: one triangle, one ray, every call
 * checked. */
#include <stdio.h>
#include <string.h>

#include "hug.h"

int main(void)
{
    static const float vertices[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    hug_geometry geometry;
    hug_build_desc desc;
    hug_scene *scene;
    hug_status status;
    hug_ray ray = {{0.25f, 0.5f, 2}, 0, {0, 0, -1}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_hit hit;
    int found;

    memset(&geometry, 0, sizeof geometry);
    geometry.vertices = vertices;
    geometry.vertex_count = 3;
    geometry.triangle_count = 1;

    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.geometries = &geometry;
    desc.geometry_count = 1;

    status = hug_build(&desc, &scene);
    if (status != HUG_OK) {
        fprintf(stderr, "minimal: cannot build the scene: %s\n", hug_status_string(status));
        return 1;
    }
    found = hug_intersect(scene, &ray, &hit);
    if (found)
        printf("t %g, u %g, v %g, geometry %u, primitive %u\n", hit.t, hit.u, hit.v,
               (unsigned)hit.geom, (unsigned)hit.prim);
    else
        fprintf(stderr, "minimal: the ray missed the triangle\n");
    hug_free(scene);
    return found ? 0 : 1;
}
