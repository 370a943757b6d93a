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
    size_t refuse_to;   /* and the one from which on there is again */
} ledger;

static void *ledger_alloc(size_t size, size_t align, void *user)
{
    ledger *l = (ledger *)user;
    size_t call = l->calls++;
    void *block;
    REQUIRE(align != 0 && (align & (align - 1)) == 0 && align <= 64);
    if ((call >= l->refuse_from && call < l->refuse_to) || l->live == MOST_BLOCKS)
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

#define NEVER ((size_t)-1)

/* Builds with a ledger that refuses the calls of these numbers. */
static hug_status build(hug_build_desc *desc, ledger *l, size_t refuse_from, size_t refuse_to,
                        hug_scene **out)
{
    memset(l, 0, sizeof *l);
    l->refuse_from = refuse_from;
    l->refuse_to = refuse_to;
    desc->alloc = ledger_alloc;
    desc->free = ledger_free;
    desc->user = l;
    return hug_build(desc, out);
}

/* The n-th call alone, and all from it on, of a build and of a rebuild. */
static void check_refusals(fixture *f, size_t blocks)
{
    ledger l;
    hug_scene *scene;
    size_t needed, n;

    EXPECT(build(&f->desc, &l, NEVER, NEVER, &scene), HUG_OK);
    needed = l.calls;
    REQUIRE(needed > 0 && l.live == blocks);
    for (n = 0; n < needed; n++) {
        hug_scene *none;
        ledger other;
        EXPECT(build(&f->desc, &other, n, NEVER, &none), HUG_ERROR_OUT_OF_MEMORY);
        REQUIRE(none == NULL && other.live == 0);
        EXPECT(build(&f->desc, &other, n, n + 1, &none), HUG_ERROR_OUT_OF_MEMORY);
        REQUIRE(none == NULL && other.live == 0);
    }
    EXPECT(hug_rebuild(scene, &f->desc), HUG_OK);
    needed = l.calls - needed;
    for (n = 0; n < needed; n++) {
        l.refuse_from = l.calls + n;
        l.refuse_to = l.refuse_from + 1;
        EXPECT(hug_rebuild(scene, &f->desc), HUG_ERROR_OUT_OF_MEMORY);
        REQUIRE(l.live == blocks);
    }
    hug_free(scene);
    REQUIRE(l.live == 0);
}

static void check_structure(hug_structure structure)
{
    fixture f;
    ledger l;
    hug_scene *scene = NULL;
    hug_hit expected[FIXTURE_RAYS], hits[FIXTURE_RAYS];

    fixture_make(&f);
    f.desc.structure = structure;
    scene = fixture_build(&f.desc);
    fixture_hits(scene, expected);
    hug_free(scene);

    EXPECT(build(&f.desc, &l, NEVER, NEVER, &scene), HUG_OK);
    fixture_hits(scene, hits);
    REQUIRE(memcmp(expected, hits, sizeof hits) == 0);
    hug_free(scene);
    REQUIRE(l.live == 0);

    /* the scene, and nothing of the build; or its scratch memory too */
    check_refusals(&f, 1);
    f.desc.flags = HUG_BUILD_KEEP_SCRATCH;
    check_refusals(&f, 2);
    f.desc.flags = 0;
    /* a build that is refused for its triangles keeps nothing either */
    f.indices[3 * FIXTURE_TRIANGLES - 1] = FIXTURE_VERTICES;
    EXPECT(build(&f.desc, &l, NEVER, NEVER, &scene), HUG_ERROR_INDEX_RANGE);
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
