/* Rebuilding in place. */
#include <stdlib.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

typedef struct {
    unsigned allocations, live;
} counter;

static void *count_alloc(size_t size, size_t align, void *user)
{
    counter *c = (counter *)user;
    (void)align;
    c->allocations++;
    c->live++;
    return fixture_memory(size);
}

static void count_free(void *memory, size_t size, void *user)
{
    (void)size;
    ((counter *)user)->live--;
    free(memory);
}

static int32_t countdown(void *user, double fraction)
{
    unsigned *left = (unsigned *)user;
    (void)fraction;
    return (*left)-- == 0;
}

static int same(const hug_scene *a, const hug_scene *b)
{
    size_t a_len, b_len;
    const void *a_data = hug_data(a, &a_len), *b_data = hug_data(b, &b_len);
    return a_len == b_len && memcmp(a_data, b_data, a_len) == 0;
}

static void move(fixture *f)
{
    size_t i;
    for (i = 0; i < FIXTURE_VERTICES; i++)
        f->vertices[3 * i + 2] *= 0.5f;
}

static uint64_t triangles(const hug_scene *scene)
{
    hug_scene_stats stats;
    memset(&stats, 0, sizeof stats);
    stats.struct_size = sizeof stats;
    EXPECT(hug_stats(scene, &stats), HUG_OK);
    return stats.triangles;
}

/* With and without kept scratch memory. */
static void check_memory(uint32_t flags)
{
    fixture f;
    counter c = {0, 0};
    hug_scene *scene, *expected;
    unsigned before;
    fixture_make(&f);
    f.desc.structure = HUG_STRUCTURE_UNIFORM;
    f.desc.counts[0] = f.desc.counts[1] = f.desc.counts[2] = 4;
    f.desc.max_refs = 256;
    expected = fixture_build(&f.desc);
    f.desc.flags = flags;
    f.desc.alloc = count_alloc;
    f.desc.free = count_free;
    f.desc.user = &c;
    scene = fixture_build(&f.desc);
    REQUIRE(same(scene, expected));
    before = c.allocations;
    EXPECT(hug_rebuild(scene, &f.desc), HUG_OK);
    REQUIRE(same(scene, expected));
    REQUIRE(c.allocations == before + (flags ? 0 : 1) && c.live == (flags ? 2 : 1));
    hug_free(expected);
    /* fewer triangles, elsewhere */
    move(&f);
    f.geometry.triangle_count /= 2;
    EXPECT(hug_rebuild(scene, &f.desc), HUG_OK);
    f.desc.alloc = NULL;
    f.desc.free = NULL;
    f.desc.flags = 0;
    expected = fixture_build(&f.desc);
    REQUIRE(same(scene, expected));
    REQUIRE(triangles(scene) == FIXTURE_TRIANGLES / 2);
    /* more than fits: as it was */
    f.geometry.triangle_count *= 2;
    f.desc.counts[0] = f.desc.counts[1] = f.desc.counts[2] = 16;
    f.desc.max_refs = 4096;
    EXPECT(hug_rebuild(scene, &f.desc), HUG_ERROR_BUFFER_TOO_SMALL);
    REQUIRE(same(scene, expected));
    hug_free(expected);
    hug_free(scene);
    REQUIRE(c.live == 0);
}

static void check_cancelled(void)
{
    fixture f, moved;
    hug_scene *expected, *scene;
    unsigned call, left, kept = 0, empty = 0;
    hug_status status = HUG_ERROR_CANCELLED;
    fixture_make(&f);
    fixture_make(&moved);
    move(&moved);
    expected = fixture_build(&f.desc);
    /* with room for triangles that are in more voxels than before */
    f.desc.flags |= HUG_BUILD_KEEP_SCRATCH;
    moved.desc.progress = countdown;
    moved.desc.progress_user = &left;
    for (call = 0; status == HUG_ERROR_CANCELLED && call < 10000; call++) {
        scene = fixture_build(&f.desc);
        left = call;
        status = hug_rebuild(scene, &moved.desc);
        if (status == HUG_ERROR_CANCELLED) {
            REQUIRE(same(scene, expected) || triangles(scene) == 0);
            kept += same(scene, expected);
            empty += triangles(scene) == 0;
        }
        hug_free(scene);
    }
    EXPECT(status, HUG_OK);
    REQUIRE(kept > 0 && empty > 0);
    hug_free(expected);
}

void check_rebuild(void)
{
    fixture f;
    hug_scene *scene, *expected;
    check_memory(0);
    check_memory(HUG_BUILD_KEEP_SCRATCH);
    check_cancelled();
    fixture_make(&f);
    expected = fixture_build(&f.desc);
    scene = fixture_build(&f.desc);
    EXPECT(hug_rebuild(NULL, &f.desc), HUG_ERROR_NULL);
    EXPECT(hug_rebuild(scene, NULL), HUG_ERROR_NULL);
    f.desc.quality = 3;
    EXPECT(hug_rebuild(scene, &f.desc), HUG_ERROR_INVALID_VALUE);
    f.desc.quality = 0;
    f.indices[0] = FIXTURE_VERTICES;
    EXPECT(hug_rebuild(scene, &f.desc), HUG_ERROR_INDEX_RANGE);
    f.geometry.vertices = (const float *)hug_data(scene, NULL);
    EXPECT(hug_rebuild(scene, &f.desc), HUG_ERROR_OVERLAP);
    REQUIRE(same(scene, expected));
    hug_free(scene);
    hug_free(expected);
}
