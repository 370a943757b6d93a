/* A program of somebody else's, built against an installed hug. */
#include <hug.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
    static const float vertices[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    hug_ray ray = {{0.25f, 0.5f, 2}, 0, {0, 0, -1}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    hug_geometry geometry;
    hug_build_desc desc;
    hug_scene *scene;
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
    if (hug_build(&desc, &scene) != HUG_OK)
        return 1;
    found = hug_intersect(scene, &ray, &hit);
    printf("hug %s: t %g\n", hug_version(), hit.t);
    hug_free(scene);
    return !found;
}
