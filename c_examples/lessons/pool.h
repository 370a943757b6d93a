/* A pool of threads as a renderer may have one: started once, given loops to share. */
#ifndef POOL_H
#define POOL_H

#include <pthread.h>
#include <stddef.h>

#define POOL_MOST 64

typedef void (*pool_task)(void *context, size_t index);

typedef struct {
    pthread_t threads[POOL_MOST];
    unsigned started;
    pthread_mutex_t lock;
    pthread_cond_t work, done;
    pool_task task;
    void *context;
    size_t next, count, running;
    size_t loops; /* so far */
    int end;
} pool;

/* threads counts the one that calls pool_run. Returns the number that there are. */
unsigned pool_start(pool *p, unsigned threads);
void pool_stop(pool *p);

/* Runs the task for every index below count, and returns when all are done; one such loop at a
 * time. Of the type
 * of hug_parallel_for_fn, when the pool is the user pointer. */
void pool_run(void *of, size_t count, pool_task task, void *context);

#endif
