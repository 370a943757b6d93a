/* Coordinates are integers, made floats by steps that do not round: so neither the
 * compiler nor the processor has a say. */
#include "digest/input.h"

#include "freestanding/runtime.h"

#define CLUSTERS 10
#define IN_CLUSTER 150
#define LARGE 40
#define REPEATED 60
#define SOUP (CLUSTERS * IN_CLUSTER + LARGE + REPEATED)
#define SIDE 17
#define MESH (2 * (SIDE - 1) * (SIDE - 1))
/* Half the scene's width, and the units in 1. */
#define HALF (1 << 20)
#define UNITS 1024.0f

static float soup[SOUP][3][3];
static int32_t mesh_places[SIDE * SIDE][3];
static float mesh[SIDE * SIDE][3];
static uint32_t mesh_indices[MESH][3];
static hug_geometry geometries[2];
static hug_ray rays[RAY_COUNT];

/* Marsaglia's xorshift */
static uint32_t drawn = 2463534242u;

static uint32_t draw(void)
{
    drawn ^= drawn << 13;
    drawn ^= drawn >> 17;
    drawn ^= drawn << 5;
    return drawn;
}

/* From -half to half - 1; half is a power of two. */
static int32_t about(int32_t half)
{
    return (int32_t)(draw() >> 8 & (2 * (uint32_t)half - 1)) - half;
}

static void make_soup(void)
{
    int32_t centre[3] = {0, 0, 0};
    size_t i, j, k;
    for (i = 0; i < SOUP - REPEATED; i++) {
        int large = i >= CLUSTERS * IN_CLUSTER;
        int32_t place[3];
        if (i % IN_CLUSTER == 0)
            for (k = 0; k < 3; k++)
                centre[k] = i ? about(HALF / 2) : 0;
        for (k = 0; k < 3; k++)
            place[k] = large ? about(HALF / 2) : centre[k] + about(HALF / 32);
        for (j = 0; j < 3; j++)
            for (k = 0; k < 3; k++)
                soup[i][j][k] =
                    (float)(place[k] + about(large ? HALF / 2 : HALF / 128)) / UNITS;
    }
    for (; i < SOUP; i++)
        memcpy(soup[i], soup[(i - (SOUP - REPEATED)) * 7], sizeof soup[i]);
}

static void make_mesh(void)
{
    uint32_t x, y, k, corner, (*out)[3] = mesh_indices;
    for (y = 0; y < SIDE; y++) {
        for (x = 0; x < SIDE; x++) {
            int32_t *place = mesh_places[y * SIDE + x];
            place[0] = (int32_t)x * (2 * HALF / (SIDE - 1)) - HALF;
            place[1] = (int32_t)y * (2 * HALF / (SIDE - 1)) - HALF;
            place[2] = about(HALF / 8) - HALF / 2;
            for (k = 0; k < 3; k++)
                mesh[y * SIDE + x][k] = (float)place[k] / UNITS;
        }
    }
    for (y = 0; y + 1 < SIDE; y++) {
        for (x = 0; x + 1 < SIDE; x++, out += 2) {
            corner = y * SIDE + x;
            out[0][0] = out[1][0] = corner;
            out[0][1] = corner + 1;
            out[0][2] = out[1][1] = corner + SIDE + 1;
            out[1][2] = corner + SIDE;
        }
    }
}

const hug_geometry *input_geometries(size_t *count)
{
    make_soup();
    make_mesh();
    memset(geometries, 0, sizeof geometries);
    geometries[0].vertices = soup[0][0];
    geometries[0].vertex_count = 3 * SOUP;
    geometries[0].triangle_count = SOUP;
    geometries[0].mask = 1;
    geometries[1].vertices = mesh[0];
    geometries[1].vertex_count = SIDE * SIDE;
    geometries[1].indices = mesh_indices;
    geometries[1].index_type = HUG_INDEX_U32;
    geometries[1].triangle_count = MESH;
    geometries[1].mask = 2;
    *count = 2;
    return geometries;
}

/* A ray from the target, back by 2^shift times the direction. */
static void aim(hug_ray *ray, const int32_t *target, const int32_t *dir, int shift)
{
    size_t k;
    for (k = 0; k < 3; k++) {
        int64_t org = target[k] - (int64_t)dir[k] * ((int64_t)1 << shift);
        ray->org[k] = (float)org / UNITS;
        ray->dir[k] = (float)dir[k] / UNITS;
    }
}

static float from_bits(uint32_t bits)
{
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static void make_ray(hug_ray *ray, uint32_t kind)
{
    /* One draw a statement: C leaves open which of two in an expression is first. */
    static const int32_t middle[3] = {0, 0, 0};
    int32_t target[3], dir[3];
    uint32_t some = draw(), axis = draw() % 3;
    size_t k;
    for (k = 0; k < 3; k++) {
        target[k] = about(HALF / 2);
        dir[k] = about(HALF);
    }
    ray->tmin = 0;
    ray->tmax = 1e30f;
    ray->mask = 0xffffffffu;
    ray->flags = 0;
    ray->skip_geom = ray->skip_prim = HUG_NONE;
    switch (kind) {
    case 0: /* from within, and from a little outside */
        aim(ray, target, dir, (int)(some % 2));
        break;
    case 1: /* at a vertex of the mesh, where six triangles meet */
        aim(ray, mesh_places[some % (SIDE * SIDE)], dir, (int)axis);
        ray->mask = some >> 31 ? 2 : 0xffffffffu;
        break;
    case 2: /* in an axis' plane or along an axis, -0 included */
        dir[axis] = 0;
        if (some % 2)
            dir[(axis + 1) % 3] = 0;
        aim(ray, target, dir, 1);
        for (k = 0; k < 3; k++)
            if (dir[k] == 0 && some >> 31)
                ray->dir[k] = -0.0f;
        break;
    case 3: /* from farther and farther away, through the first cluster */
        aim(ray, middle, dir, (int)(some % 37));
        break;
    case 4: /* the whole line */
        aim(ray, target, dir, (int)(some % 24));
        ray->tmin = -from_bits(0x7f800000u);
        ray->tmax = from_bits(0x7f800000u);
        break;
    case 5: /* a part of the line, on both sides of the origin */
        aim(ray, target, dir, 0);
        ray->tmin = (float)about(1 << 10) / 1024.0f;
        ray->tmax = ray->tmin + (float)(some % 1024) / 512.0f;
        break;
    case 6: /* nearly in an axis' plane, and without one triangle of the mesh */
        dir[axis] = 1;
        aim(ray, target, dir, 1);
        ray->skip_geom = 1;
        ray->skip_prim = some % MESH;
        break;
    default: /* a number that is none, or is infinite */
        aim(ray, target, dir, 0);
        (some % 2 ? ray->org : ray->dir)[axis] = from_bits(some >> 31 ? 0x7fc00000u : 0xff800000u);
    }
}

const hug_ray *input_rays(void)
{
    uint32_t i;
    for (i = 0; i < RAY_COUNT; i++)
        make_ray(&rays[i], i % 32 == 31 ? 7 : i % 7);
    return rays;
}
