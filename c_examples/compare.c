/* The same triangles and the same rays through hug and Embree in one process. */
#include <stdio.h>
#include <string.h>

#include "camera.h"
#include "compare/run_builds.h"
#include "compare/run_set.h"
#include "compare/settings.h"
#include "message.h"

/* One of the structures that were built. Any one will do to count triangles by, and
 * to start rays from: the hits are the same, bit for bit, and run_set checks that.
 * The last is the one that clustered scenes slow down least. */
static int any_built(const comparison *c)
{
    int i = COMPARED_COUNT - 1;
    while (!c->built[i])
        i--;
    return i;
}

static int run_sets(comparison *c, const kit_view *view)
{
    ray_set sets[RAY_SET_COUNT];
    int set;
    const hug_scene *built = c->built[any_built(c)];
    int ok = ray_sets_make(built, &c->from->bounds, view, c->with->size, c->with->sets, sets);
    for (set = 0; set < RAY_SET_COUNT && ok; set++)
        if (c->with->sets & (1u << set))
            ok = run_set(c, set, &sets[set]);
    ray_sets_free(sets);
    return ok;
}

/* Prints what was decided; returns how much of it was decided against hug. */
static size_t report_tallies(const comparison *c)
{
    int csv = c->with->csv, set, structure;
    size_t found = 0, wrong = 0;
    for (set = 0; set < RAY_SET_COUNT; set++) {
        for (structure = 0; structure < COMPARED_COUNT; structure++) {
            found += tally_found(&c->tallies[structure][set]);
            wrong += tally_wrong(&c->tallies[structure][set]);
        }
    }
    report_decided(csv, found != 0);
    for (set = 0; set < RAY_SET_COUNT; set++)
        for (structure = 0; structure < COMPARED_COUNT; structure++)
            report_decisions(csv, &c->builds[structure], ray_set_names[set],
                             &c->tallies[structure][set]);
    return wrong;
}

static int choose_isa(const char *name)
{
    hug_status status = name ? hug_force_isa(name) : HUG_OK;
    if (status != HUG_OK)
        message("--isa %s: unknown, or not of this processor; without it: %s", name, hug_isa());
    return status == HUG_OK;
}

static int compare(const settings *with, const scene *from)
{
    comparison c;
    kit_view view;
    size_t wrong;
    int i, ok;
    if (!camera_choose(&with->camera, from, &view))
        return 0;
    memset(&c, 0, sizeof c);
    c.with = with;
    c.from = from;
    ok = run_builds(&c);
    if (ok) {
        report_begin(with->csv, from,
                     from->triangle_count - c.builds[any_built(&c)].triangles);
        for (i = 0; i < COMPARED_COUNT; i++)
            if (c.built[i])
                report_build(with->csv, &c.builds[i]);
        report_queries(with->csv);
        ok = run_sets(&c, &view);
        wrong = report_tallies(&c);
        if (wrong) {
            message("%lu answers of hug are wrong", (unsigned long)wrong);
            ok = 0;
        }
    }
    release_builds(&c);
    return ok;
}

int main(int argc, char **argv)
{
    settings with;
    scene from;
    int ok;

    message_program("compare");
    if (!settings_read(argc, argv, &with))
        return 2;
    if (with.help) {
        fputs(settings_help, stdout);
        return 0;
    }
    if (!choose_isa(with.isa))
        return 2;
    ok = scene_load(with.scene_name, &from) && compare(&with, &from);
    scene_free(&from);
    return ok ? 0 : 1;
}
