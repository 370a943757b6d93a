#include "compare/run_builds.h"

#include <stdlib.h>
#include <string.h>

#include "clocks.h"
#include "compare/build_jobs.h"
#include "compare/report.h"
#include "message.h"
#include "structures.h"

/* The structures and Embree's ways; the structures and Embree on several threads. */
#define JOBS (2 * COMPARED_COUNT + EMBREE_BUILDS + 1)

typedef struct {
    comparison *c;
    hug_job hug[COMPARED_COUNT];
    hug_job shared[COMPARED_COUNT]; /* on the lent threads */
    hug_scene *shared_built[COMPARED_COUNT];
    pool lent; /* of no thread unless some are lent */
    embree_job threads;
    contender contenders[JOBS];
    build_row *rows[JOBS]; /* what is to be filled for each */
    size_t count, reference;
    double *seconds;
} builder;

static build_row *enter(builder *b, build_row *row, const char *name, int peer)
{
    const scene *from = b->c->from;
    memset(row, 0, sizeof *row);
    memcpy(row->scene, from->name, sizeof row->scene);
    row->name = name;
    row->peer = peer;
    row->threads = 1;
    b->rows[b->count++] = row;
    return row;
}

/* The structures on several threads. */
static void enter_shared(builder *b)
{
    comparison *c = b->c;
    int i;
    pool_start(&b->lent, c->with->threads);
    for (i = 0; i < COMPARED_COUNT; i++) {
        if (!(c->with->structures & (1u << i)))
            continue;
        hug_job_enter(&b->shared[i], c->from, &c->with->build, (hug_structure)i,
                      &b->shared_built[i], &b->contenders[b->count]);
        hug_job_share(&b->shared[i], &b->lent);
        enter(b, &c->threaded_builds[i], structure_names[i], 0)->threads = c->with->threads;
    }
}

static int enter_all(builder *b)
{
    comparison *c = b->c;
    int i;
    for (i = 0; i < COMPARED_COUNT; i++) {
        if (!(c->with->structures & (1u << i)))
            continue;
        hug_job_enter(&b->hug[i], c->from, &c->with->build, (hug_structure)i, &c->built[i],
                      &b->contenders[b->count]);
        enter(b, &c->builds[i], structure_names[i], 0);
    }
    b->reference = b->count;
    for (i = 0; i < EMBREE_BUILDS; i++) {
        if (!peers_need(c->with->peers, i))
            continue;
        if (!embree_open(c->from, &embree_kinds[i], 1, &c->embree[i]))
            return 0;
        embree_side_enter(&c->embree[i], &b->contenders[b->count]);
        enter(b, &c->peer_builds[i], embree_kinds[i].name, 1);
    }
    if (c->with->threads > 1) {
        enter_shared(b);
        embree_job_enter(&b->threads, c->from, &embree_kinds[EMBREE_MEDIUM], c->with->threads,
                         &b->contenders[b->count]);
        enter(b, &c->threaded, embree_kinds[EMBREE_MEDIUM].name, 1)->threads = c->with->threads;
    }
    return 1;
}

static int measure(builder *b)
{
    unsigned rounds = b->c->with->build_rounds;
    size_t i;
    b->seconds = (double *)calloc(2 * b->count * rounds, sizeof *b->seconds);
    if (!b->seconds) {
        message("no memory for %u rounds", rounds);
        return 0;
    }
    for (i = 0; i < b->count; i++) {
        b->contenders[i].seconds = b->seconds + 2 * i * rounds;
        b->contenders[i].wall = b->contenders[i].seconds + rounds;
    }
    return rounds_run("building", b->contenders, b->count, 0, 0, rounds, seconds_process);
}

/* Sizes are known of each, and hug's sections. */
static int fill_sizes(builder *b)
{
    comparison *c = b->c;
    size_t kept = 0;
    int i;
    for (i = 0; i < COMPARED_COUNT; i++) {
        hug_scene_stats stats;
        build_row *shared = &c->threaded_builds[i];
        if (!c->built[i])
            continue;
        if (!structure_stats(c->built[i], &stats))
            return 0;
        kept = (size_t)stats.triangles;
        c->builds[i].bytes = stats.bytes;
        c->builds[i].grids = stats.grid_bytes;
        c->builds[i].voxels = stats.voxel_bytes;
        c->builds[i].refs = stats.ref_bytes;
        c->builds[i].triangle_bytes = stats.triangle_bytes;
        shared->bytes = c->builds[i].bytes;
        shared->grids = c->builds[i].grids;
        shared->voxels = c->builds[i].voxels;
        shared->refs = c->builds[i].refs;
        shared->triangle_bytes = c->builds[i].triangle_bytes;
    }
    for (i = 0; i < EMBREE_BUILDS; i++)
        c->peer_builds[i].bytes = c->embree[i].scene_bytes;
    c->threaded.bytes = b->threads.side.scene_bytes;
    for (i = 0; i < (int)b->count; i++)
        b->rows[i]->triangles = kept;
    return 1;
}

static int keep(builder *b)
{
    comparison *c = b->c;
    unsigned rounds = c->with->build_rounds;
    const build_row *reference = b->rows[b->reference];
    size_t i;
    for (i = 0; i < b->count; i++) {
        b->rows[i]->cpu = median(b->contenders[i].seconds, rounds);
        b->rows[i]->wall = median(b->contenders[i].wall, rounds);
    }
    for (i = 0; i < b->count; i++) {
        b->rows[i]->reference_cpu = reference->cpu;
        b->rows[i]->reference_wall = reference->wall;
        b->rows[i]->reference_bytes = reference->bytes;
        if (!results_add_build(c->found, b->rows[i]))
            return 0;
    }
    report_scene(c);
    for (i = 0; i < b->count; i++)
        report_build(c->with->format, b->rows[i]);
    return 1;
}

int run_builds(comparison *c)
{
    builder b;
    int i, ok;
    memset(&b, 0, sizeof b);
    b.c = c;
    ok = enter_all(&b) && measure(&b) && fill_sizes(&b) && keep(&b);
    embree_close(&b.threads.side);
    if (b.lent.started > 0)
        pool_stop(&b.lent);
    for (i = 0; i < COMPARED_COUNT; i++)
        hug_free(b.shared_built[i]);
    free(b.seconds);
    return ok;
}

void release_builds(comparison *c)
{
    int i;
    for (i = 0; i < COMPARED_COUNT; i++) {
        hug_free(c->built[i]);
        c->built[i] = NULL;
    }
    for (i = 0; i < EMBREE_BUILDS; i++)
        embree_close(&c->embree[i]);
}
