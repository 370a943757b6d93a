#include "compare/build_jobs.h"

#include <string.h>

#include "structures.h"

static int release_hug(void *self)
{
    hug_job *job = (hug_job *)self;
    hug_free(*job->built);
    *job->built = NULL;
    return 1;
}

static int build_hug(void *self, size_t n)
{
    hug_job *job = (hug_job *)self;
    (void)n;
    return structure_build(job->from, &job->options, job->built);
}

void hug_job_enter(hug_job *job, const scene *from, const hug_build_desc *options,
                   hug_structure structure, hug_scene **built, contender *out)
{
    job->from = from;
    job->options = *options;
    job->options.structure = structure;
    job->built = built;
    memset(out, 0, sizeof *out);
    out->prepare = release_hug;
    out->run = build_hug;
    out->self = job;
}

void hug_job_share(hug_job *job, pool *with)
{
    job->options.parallel_for = pool_run;
    job->options.parallel_user = with;
}

static int release_side(void *self)
{
    embree_release((embree_side *)self);
    return 1;
}

static int build_side(void *self, size_t n)
{
    (void)n;
    return embree_build((embree_side *)self);
}

void embree_side_enter(embree_side *side, contender *out)
{
    memset(out, 0, sizeof *out);
    out->prepare = release_side;
    out->run = build_side;
    out->self = side;
}

static int open_job(void *self)
{
    embree_job *job = (embree_job *)self;
    return embree_open(job->from, job->kind, job->threads, &job->side);
}

static int build_job(void *self, size_t n)
{
    (void)n;
    return embree_build(&((embree_job *)self)->side);
}

static int close_job(void *owner, unsigned round)
{
    (void)round;
    embree_close(&((embree_job *)owner)->side);
    return 1;
}

void embree_job_enter(embree_job *job, const scene *from, const embree_kind *kind,
                      unsigned threads, contender *out)
{
    job->from = from;
    job->kind = kind;
    job->threads = threads;
    memset(out, 0, sizeof *out);
    out->prepare = open_job;
    out->run = build_job;
    out->finish = close_job;
    out->self = out->owner = job;
}
