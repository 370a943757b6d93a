/* What it teaches: hug beside Embree. The same triangles and the same rays go through
 * both in one process; exact arithmetic decides where they differ. */
#include <stdio.h>
#include <string.h>

#include "clocks.h"
#include "compare/report.h"
#include "compare/run_scene.h"
#include "compare/scene_list.h"
#include "compare/settings.h"
#include "message.h"

static const char *duration(double seconds, char *out, size_t size)
{
    if (seconds < 90.0)
        snprintf(out, size, "%.0f s", seconds);
    else
        snprintf(out, size, "%.0f min", seconds / 60.0);
    return out;
}

/* Which views of a listed scene are to be run. */
static size_t views_of(const settings *with, const listed_scene *s)
{
    return with->every_view || s->view_count == 0 ? s->view_count : 1;
}

/* The time left is that of the views so far, for each one left. */
static void say_progress(const settings *with, const scene_list *list, size_t at, double start)
{
    double spent = seconds_wall() - start, done = 0.0, left = 0.0;
    char so_far[32], remaining[32];
    size_t i;
    for (i = 0; i < list->count; i++) {
        size_t views = views_of(with, &list->scenes[i]);
        double runs = views ? (double)views : 1.0;
        if (i < at)
            done += runs;
        else
            left += runs;
    }
    duration(spent, so_far, sizeof so_far);
    if (at == 0)
        message("scene 1 of %lu: %s", (unsigned long)list->count, list->scenes[0].label);
    else
        message("scene %lu of %lu: %s; %s so far, about %s left", (unsigned long)at + 1,
                (unsigned long)list->count, list->scenes[at].label, so_far,
                duration(spent * left / done, remaining, sizeof remaining));
}

/* Goes on after a scene that failed. */
static int run_all(const settings *with, results *found)
{
    scene_list list;
    double start = seconds_wall();
    size_t i;
    int ok = scene_list_make(&list);
    for (i = 0; ok != 0 && i < list.count; i++) {
        const listed_scene *s = &list.scenes[i];
        say_progress(with, &list, i, start);
        if (!run_scene(with, s->what, s->views, views_of(with, s), found)) {
            message("%s: failed", s->label);
            ok = -1;
        }
    }
    scene_list_free(&list);
    return ok == 1;
}

int main(int argc, char **argv)
{
    settings with;
    results found;
    int ok;

    message_program("compare");
    if (!settings_read(argc, argv, &with))
        return 2;
    if (with.help) {
        fputs(settings_help, stdout);
        return 0;
    }
    memset(&found, 0, sizeof found);
    report_begin(&with);
    ok = with.all ? run_all(&with, &found) : run_scene(&with, with.scene_name, NULL, 0, &found);
    report_summary(&with, &found);
    results_free(&found);
    return ok ? 0 : 1;
}
