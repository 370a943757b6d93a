/* The threads that --threads lends to hug's builds. */
#ifndef TEAM_H
#define TEAM_H

#include "hug.h"

#define MOST_TEAM 64

typedef struct {
    unsigned threads; /* the calling one included */
} team;

/* A hug_parallel_for_fn; user: a team. Threads live for one call, which is short
 * beside what a task takes; those that the system refuses are done without. */
void team_run(void *user, size_t tasks, hug_task_fn task, void *context);

#endif
