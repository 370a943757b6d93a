#include "compare/run_scene.h"

#include <string.h>

#include "compare/report.h"
#include "compare/run_builds.h"
#include "compare/run_set.h"
#include "message.h"

/* One of the structures that were built. Any one will do to start rays from: the hits
 * are the same, bit for bit, and run_set checks that. The last is the one that
 * clustered scenes slow down least. */
static const hug_scene *any_built(const comparison *c)
{
    int i = COMPARED_COUNT - 1;
    while (!c->built[i])
        i--;
    return c->built[i];
}

/* The sets that are wanted and that some query asks. */
static unsigned sets_asked(const settings *with)
{
    unsigned asked = 0;
    int set;
    for (set = 0; set < RAY_SET_COUNT; set++)
        if (settings_asks(with, set, 0) || settings_asks(with, set, 1))
            asked |= 1u << set;
    return asked;
}

static int run_sets(comparison *c, const kit_view *view, unsigned wanted)
{
    ray_set sets[RAY_SET_COUNT];
    int set;
    int ok = ray_sets_make(any_built(c), &c->from->bounds, view, c->with->size, wanted, sets);
    for (set = 0; set < RAY_SET_COUNT && ok; set++)
        if (wanted & (1u << set))
            ok = run_set(c, set, &sets[set]);
    ray_sets_free(sets);
    return ok;
}

static int run_view(comparison *c, const camera_options *camera, unsigned wanted)
{
    kit_view view;
    size_t wrong;
    int ok;
    if (!camera_choose(camera, c->from, &view))
        return 0;
    c->view_name = camera_name(camera, c->from);
    memset(c->tallies, 0, sizeof c->tallies);
    report_view(c);
    ok = run_sets(c, &view, wanted);
    wrong = report_decisions(c);
    if (wrong)
        message("%s: %lu answers of hug are wrong", c->from->name, (unsigned long)wrong);
    return ok && !wrong;
}

/* Random rays know no view: they are the same in all, and run in the first. */
static int run_views(comparison *c, char *const *views, size_t count)
{
    unsigned wanted = sets_asked(c->with);
    size_t i;
    int ok = 1;
    if (count == 0)
        return run_view(c, &c->with->camera, wanted);
    for (i = 0; i < count; i++) {
        camera_options camera;
        memset(&camera, 0, sizeof camera);
        camera.view = views[i];
        if (wanted)
            ok &= run_view(c, &camera, wanted);
        wanted &= ~(1u << RAYS_RANDOM);
    }
    return ok;
}

int run_scene(const settings *with, const char *what, char *const *views, size_t count,
              results *found)
{
    comparison c;
    scene from;
    int ok;
    memset(&c, 0, sizeof c);
    c.with = with;
    c.from = &from;
    c.found = found;
    ok = scene_load(what, &from) && run_builds(&c) && run_views(&c, views, count);
    release_builds(&c);
    scene_free(&from);
    return ok;
}
