#include "abi/refuse.h"

#include <stdlib.h>

#include "abi/fixture.h"

#define ROOM (1u << 20)

/* An address that no failed build may leave in *out. */
static char elsewhere;

void refuse(const char *file, int line, const hug_build_desc *desc, hug_status expected,
            int measure)
{
    void *scratch = fixture_memory(ROOM), *arena = fixture_memory(ROOM);
    hug_scene *built = (hug_scene *)(void *)&elsewhere;
    const hug_scene *in_place = (const hug_scene *)(const void *)&elsewhere;
    size_t arena_bytes = 0, scratch_bytes = 0;

    check_status(file, line, "hug_build", hug_build(desc, &built), expected);
    check_true(file, line, "hug_build sets *out to NULL", built == NULL);
    check_status(file, line, "hug_build_into",
                 hug_build_into(desc, scratch, ROOM, arena, ROOM, &in_place), expected);
    check_true(file, line, "hug_build_into sets *out to NULL", in_place == NULL);
    if (measure)
        check_status(file, line, "hug_measure",
                     hug_measure(desc, &arena_bytes, &scratch_bytes), expected);
    free(scratch);
    free(arena);
}
