/* What it teaches: hug on whatever processor this is compiled for. A renderer that is
 * ported wants to know that it draws the same picture: results of hug depend neither on
 * the processor nor on the instruction set in use, so a few numbers tell. This program
 * builds a fixed scene in static memory, in every structure and with a tree of boxes,
 * traces fixed rays in every form of query and on every instruction set that
 * hug_force_isa takes, and prints digests:
 *
 *     scene: the bytes of the four arenas
 *     hits: what hug_intersect, hug_occluded and the streams said
 *     counts: what hug_intersect_counted counted
 *
 * They are the same everywhere, and it fails if two instruction sets differ. All it
 * needs of the system is runtime_write: freestanding/ has that for a hosted program,
 * for Linux without a C library and for WebAssembly. */
#include "digest/input.h"
#include "freestanding/runtime.h"
#include "hug.h"

#define ARENA_BYTES (2u << 20)
#define SCRATCH_BYTES (8u << 20)

static unsigned char arena[ARENA_BYTES] __attribute__((aligned(64)));
static unsigned char scratch[SCRATCH_BYTES] __attribute__((aligned(64)));
static hug_hit hits[RAY_COUNT];
static uint8_t occluded[RAY_COUNT];

#define STRUCTURES 4
static const struct {
    hug_structure structure;
    uint32_t flags;
} structures[STRUCTURES] = {{HUG_STRUCTURE_UNIFORM, 0},
                            {HUG_STRUCTURE_RECURSIVE, 0},
                            {HUG_STRUCTURE_HUG, 0},
                            {HUG_STRUCTURE_RECURSIVE, HUG_BUILD_TREE}};
static const char *const isas[4] = {"portable", "avx2", "avx512", "neon"};

/* FNV-1a */
#define DIGEST_START 0xcbf29ce484222325u

static void digest(uint64_t *sum, const void *data, size_t size)
{
    const unsigned char *byte = (const unsigned char *)data;
    size_t i;
    for (i = 0; i < size; i++)
        *sum = (*sum ^ byte[i]) * 0x100000001b3u;
}

static void write_digest(const char *name, uint64_t sum)
{
    char text[17];
    int i;
    for (i = 0; i < 16; i++)
        text[i] = "0123456789abcdef"[sum >> (60 - 4 * i) & 15];
    text[16] = '\0';
    runtime_write(name);
    runtime_write(text);
}

static const hug_scene *build(const hug_geometry *geometries, size_t count, int number)
{
    hug_build_desc desc;
    const hug_scene *scene = NULL;
    size_t arena_bytes = 0, scratch_bytes = 0;
    hug_status status;

    memset(&desc, 0, sizeof desc);
    desc.struct_size = sizeof desc;
    desc.geometries = geometries;
    desc.geometry_count = count;
    desc.structure = structures[number].structure;
    desc.flags = structures[number].flags;
    status = hug_measure(&desc, &arena_bytes, &scratch_bytes);
    if (status == HUG_OK && (arena_bytes > ARENA_BYTES || scratch_bytes > SCRATCH_BYTES)) {
        runtime_write("digest: the scene needs more than the static memory\n");
        return NULL;
    }
    if (status == HUG_OK)
        status = hug_build_into(&desc, scratch, scratch_bytes, arena, arena_bytes, &scene);
    if (status != HUG_OK) {
        runtime_write("digest: ");
        runtime_write(hug_status_string(status));
        runtime_write("\n");
    }
    return scene;
}

static void trace(const hug_scene *scene, const hug_ray *rays, uint64_t *found, uint64_t *counted)
{
    hug_counters counters;
    hug_hit hit;
    size_t i;
    for (i = 0; i < RAY_COUNT; i++) {
        int32_t hits_any = hug_occluded(scene, &rays[i]);
        hug_intersect(scene, &rays[i], &hit);
        digest(found, &hit, sizeof hit);
        digest(found, &hits_any, sizeof hits_any);
        memset(&counters, 0, sizeof counters);
        hug_intersect_counted(scene, &rays[i], &hit, &counters);
        digest(counted, &counters, sizeof counters);
        digest(counted, &hit, sizeof hit);
    }
    hug_intersect_n(scene, rays, sizeof *rays, hits, sizeof *hits, RAY_COUNT);
    hug_occluded_n(scene, rays, sizeof *rays, occluded, RAY_COUNT);
    digest(found, hits, sizeof hits);
    digest(found, occluded, sizeof occluded);
}

/* The sums of one instruction set for one scene after another. */
typedef struct {
    uint64_t hits, counts;
    int runs;
} sums;

static int report(const sums *all, uint64_t scenes)
{
    int i, same = 1;
    write_digest("scene ", scenes);
    runtime_write("\n");
    for (i = 0; i < 4; i++) {
        if (!all[i].runs)
            continue;
        runtime_write(isas[i]);
        write_digest(": hits ", all[i].hits);
        write_digest(", counts ", all[i].counts);
        runtime_write("\n");
        same &= all[i].hits == all[0].hits && all[i].counts == all[0].counts;
    }
    if (!same)
        runtime_write("digest: instruction sets differ\n");
    return same ? 0 : 1;
}

int runtime_main(void)
{
    sums all[4];
    uint64_t scenes = DIGEST_START;
    size_t count = 0, size = 0;
    const hug_geometry *geometries = input_geometries(&count);
    const hug_ray *rays = input_rays();
    int i, s;

    for (i = 0; i < 4; i++)
        all[i].hits = all[i].counts = DIGEST_START;
    for (s = 0; s < STRUCTURES; s++) {
        const hug_scene *scene = build(geometries, count, s);
        if (!scene)
            return 1;
        const void *data = hug_data(scene, &size);
        digest(&scenes, data, size);
        for (i = 0; i < 4; i++) {
            all[i].runs = hug_force_isa(isas[i]) == HUG_OK;
            if (all[i].runs)
                trace(scene, rays, &all[i].hits, &all[i].counts);
        }
    }
    return report(all, scenes);
}
