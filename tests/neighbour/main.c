/* hug and another Rust library in one program. */
#include <stdio.h>

#include "hug.h"

int neighbour_answer(void);

int main(void)
{
    float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    hug_geometry mesh = {triangle, 3, 0, NULL, 1, HUG_INDEX_NONE, 0};
    hug_build_desc desc = {.struct_size = sizeof desc, .geometries = &mesh, .geometry_count = 1};
    hug_ray ray = {{0.25f, 0.5f, 2}, 0, {0, 0, -1}, 100, ~0u, 0, HUG_NONE, HUG_NONE};
    hug_scene *scene;
    hug_hit hit;
    int found, answer = neighbour_answer();
    if (hug_build(&desc, &scene) != HUG_OK)
        return 1;
    found = hug_intersect(scene, &ray, &hit);
    hug_free(scene);
    printf("%d %g %d\n", found, hit.t, answer);
    return found == 1 && hit.t == 2 && answer == 42 ? 0 : 1;
}
