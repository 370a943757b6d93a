#define _DEFAULT_SOURCE
#include "lessons/pool.h"
#include <sched.h>

/* How often a thread looks before it sleeps: a build's loops follow one another within less
 * than it takes to wake up. */
enum { LOOKS = 200 };

/* Called and left with the lock held; meanwhile what is looked at may change. */
static void look(pool *p, const size_t *at, size_t seen)
{
    pthread_mutex_unlock(&p->lock);
    for (int i = 0; i < LOOKS && __atomic_load_n(at, __ATOMIC_RELAXED) == seen; i++)
        sched_yield();
    pthread_mutex_lock(&p->lock);
}

/* Takes indices until there are none left; called and left with the lock held. */
static void share(pool *p)
{
    while (p->next < p->count) {
        size_t index = p->next++;
        pool_task task = p->task;
        void *context = p->context;
        __atomic_store_n(&p->running, p->running + 1, __ATOMIC_RELAXED);
        pthread_mutex_unlock(&p->lock);
        task(context, index);
        pthread_mutex_lock(&p->lock);
        __atomic_store_n(&p->running, p->running - 1, __ATOMIC_RELAXED);
    }
    if (p->running == 0)
        pthread_cond_broadcast(&p->done);
}

static void *serve(void *of)
{
    pool *p = (pool *)of;
    pthread_mutex_lock(&p->lock);
    while (!p->end) {
        share(p);
        if (!p->end && p->next >= p->count)
            look(p, &p->loops, p->loops);
        if (!p->end && p->next >= p->count)
            pthread_cond_wait(&p->work, &p->lock);
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

unsigned pool_start(pool *p, unsigned threads)
{
    p->started = 0;
    p->next = p->count = p->running = p->loops = 0;
    p->end = 0;
    pthread_mutex_init(&p->lock, NULL);
    pthread_cond_init(&p->work, NULL);
    pthread_cond_init(&p->done, NULL);
    while (p->started + 1 < threads && p->started < POOL_MOST &&
           pthread_create(&p->threads[p->started], NULL, serve, p) == 0)
        p->started++;
    return p->started + 1;
}

void pool_stop(pool *p)
{
    pthread_mutex_lock(&p->lock);
    p->end = 1;
    __atomic_store_n(&p->loops, p->loops + 1, __ATOMIC_RELAXED);
    pthread_cond_broadcast(&p->work);
    pthread_mutex_unlock(&p->lock);
    while (p->started > 0)
        pthread_join(p->threads[--p->started], NULL);
    pthread_mutex_destroy(&p->lock);
    pthread_cond_destroy(&p->work);
    pthread_cond_destroy(&p->done);
}

void pool_run(void *of, size_t count, pool_task task, void *context)
{
    pool *p = (pool *)of;
    pthread_mutex_lock(&p->lock);
    p->task = task;
    p->context = context;
    p->next = 0;
    p->count = count;
    __atomic_store_n(&p->loops, p->loops + 1, __ATOMIC_RELAXED);
    pthread_cond_broadcast(&p->work);
    share(p);
    for (unsigned i = 0; i < p->started && p->running > 0; i++)
        look(p, &p->running, p->running);
    while (p->running > 0)
        pthread_cond_wait(&p->done, &p->lock);
    p->count = 0;
    pthread_mutex_unlock(&p->lock);
}
