/* The bare door: memory that the caller hands in. */
#include <stdlib.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

typedef struct {
    fixture f;
    size_t arena_bytes, scratch_bytes;
    char *arena, *scratch;
} bare;

static hug_status build(const bare *b, void *scratch, size_t scratch_bytes, void *arena,
                        size_t arena_bytes)
{
    const hug_scene *scene = (const hug_scene *)(const void *)b;
    hug_status status =
        hug_build_into(&b->f.desc, scratch, scratch_bytes, arena, arena_bytes, &scene);
    REQUIRE((status == HUG_OK) == (scene != NULL));
    return status;
}

static void check_pointers(const bare *b)
{
    const hug_build_desc *desc = &b->f.desc;
    EXPECT(hug_build_into(desc, b->scratch, b->scratch_bytes, b->arena, b->arena_bytes, NULL),
           HUG_ERROR_NULL);
    EXPECT(build(b, NULL, b->scratch_bytes, b->arena, b->arena_bytes), HUG_ERROR_NULL);
    EXPECT(build(b, b->scratch, b->scratch_bytes, NULL, b->arena_bytes), HUG_ERROR_NULL);
    EXPECT(build(b, b->scratch + 8, b->scratch_bytes - 8, b->arena, b->arena_bytes),
           HUG_ERROR_ALIGNMENT);
    EXPECT(build(b, b->scratch, b->scratch_bytes, b->arena + 32, b->arena_bytes - 32),
           HUG_ERROR_ALIGNMENT);
    EXPECT(build(b, b->scratch, (size_t)-1, b->arena, b->arena_bytes), HUG_ERROR_OVERFLOW);
    EXPECT(build(b, b->scratch, b->scratch_bytes, b->arena, (size_t)-1), HUG_ERROR_OVERFLOW);
}

static void check_overlaps(const bare *b)
{
    fixture *inside;
    const hug_scene *scene;
    size_t room = b->arena_bytes + b->scratch_bytes + sizeof(fixture) + 64;
    char *memory = (char *)fixture_memory(room);
    EXPECT(build(b, memory, b->scratch_bytes, memory, b->arena_bytes), HUG_ERROR_OVERLAP);
    EXPECT(build(b, memory, b->arena_bytes + 64, memory + b->arena_bytes, b->arena_bytes),
           HUG_ERROR_OVERLAP);

    /* the vertices and indices lie in what is handed in to be overwritten */
    inside = (fixture *)(void *)memory;
    fixture_make(inside);
    EXPECT(hug_build_into(&inside->desc, memory, room, b->arena, b->arena_bytes, &scene),
           HUG_ERROR_OVERLAP);
    EXPECT(hug_build_into(&inside->desc, b->scratch, b->scratch_bytes, memory, room, &scene),
           HUG_ERROR_OVERLAP);
    free(memory);
}

static void check_too_small(const bare *b)
{
    size_t exact;
    hug_scene *easy = fixture_build(&b->f.desc);
    hug_data(easy, &exact);
    hug_free(easy);
    EXPECT(build(b, b->scratch, 0, b->arena, b->arena_bytes), HUG_ERROR_BUFFER_TOO_SMALL);
    EXPECT(build(b, b->scratch, 64, b->arena, b->arena_bytes), HUG_ERROR_BUFFER_TOO_SMALL);
    EXPECT(build(b, b->scratch, b->scratch_bytes, b->arena, 0), HUG_ERROR_BUFFER_TOO_SMALL);
    EXPECT(build(b, b->scratch, b->scratch_bytes, b->arena, exact - 1),
           HUG_ERROR_BUFFER_TOO_SMALL);
    EXPECT(build(b, b->scratch, b->scratch_bytes, b->arena, exact), HUG_OK);
}

/* Whatever was in the memory before, the bytes are those of the easy door. */
static void check_same_bytes(const bare *b)
{
    hug_scene *easy = fixture_build(&b->f.desc);
    size_t easy_size, size;
    const void *easy_data = hug_data(easy, &easy_size);
    const hug_scene *scene;
    int fill;
    for (fill = 0; fill < 256; fill += 85) {
        memset(b->arena, fill, b->arena_bytes);
        memset(b->scratch, fill, b->scratch_bytes);
        EXPECT(hug_build_into(&b->f.desc, b->scratch, b->scratch_bytes, b->arena,
                              b->arena_bytes, &scene),
               HUG_OK);
        REQUIRE((const void *)scene == (const void *)b->arena);
        REQUIRE(hug_data(scene, &size) == (const void *)b->arena);
        REQUIRE(size == easy_size && size <= b->arena_bytes);
        REQUIRE(size == easy_size && memcmp(b->arena, easy_data, size) == 0);
    }
    hug_free(easy);
}

void check_build_into(void)
{
    hug_structure structure;
    for (structure = HUG_STRUCTURE_AUTO; structure <= HUG_STRUCTURE_HUG; structure++) {
        bare b;
        fixture_make(&b.f);
        b.f.desc.structure = structure;
        EXPECT(hug_measure(&b.f.desc, &b.arena_bytes, &b.scratch_bytes), HUG_OK);
        REQUIRE(b.arena_bytes % 64 == 0 && b.scratch_bytes % 64 == 0);
        b.arena = (char *)fixture_memory(b.arena_bytes);
        b.scratch = (char *)fixture_memory(b.scratch_bytes);
        check_pointers(&b);
        check_overlaps(&b);
        check_too_small(&b);
        check_same_bytes(&b);
        free(b.arena);
        free(b.scratch);
    }
}
