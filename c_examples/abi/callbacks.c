/* parallel_for and progress: whatever they do, a build gives the same bytes or says why
 * it gives none. */
#include <string.h>

#include "abi/check.h"
#include "abi/fixture.h"

typedef struct {
    unsigned calls, cancel_at;
    double last;
} watcher;

static int32_t watch(void *user, double fraction)
{
    watcher *w = (watcher *)user;
    REQUIRE(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    return w->calls++ == w->cancel_at;
}

typedef struct {
    unsigned calls;
    int leave_out; /* the first task of every call */
} team;

/* Backwards, every task twice, and some that there are not. */
static void run_tasks(void *user, size_t tasks, hug_task_fn task, void *context)
{
    team *t = (team *)user;
    size_t i;
    t->calls++;
    REQUIRE(tasks > 1);
    for (i = tasks + 2; i > (t->leave_out ? 1u : 0u); i--) {
        task(context, i - 1);
        task(context, i - 1);
    }
    task(context, (size_t)-1);
}

/* Many geometries make many tasks of few triangles. */
#define PARTS 16

static void split(const fixture *f, hug_geometry parts[PARTS], hug_build_desc *desc)
{
    size_t i, each = FIXTURE_TRIANGLES / PARTS;
    for (i = 0; i < PARTS; i++) {
        parts[i] = f->geometry;
        parts[i].indices = f->indices + 3 * each * i;
        parts[i].triangle_count = each;
    }
    *desc = f->desc;
    desc->geometries = parts;
    desc->geometry_count = PARTS;
}

static void check_same(const hug_scene *a, const hug_scene *b)
{
    size_t a_len, b_len;
    const void *a_data = hug_data(a, &a_len), *b_data = hug_data(b, &b_len);
    REQUIRE(a_len == b_len && memcmp(a_data, b_data, a_len) == 0);
}

static void check_threads(void)
{
    fixture f;
    hug_geometry parts[PARTS];
    hug_build_desc desc;
    hug_scene *expected, *scene;
    team t = {0, 0};
    fixture_make(&f);
    split(&f, parts, &desc);
    expected = fixture_build(&desc);
    desc.parallel_for = run_tasks;
    desc.parallel_user = &t;
    scene = fixture_build(&desc);
    REQUIRE(t.calls > 0);
    check_same(scene, expected);
    hug_free(scene);
    t.leave_out = 1;
    EXPECT(hug_build(&desc, &scene), HUG_ERROR_UNFINISHED);
    REQUIRE(scene == NULL);
    hug_free(expected);
}

static void check_progress(void)
{
    fixture f;
    hug_scene *expected, *scene;
    watcher w = {0, (unsigned)-1, 0};
    unsigned calls, i;
    fixture_make(&f);
    expected = fixture_build(&f.desc);
    f.desc.progress = watch;
    f.desc.progress_user = &w;
    scene = fixture_build(&f.desc);
    check_same(scene, expected);
    hug_free(scene);
    calls = w.calls;
    REQUIRE(calls > 4 && w.last == 1);
    for (i = 0; i < calls; i++) {
        memset(&w, 0, sizeof w);
        w.cancel_at = i;
        EXPECT(hug_build(&f.desc, &scene), HUG_ERROR_CANCELLED);
        REQUIRE(scene == NULL && w.calls == i + 1);
    }
    hug_free(expected);
}

void check_callbacks(void)
{
    check_threads();
    check_progress();
}
