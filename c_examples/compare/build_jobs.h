/* Builds as contenders: each lets go of what it built before, and builds anew. */
#ifndef BUILD_JOBS_H
#define BUILD_JOBS_H

#include "compare/embree_side.h"
#include "compare/rounds.h"
#include "lessons/pool.h"
#include "hug.h"

typedef struct {
    const scene *from;
    hug_build_desc options;
    hug_scene **built;
} hug_job;

/* options: all but the structure. */
void hug_job_enter(hug_job *job, const scene *from, const hug_build_desc *options,
                   hug_structure structure, hug_scene **built, contender *out);

/* The same on the threads of a pool. */
void hug_job_share(hug_job *job, pool *with);

/* In a device that is open and stays so. */
void embree_side_enter(embree_side *side, contender *out);

/* In a device of several threads, which is there only for the build: as long as it is,
 * Embree may lend its threads to other devices too. */
typedef struct {
    const scene *from;
    const embree_kind *kind;
    unsigned threads;
    embree_side side;
} embree_job;

void embree_job_enter(embree_job *job, const scene *from, const embree_kind *kind,
                      unsigned threads, contender *out);

#endif
