/* The caller's allocator: every block comes back, with its size, also when the
 * allocator has no more to give. */
#include <stdlib.h>
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

#define MOST_BLOCKS 256

typedef struct {
    void *blocks[MOST_BLOCKS];
    size_t sizes[MOST_BLOCKS];
    size_t live, calls;
    size_t refuse_from; /* the call from which on there is no memory */
} ledger;

static void *ledger_alloc(size_t size, size_t align, void *user)
{
    ledger *l = (ledger *)user;
    void *block;
    REQUIRE(align != 0 && (align & (align - 1)) == 0 && align <= 64);
    if (l->calls++ >= l->refuse_from || l->live == MOST_BLOCKS)
        return NULL;
    block = fixture_memory(size);
    memset(block, 0xa5, size); /* nothing may count on zeros */
    l->blocks[l->live] = block;
    l->sizes[l->live++] = size;
    return block;
}

static void ledger_free(void *memory, size_t size, void *user)
{
    ledger *l = (ledger *)user;
    size_t i;
    for (i = 0; i < l->live; i++)
        if (l->blocks[i] == memory)
            break;
    if (!REQUIRE(i < l->live) || !REQUIRE(l->sizes[i] == size))
        return;
    free(memory);
    l->live--;
    l->blocks[i] = l->blocks[l->live];
    l->sizes[i] = l->sizes[l->live];
}

/* Builds with a ledger that refuses from the given call on. */
static hug_status build(hug_build_desc *desc, ledger *l, size_t refuse_from, hug_scene **out)
{
    memset(l, 0, sizeof *l);
    l->refuse_from = refuse_from;
    desc->alloc = ledger_alloc;
    desc->free = ledger_free;
    desc->user = l;
    return hug_build(desc, out);
}

static void check_structure(hug_structure structure)
{
    fixture f;
    ledger l;
    hug_scene *scene = NULL;
    hug_hit expected[FIXTURE_RAYS], hits[FIXTURE_RAYS];
    size_t needed, refuse_from;

    fixture_make(&f);
    f.desc.structure = structure;
    scene = fixture_build(&f.desc);
    fixture_hits(scene, expected);
    hug_free(scene);

    EXPECT(build(&f.desc, &l, (size_t)-1, &scene), HUG_OK);
    needed = l.calls;
    REQUIRE(needed > 0 && l.live == 1); /* the scene, and nothing of the build */
    fixture_hits(scene, hits);
    REQUIRE(memcmp(expected, hits, sizeof hits) == 0);
    hug_free(scene);
    REQUIRE(l.live == 0);

    for (refuse_from = 0; refuse_from < needed; refuse_from++) {
        EXPECT(build(&f.desc, &l, refuse_from, &scene), HUG_ERROR_OUT_OF_MEMORY);
        REQUIRE(scene == NULL && l.live == 0);
    }
    /* a build that is refused for its triangles keeps nothing either */
    f.indices[3 * FIXTURE_TRIANGLES - 1] = FIXTURE_VERTICES;
    EXPECT(build(&f.desc, &l, (size_t)-1, &scene), HUG_ERROR_INDEX_RANGE);
    REQUIRE(scene == NULL && l.live == 0);
}

void check_allocators(void)
{
    fixture f;
    hug_scene *scene;
    hug_structure structure;
    for (structure = HUG_STRUCTURE_AUTO; structure <= HUG_STRUCTURE_HUG; structure++)
        check_structure(structure);
    /* one without the other */
    fixture_make(&f);
    f.desc.alloc = ledger_alloc;
    EXPECT(hug_build(&f.desc, &scene), HUG_ERROR_NULL);
    fixture_make(&f);
    f.desc.free = ledger_free;
    EXPECT(hug_build(&f.desc, &scene), HUG_ERROR_NULL);
}
