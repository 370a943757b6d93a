/* How much of a ray lies in solid matter: all hits of a ray, in room for a few.
 *
 * What it teaches. Hits come in the order of t, each triangle once, so the room that a
 * program has need not be that of the longest answer: *more tells whether there are
 * others, and the last hit is where the next call goes on. A ray through an edge that two
 * triangles share hits both, at the same t; so what counts is not the number of hits but
 * the side that the ray comes from, the sign of the product of its direction and ng. */
#include <stdio.h>
#include <string.h>

#include "hug.h"

#define BOXES 3
#define ROOM 4

/* Boxes of side 1 and 2 apart along x, of 12 triangles each, normals outward. */
static const float corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
static const uint32_t face[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                     {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                     {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

static float vertices[BOXES][8][3];
static hug_geometry boxes[BOXES];

static hug_status build(hug_scene **scene)
{
    hug_build_desc desc;
    int i, j;
    memset(boxes, 0, sizeof boxes);
    for (i = 0; i < BOXES; i++) {
        memcpy(vertices[i], corner, sizeof corner);
        for (j = 0; j < 8; j++)
            vertices[i][j][0] += 2 * (float)i;
        boxes[i].vertices = vertices[i][0];
        boxes[i].vertex_count = 8;
        boxes[i].indices = face;
        boxes[i].index_type = HUG_INDEX_U32;
        boxes[i].triangle_count = 12;
    }
    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.geometries = boxes;
    desc.geometry_count = BOXES;
    return hug_build(&desc, scene);
}

/* Takes one hit; returns how long the ray was inside if it leaves the box there. */
static float cross(const hug_ray *ray, const hug_hit *hit, float entered[BOXES])
{
    int enters = ray->dir[0] * hit->ng[0] + ray->dir[1] * hit->ng[1] + ray->dir[2] * hit->ng[2] < 0;
    float length = 0;
    if (enters)
        entered[hit->geom] = hit->t;
    else if (entered[hit->geom] >= 0) {
        length = hit->t - entered[hit->geom];
        entered[hit->geom] = -1; /* the other triangle of an edge says the same again */
    }
    printf("t %g: %s box %u at triangle %u\n", hit->t, enters ? "enters" : "leaves",
           (unsigned)hit->geom, (unsigned)hit->prim);
    return length;
}

int main(void)
{
    /* along x through the middle of all boxes: the diagonals of their faces are there */
    hug_ray ray = {{-1, 0.5f, 0.5f}, 0, {1, 0, 0}, 100, 0xffffffffu, 0, HUG_NONE, HUG_NONE};
    float entered[BOXES] = {-1, -1, -1}, inside = 0;
    hug_hit hits[ROOM];
    hug_scene *scene;
    size_t count = 0, calls = 0, i;
    int32_t more;
    hug_status status = build(&scene);
    if (status != HUG_OK) {
        fprintf(stderr, "allhits: cannot build the scene: %s\n", hug_status_string(status));
        return 1;
    }
    do {
        /* from the last hit of the call before on, which is still there */
        const hug_hit *after = calls ? &hits[ROOM - 1] : NULL;
        status = hug_intersect_all(scene, &ray, after, hits, ROOM, &count, &more);
        if (status != HUG_OK) {
            fprintf(stderr, "allhits: %s\n", hug_status_string(status));
            hug_free(scene);
            return 1;
        }
        for (i = 0; i < count; i++)
            inside += cross(&ray, &hits[i], entered);
        calls++;
    } while (more);
    printf("%g inside, found in %u calls\n", inside, (unsigned)calls);
    hug_free(scene);
    return 0;
}
