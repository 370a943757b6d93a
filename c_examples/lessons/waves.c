#include "lessons/waves.h"

#include <math.h>
#include <string.h>

void waves_vertices(unsigned side, float time, float *vertices)
{
    unsigned x, y;
    for (y = 0; y <= side; y++)
        for (x = 0; x <= side; x++, vertices += 3) {
            float u = (float)x / (float)side - 0.5f, v = (float)y / (float)side - 0.5f;
            float distance = sqrtf(u * u + v * v);
            vertices[0] = u;
            vertices[1] = v;
            vertices[2] = 0.04f * sinf(40.0f * distance - time) / (1.0f + 6.0f * distance) +
                          0.02f * cosf(17.0f * u + 9.0f * v + 0.7f * time);
        }
}

void waves_indices(unsigned side, uint32_t *indices)
{
    unsigned x, y;
    for (y = 0; y < side; y++)
        for (x = 0; x < side; x++, indices += 6) {
            uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
            indices[0] = a, indices[1] = b, indices[2] = d;
            indices[3] = a, indices[4] = d, indices[5] = c;
        }
}

hug_geometry waves_geometry(unsigned side, const float *vertices, const uint32_t *indices)
{
    hug_geometry out;
    memset(&out, 0, sizeof out);
    out.vertices = vertices;
    out.vertex_count = WAVES_VERTICES(side);
    out.indices = indices;
    out.triangle_count = WAVES_TRIANGLES(side);
    out.index_type = HUG_INDEX_U32;
    return out;
}

hug_build_desc waves_desc(const hug_geometry *geometry)
{
    hug_build_desc out;
    memset(&out, 0, sizeof out);
    out.struct_size = sizeof out;
    out.geometries = geometry;
    out.geometry_count = 1;
    return out;
}

hug_ray waves_ray(unsigned x, unsigned y, unsigned width, unsigned height)
{
    /* The eye looks at the middle: right, up and ahead are unit vectors. */
    static const float eye[3] = {0.55f, -0.85f, 0.6f};
    static const float right[3] = {0.8396f, 0.5432f, 0}, up[3] = {-0.2770f, 0.4281f, 0.8602f};
    static const float ahead[3] = {-0.4673f, 0.7222f, -0.5098f};
    float u = 1.1f * ((x + 0.5f) / width - 0.5f);
    float v = 1.1f * (0.5f - (y + 0.5f) / height) * height / width;
    hug_ray ray;
    int k;
    memset(&ray, 0, sizeof ray);
    for (k = 0; k < 3; k++) {
        ray.org[k] = eye[k];
        ray.dir[k] = ahead[k] + u * right[k] + v * up[k];
    }
    ray.tmax = INFINITY;
    ray.mask = 0xffffffffu;
    ray.skip_geom = ray.skip_prim = HUG_NONE;
    return ray;
}

unsigned char waves_shade(const hug_hit *hit)
{
    static const float light[3] = {0.5f, 0.3f, 0.8124f};
    const float *n = hit->ng;
    float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), cosine;
    if (hit->geom == HUG_NONE || length == 0.0f)
        return 0;
    cosine = (n[0] * light[0] + n[1] * light[1] + n[2] * light[2]) / length;
    return (unsigned char)(40.0f + 210.0f * (cosine > 0.0f ? cosine * cosine * cosine : 0.0f));
}

uint64_t waves_digest(uint64_t digest, const void *bytes, size_t count)
{
    const unsigned char *byte = (const unsigned char *)bytes;
    size_t i;
    for (i = 0; i < count; i++)
        digest = (digest ^ byte[i]) * 0x100000001b3u;
    return digest;
}
