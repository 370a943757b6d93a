/* hug loaded at run time: two threads are its first users, at the same moment; then it
 * is unloaded, and loaded again. */
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "hug.h"

#define ROUNDS 20
#define RAYS 64

static hug_status (*build)(const hug_build_desc *, hug_scene **);
static int32_t (*intersect)(const hug_scene *, const hug_ray *, hug_hit *);
static void (*release)(hug_scene *);
static const char *(*isa)(void);

typedef struct {
    const hug_scene *scene;
    pthread_barrier_t *start;
    hug_hit hits[RAYS];
    const char *isa;
} worker;

static void *trace(void *argument)
{
    worker *w = (worker *)argument;
    int i;
    pthread_barrier_wait(w->start);
    for (i = 0; i < RAYS; i++) {
        hug_ray ray = {{0.01f * (float)i, 0.25f, 2}, 0, {0, 0, -1}, 100, ~0u, 0,
                       HUG_NONE, HUG_NONE};
        intersect(w->scene, &ray, &w->hits[i]);
    }
    w->isa = isa();
    return NULL;
}

/* Two threads, whose queries are the first of all. */
static int race(void)
{
    float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    hug_geometry mesh = {triangle, 3, 0, NULL, 1, HUG_INDEX_NONE, 0};
    hug_build_desc desc = {.struct_size = sizeof desc, .geometries = &mesh, .geometry_count = 1};
    hug_scene *scene = NULL;
    pthread_barrier_t start;
    pthread_t threads[2];
    worker workers[2];
    int i, same;
    if (build(&desc, &scene) != HUG_OK)
        return 0;
    memset(workers, 0, sizeof workers);
    pthread_barrier_init(&start, NULL, 2);
    for (i = 0; i < 2; i++) {
        workers[i].scene = scene;
        workers[i].start = &start;
        if (pthread_create(&threads[i], NULL, trace, &workers[i]) != 0)
            return 0;
    }
    for (i = 0; i < 2; i++)
        pthread_join(threads[i], NULL);
    pthread_barrier_destroy(&start);
    same = memcmp(workers[0].hits, workers[1].hits, sizeof workers[0].hits) == 0 &&
           workers[0].isa == workers[1].isa && workers[0].hits[30].t == 2;
    release(scene);
    return same;
}

/* ISO C has no conversion from an object's address to a function's. */
static int find(void *library, const char *name, void *function)
{
    void *address = dlsym(library, name);
    memcpy(function, &address, sizeof address);
    return address != NULL;
}

int main(int argc, char **argv)
{
    int round, unloaded = 0;
    for (round = 0; round < ROUNDS; round++) {
        void *library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
        if (!library || !find(library, "hug_build", &build) ||
            !find(library, "hug_intersect", &intersect) || !find(library, "hug_free", &release) ||
            !find(library, "hug_isa", &isa)) {
            fprintf(stderr, "loading: %s\n", library ? "a function is missing" : dlerror());
            return 1;
        }
        if (!race()) {
            fprintf(stderr, "loading: two threads differ in round %d\n", round);
            return 1;
        }
        if (dlclose(library) != 0)
            return 1;
        library = dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD);
        unloaded += library == NULL;
        if (library)
            dlclose(library);
    }
    printf("loaded %d times, unloaded %d times\n", ROUNDS, unloaded);
    return unloaded == ROUNDS ? 0 : 1;
}
