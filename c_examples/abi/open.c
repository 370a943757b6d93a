/* hug_open on bytes of every kind, good and bad. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

typedef struct {
    const char *data; /* a good arena */
    size_t size;
    hug_hit hits[FIXTURE_RAYS];
    char *copy; /* of exactly its size, to damage */
} good;

static void check_arguments(const good *g)
{
    const hug_scene *scene;
    memcpy(g->copy, g->data, g->size);
    EXPECT(hug_open(NULL, g->size, 0, &scene), HUG_ERROR_NULL);
    REQUIRE(scene == NULL);
    EXPECT(hug_open(g->copy, g->size, 0, NULL), HUG_ERROR_NULL);
    EXPECT(hug_open(g->copy, g->size, 2, &scene), HUG_ERROR_INVALID_VALUE);
    EXPECT(hug_open(g->copy, g->size, 0x80000001u, &scene), HUG_ERROR_INVALID_VALUE);
    EXPECT(hug_open(g->copy + 32, g->size - 32, 0, &scene), HUG_ERROR_ALIGNMENT);
    EXPECT(hug_open(g->copy + 1, g->size - 1, HUG_OPEN_TRUSTED, &scene), HUG_ERROR_ALIGNMENT);
    EXPECT(hug_open(g->copy, (size_t)-1, 0, &scene), HUG_ERROR_OVERFLOW);
    REQUIRE(scene == NULL);
}

static void check_same_hits(const good *g, const hug_scene *scene)
{
    hug_hit hits[FIXTURE_RAYS];
    fixture_hits(scene, hits);
    REQUIRE(memcmp(hits, g->hits, sizeof hits) == 0);
}

/* To a file and back, and with room behind the arena. */
static void check_saved(const good *g)
{
    FILE *file = tmpfile();
    size_t room = g->size + 4096, size;
    char *memory = (char *)fixture_memory(room);
    const hug_scene *scene = NULL;
    memset(memory, 0xa5, room);
    if (REQUIRE(file != NULL)) {
        REQUIRE(fwrite(g->data, 1, g->size, file) == g->size);
        rewind(file);
        REQUIRE(fread(memory, 1, g->size, file) == g->size);
        fclose(file);
        EXPECT(hug_open(memory, g->size, 0, &scene), HUG_OK);
        REQUIRE((const void *)scene == (const void *)memory);
        check_same_hits(g, scene);
        EXPECT(hug_open(memory, room, 0, &scene), HUG_OK);
        REQUIRE(hug_data(scene, &size) == (const void *)memory && size == g->size);
        check_same_hits(g, scene);
        EXPECT(hug_open(memory, g->size, HUG_OPEN_TRUSTED, &scene), HUG_OK);
        check_same_hits(g, scene);
    }
    free(memory);
}

static void check_truncated(const good *g)
{
    size_t length;
    for (length = 0; length < g->size; length += length < 256 ? 1 : 61) {
        /* memory of just this length, so that a tool that watches sees a read behind it */
        char *part = (char *)fixture_memory(length);
        const hug_scene *scene;
        memcpy(part, g->data, length);
        EXPECT(hug_open(part, length, 0, &scene), HUG_ERROR_TRUNCATED);
        EXPECT(hug_open(part, length, HUG_OPEN_TRUSTED, &scene), HUG_ERROR_TRUNCATED);
        REQUIRE(scene == NULL);
        free(part);
    }
}

static void check_garbage(const good *g)
{
    const hug_scene *scene;
    uint32_t state = 1;
    size_t i;
    memset(g->copy, 0, g->size);
    EXPECT(hug_open(g->copy, g->size, 0, &scene), HUG_ERROR_MAGIC);
    memset(g->copy, 0xff, g->size);
    EXPECT(hug_open(g->copy, g->size, 0, &scene), HUG_ERROR_MAGIC);
    for (i = 0; i < g->size; i++) {
        state = state * 1664525u + 1013904223u;
        g->copy[i] = (char)(state >> 24);
    }
    EXPECT(hug_open(g->copy, g->size, 0, &scene), HUG_ERROR_MAGIC);
    REQUIRE(scene == NULL);
}

/* Other rays each time: all of them for every byte would take minutes. */
static void trace_some(const hug_scene *scene, unsigned seed)
{
    unsigned i;
    for (i = 0; i < 12; i++) {
        hug_ray ray = fixture_ray((37 * seed + 41 * i) % FIXTURE_RAYS);
        hug_hit hit;
        hug_intersect(scene, &ray, &hit);
    }
}

/* A damaged byte is found, or does no harm: an arena that opens can be traced. */
static void check_flipped(const good *g)
{
    static const unsigned char flips[] = {0x01, 0x80, 0xff};
    size_t i, flip;
    memcpy(g->copy, g->data, g->size);
    for (i = 0; i < g->size; i++) {
        for (flip = 0; flip < sizeof flips; flip++) {
            const hug_scene *scene;
            hug_status status;
            g->copy[i] = (char)(g->data[i] ^ flips[flip]);
            status = hug_open(g->copy, g->size, 0, &scene);
            REQUIRE((status == HUG_OK) == (scene != NULL));
            REQUIRE(status == HUG_OK ||
                    (status >= HUG_ERROR_TRUNCATED && status <= HUG_ERROR_CORRUPT) ||
                    (status >= HUG_ERROR_SECTIONS && status <= HUG_ERROR_REFERENCE));
            if (status == HUG_OK)
                trace_some(scene, (unsigned)i);
        }
        g->copy[i] = g->data[i];
    }
}

void check_open(void)
{
    hug_structure structure;
    for (structure = HUG_STRUCTURE_UNIFORM; structure <= HUG_STRUCTURE_HUG; structure++) {
        fixture f;
        hug_scene *scene;
        good g;
        fixture_make(&f);
        f.desc.structure = structure;
        f.desc.maxp = 4; /* small enough for grids within the grid */
        scene = fixture_build(&f.desc);
        g.data = (const char *)hug_data(scene, &g.size);
        g.copy = (char *)fixture_memory(g.size);
        fixture_hits(scene, g.hits);
        check_arguments(&g);
        check_saved(&g);
        check_truncated(&g);
        check_garbage(&g);
        check_flipped(&g);
        free(g.copy);
        hug_free(scene);
    }
}
