/* What it teaches: build once, use in many processes. The scene's bytes (hug_data) are
 * written to a file; other processes map the file and use the scene where it lies
 * (hug_open), without reading, copying or building anything. All share the same memory,
 * which the system loads when a ray needs it. hug_open checks the bytes first, so a file
 * that is not what it should be is an error and nothing worse; a process that trusts the
 * writer may skip the check (HUG_OPEN_TRUSTED), which otherwise touches every page.
 *
 * usage: mmap FILE [PROCESSES]
 */
#define _DEFAULT_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lessons/waves.h"

#define SIDE 200
#define WIDTH 160u
#define MOST_PROCESSES 64

static int failed(const char *what, const char *why)
{
    fprintf(stderr, "mmap: %s: %s\n", what, why);
    return 0;
}

static int build_and_write(const char *path)
{
    float *vertices = (float *)malloc(3 * WAVES_VERTICES(SIDE) * sizeof(float));
    uint32_t *indices = (uint32_t *)malloc(3 * WAVES_TRIANGLES(SIDE) * sizeof(uint32_t));
    hug_geometry geometry;
    hug_build_desc desc;
    hug_scene *scene = NULL;
    hug_status status = HUG_ERROR_OUT_OF_MEMORY;
    int ok = 0;
    if (vertices && indices) {
        waves_vertices(SIDE, 0.0f, vertices);
        waves_indices(SIDE, indices);
        geometry = waves_geometry(SIDE, vertices, indices);
        desc = waves_desc(&geometry);
        status = hug_build(&desc, &scene);
    }
    if (status == HUG_OK) {
        size_t size;
        const void *bytes = hug_data(scene, &size);
        FILE *file = fopen(path, "wb");
        ok = file && fwrite(bytes, 1, size, file) == size;
        ok = file && fclose(file) == 0 && ok;
        if (ok)
            printf("%s: %lu triangles in %lu bytes\n", path,
                   (unsigned long)WAVES_TRIANGLES(SIDE), (unsigned long)size);
        else
            failed(path, strerror(errno));
    } else {
        failed("building", hug_status_string(status));
    }
    hug_free(scene);
    free(vertices);
    free(indices);
    return ok;
}

/* The file as a scene. A mapping is aligned to a page, so to the 64 bytes hug asks for. */
static const hug_scene *map(const char *path, uint32_t flags)
{
    const hug_scene *scene = NULL;
    struct stat info;
    hug_status status;
    void *bytes = MAP_FAILED;
    int file = open(path, O_RDONLY);
    if (file >= 0 && fstat(file, &info) == 0)
        bytes = mmap(NULL, (size_t)info.st_size, PROT_READ, MAP_SHARED, file, 0);
    if (bytes == MAP_FAILED) {
        failed(path, strerror(errno));
        return NULL;
    }
    close(file); /* the mapping stays */
    status = hug_open(bytes, (size_t)info.st_size, flags, &scene);
    if (status != HUG_OK)
        failed(path, hug_status_string(status));
    return scene;
}

/* What one of the processes does: a picture, told in one number. */
static int render(const char *path, int number, int to)
{
    const hug_scene *scene = map(path, number ? 0 : HUG_OPEN_TRUSTED);
    uint64_t digest = WAVES_SEED;
    unsigned x, y;
    if (!scene)
        return 0;
    for (y = 0; y < WIDTH; y++)
        for (x = 0; x < WIDTH; x++) {
            hug_ray ray = waves_ray(x, y, WIDTH, WIDTH);
            hug_hit hit;
            hug_intersect(scene, &ray, &hit);
            digest = waves_digest(digest, &hit, sizeof hit);
        }
    return write(to, &digest, sizeof digest) == sizeof digest;
}

int main(int argc, char **argv)
{
    int processes = argc > 2 ? atoi(argv[2]) : 4, ends[2], i, same = 1;
    uint64_t first = 0;
    if (argc < 2 || processes < 1 || processes > MOST_PROCESSES) {
        fprintf(stderr, "usage: mmap FILE [PROCESSES, 1 to %d]\n", MOST_PROCESSES);
        return 2;
    }
    if (!build_and_write(argv[1]))
        return 1;
    if (pipe(ends) != 0)
        return !failed("pipe", strerror(errno));
    fflush(stdout);
    for (i = 0; i < processes; i++) {
        pid_t child = fork();
        if (child < 0)
            return !failed("fork", strerror(errno));
        if (child == 0)
            _exit(render(argv[1], i, ends[1]) ? 0 : 1);
    }
    close(ends[1]);
    for (i = 0; i < processes; i++) {
        uint64_t digest;
        int status;
        if (wait(&status) < 0 || status != 0 || read(ends[0], &digest, 8) != 8)
            return !failed("a process", "has failed");
        same &= i == 0 || digest == first;
        first = digest;
    }
    printf("%d processes: picture %016llx%s\n", processes, (unsigned long long)first,
           same ? " in each" : ", not the same in each");
    return same ? 0 : 1;
}
