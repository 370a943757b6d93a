#define _DEFAULT_SOURCE
#include "compare/team.h"

#include <pthread.h>

typedef struct {
    pthread_mutex_t lock;
    size_t next, count;
    hug_task_fn task;
    void *context;
} work;

static void *take_tasks(void *of)
{
    work *w = (work *)of;
    for (;;) {
        size_t index;
        pthread_mutex_lock(&w->lock);
        index = w->next;
        w->next += index < w->count;
        pthread_mutex_unlock(&w->lock);
        if (index >= w->count)
            return NULL;
        w->task(w->context, index);
    }
}

void team_run(void *user, size_t tasks, hug_task_fn task, void *context)
{
    const team *t = (const team *)user;
    pthread_t helpers[MOST_TEAM];
    size_t started = 0, wanted = t->threads < MOST_TEAM ? t->threads : MOST_TEAM;
    work w;
    w.next = 0;
    w.count = tasks;
    w.task = task;
    w.context = context;
    pthread_mutex_init(&w.lock, NULL);
    if (wanted > tasks)
        wanted = tasks;
    while (started + 1 < wanted && pthread_create(&helpers[started], NULL, take_tasks, &w) == 0)
        started++;
    take_tasks(&w);
    while (started > 0)
        pthread_join(helpers[--started], NULL);
    pthread_mutex_destroy(&w.lock);
}
