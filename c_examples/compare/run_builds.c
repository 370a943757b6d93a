#include "compare/run_builds.h"

#include <stdlib.h>
#include <string.h>

#include "clocks.h"
#include "compare/rounds.h"
#include "message.h"
#include "structures.h"

/* One structure's build as a contender. */
typedef struct {
    const scene *from;
    hug_scene **built;
    hug_structure structure;
} build_job;

static void release_hug(void *self)
{
    build_job *job = (build_job *)self;
    hug_free(*job->built);
    *job->built = NULL;
}

static int build_hug(void *self, size_t n)
{
    build_job *job = (build_job *)self;
    (void)n;
    return structure_build(job->from, job->structure, job->built);
}

static void release_embree(void *self)
{
    embree_release((embree_side *)self);
}

static int build_embree(void *self, size_t n)
{
    (void)n;
    return embree_build((embree_side *)self);
}

static int fill_figures(const comparison *c, int structure, double *hug, double *embree,
                        build_figures *out)
{
    hug_scene_stats stats;
    unsigned rounds = c->with->build_rounds;
    if (!structure_stats(c->built[structure], &stats))
        return 0;
    out->structure = structure_names[structure];
    out->triangles = (size_t)stats.triangles;
    out->hug_seconds = median(hug, rounds);
    out->embree_seconds = median(embree, rounds);
    out->hug_bytes = stats.bytes;
    out->embree_bytes = (unsigned long long)c->embree.bytes;
    return 1;
}

int run_builds(comparison *c)
{
    contender contenders[COMPARED_COUNT + 1];
    build_job jobs[COMPARED_COUNT];
    int structures[COMPARED_COUNT];
    unsigned rounds = c->with->build_rounds;
    double *seconds = (double *)calloc((COMPARED_COUNT + 1) * rounds, sizeof *seconds);
    double *embree_seconds;
    long long before;
    size_t count = 0, i;
    int structure, ok;

    if (!seconds) {
        message("no memory for %u rounds", rounds);
        return 0;
    }
    if (!embree_open(c->from, &c->embree)) {
        free(seconds);
        return 0;
    }
    before = c->embree.bytes;
    for (structure = 0; structure < COMPARED_COUNT; structure++) {
        if (!(c->with->structures & (1u << structure)))
            continue;
        jobs[count].from = c->from;
        jobs[count].built = &c->built[structure];
        jobs[count].structure = (hug_structure)structure;
        contenders[count].prepare = release_hug;
        contenders[count].run = build_hug;
        contenders[count].self = &jobs[count];
        structures[count++] = structure;
    }
    contenders[count].prepare = release_embree;
    contenders[count].run = build_embree;
    contenders[count].self = &c->embree;
    for (i = 0; i <= count; i++)
        contenders[i].seconds = seconds + i * rounds;
    embree_seconds = contenders[count].seconds;
    ok = rounds_run("building", contenders, count + 1, 0, 0, rounds, seconds_process);
    c->embree.bytes -= before;
    for (i = 0; i < count && ok; i++)
        ok = fill_figures(c, structures[i], contenders[i].seconds, embree_seconds,
                          &c->builds[structures[i]]);
    free(seconds);
    return ok;
}

void release_builds(comparison *c)
{
    int i;
    for (i = 0; i < COMPARED_COUNT; i++) {
        hug_free(c->built[i]);
        c->built[i] = NULL;
    }
    embree_close(&c->embree);
}
