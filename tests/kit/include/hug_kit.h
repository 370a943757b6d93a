/* hug_kit.h - what the tests, benches and C examples of hug share: built-in
 * scenes, ray sets, and an exact-arithmetic arbiter. It shares no code with the
 * library it judges. Not part of the product: link libhug_kit.so beside libhug.a.
 *
 * Every function tolerates NULL: those returning kit_status answer KIT_ERR_NULL,
 * those returning a count or a pointer answer 0 or NULL, frees do nothing.
 * No function keeps a pointer it was given. Functions without shared arguments
 * may run on any number of threads.
 */
#ifndef HUG_KIT_H
#define HUG_KIT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t kit_status;
#define KIT_OK 0
#define KIT_ERR_NULL 1     /* a required pointer was NULL */
#define KIT_ERR_NAME 2     /* no such scene, or an unreadable size after ':' */
#define KIT_ERR_RANGE 3    /* an index, count or enumeration is out of range */
#define KIT_ERR_CAPACITY 4 /* the output array is too small; *written says how many it needs */
#define KIT_ERR_SOUP 5     /* a triangle names a vertex that does not exist */
#define KIT_ERR_INTERNAL 6 /* a defect of the kit itself */

/* Never NULL; unknown codes give "unknown status". */
const char *kit_status_string(kit_status status);

/* ---- plain data: the layouts of hug_ray and hug_hit, byte for byte ---- */

#define KIT_NONE 0xffffffffu /* no triangle: a miss, or nothing to skip */

typedef struct kit_ray {
    float org[3], tmin, dir[3], tmax;
    uint32_t mask, flags, skip_geom, skip_prim;
} kit_ray; /* 48 bytes */

/* A miss has geom == KIT_NONE. The ray sets read only t, ng and geom. */
typedef struct kit_hit {
    float t, u, v, ng[3];
    uint32_t geom, prim, inst, reserved;
} kit_hit; /* 40 bytes */

typedef struct kit_box {
    float lo[3], hi[3];
} kit_box;

/* A square pinhole camera: fov_deg is the vertical (and horizontal) field of
 * view; up need not be orthogonal to at - eye. */
typedef struct kit_view {
    float eye[3], at[3], up[3], fov_deg;
} kit_view;

/* ---- built-in scenes (y is up, unit 1 metre) ---- */

typedef struct kit_scene kit_scene;

/* The names are "kitchen", "building_walls", "building", "city", "garden".
 * kit_scene_name returns NULL for index >= kit_scene_count(). */
size_t kit_scene_count(void);
const char *kit_scene_name(size_t index);

/* Generates a scene by name; the same bytes every time and everywhere. Besides
 * the names above: "surface:N", "uniform:N", "clustered:N" with about N
 * triangles, 1 <= N <= 50000000. Free it with kit_scene_free. */
kit_status kit_scene_generate(const char *name, kit_scene **out);
void kit_scene_free(kit_scene *scene);

/* Borrowed until kit_scene_free: 3 floats a vertex, 3 indices a triangle. */
const float *kit_scene_vertices(const kit_scene *scene, size_t *vertex_count);
const uint32_t *kit_scene_indices(const kit_scene *scene, size_t *triangle_count);
kit_status kit_scene_bounds(const kit_scene *scene, kit_box *out);

/* Views: at least one, all inside the scene. name may be NULL; what it receives
 * is borrowed until kit_scene_free. */
size_t kit_scene_view_count(const kit_scene *scene);
kit_status kit_scene_view(const kit_scene *scene, size_t index, const char **name, kit_view *out);

/* For scenes without a view: inside the box, along its longest horizontal axis. */
kit_status kit_view_derived(const kit_box *bounds, kit_view *out);

/* The box of vertices with a stride in bytes (a multiple of 4, at least 12);
 * vertices that are not finite are left out. KIT_ERR_RANGE when none is left. */
kit_status kit_bounds(const float *vertices, size_t stride, size_t vertex_count, kit_box *out);

/* ---- ray sets: written once, the same bytes for every library ---- */

#define KIT_FRAME 1024u            /* the frame size of the comparisons */
#define KIT_RANDOM_COUNT 1048576u  /* rays of the random set */
#define KIT_MAX_FRAME 16384u

/* size x size pixel centres in 8 x 8 tiles (tiles at the right and bottom edge
 * are cut off when size is no multiple of 8): size * size rays. */
size_t kit_primary_count(uint32_t size);
kit_status kit_rays_primary(const kit_view *view, uint32_t size,
                            kit_ray *out, size_t capacity, size_t *written);

/* The pixel (column, row from the top) of each primary ray, two values a ray. */
kit_status kit_primary_pixels(uint32_t size, uint32_t *xy, size_t capacity, size_t *written);

/* From the hit of one pixel of each 2 x 2 block, four rays (occlusion). rays and
 * hits are the size * size primary ones, in their order. */
size_t kit_shadow_count(uint32_t size, const kit_hit *hits);
kit_status kit_rays_shadow(const kit_box *bounds, uint32_t size, const kit_ray *rays,
                           const kit_hit *hits, kit_ray *out, size_t capacity, size_t *written);

/* Cosine-weighted from each of n hits. number is 1 when rays and hits are the
 * primary ones, 2 when they are those of bounce 1. */
size_t kit_bounce_count(const kit_hit *hits, size_t n);
kit_status kit_rays_bounce(uint32_t number, const kit_box *bounds, const kit_ray *rays,
                           const kit_hit *hits, size_t n,
                           kit_ray *out, size_t capacity, size_t *written);

/* n rays (the set has KIT_RANDOM_COUNT), origins uniform in the box, directions
 * uniform on the sphere; a shorter set is a prefix of a longer one. */
kit_status kit_rays_random(const kit_box *bounds, kit_ray *out, size_t n);

/* ---- the arbiter: exact rational arithmetic ---- */

/* One geometry with id 0, primitive ids by position. vertices are 3 floats each,
 * without gaps; indices NULL means vertices 3i, 3i+1, 3i+2 make triangle i. */
typedef struct kit_soup {
    const float *vertices;
    size_t vertex_count;
    const uint32_t *indices;
    size_t triangle_count;
} kit_soup;

typedef int32_t kit_verdict;
#define KIT_BOTH 0   /* both answers are right */
#define KIT_OURS 1   /* ours is right, theirs is not */
#define KIT_THEIRS 2 /* ours is wrong: an error, whatever theirs is */

/* The closest hit by exact arithmetic over every triangle: smallest t (rounded
 * once to float), ties by lowest primitive. inst = KIT_NONE; a miss has
 * t = tmax and all ids KIT_NONE. Slow: linear in the triangles. */
kit_status kit_exact_closest(const kit_soup *soup, const kit_ray *ray, kit_hit *out);

/* Judges two claims about the closest hit: the primitive each library reported,
 * or KIT_NONE for a miss. Only the two triangles named are looked at. */
kit_status kit_judge_closest(const kit_soup *soup, const kit_ray *ray,
                             uint32_t ours, uint32_t theirs, kit_verdict *out);

/* Judges two claims about occlusion (0 or not 0); looks at every triangle. */
kit_status kit_judge_occluded(const kit_soup *soup, const kit_ray *ray,
                              int32_t ours, int32_t theirs, kit_verdict *out);

#ifdef __cplusplus
}
#endif

#endif
