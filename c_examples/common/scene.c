#include "scene.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"

int scene_reserve(scene *out, size_t vertex_count, size_t triangle_count)
{
    /* zeroed, so that the float after the last vertex is no noise */
    out->vertices = (float *)calloc(3 * vertex_count + 1, sizeof(float));
    out->indices = (uint32_t *)malloc(3 * triangle_count * sizeof(uint32_t) + 1);
    if (!out->vertices || !out->indices) {
        message("no memory for %lu triangles", (unsigned long)triangle_count);
        return 0;
    }
    return 1;
}

static int load_built_in(const char *name, scene *out)
{
    kit_status status = kit_scene_generate(name, &out->built_in);
    const float *vertices;
    const uint32_t *indices;
    size_t vertex_count, triangle_count;
    if (status != KIT_OK) {
        message("scene %s: %s (a file's name has an ending; --help lists the built-in scenes)",
                name, kit_status_string(status));
        return 0;
    }
    vertices = kit_scene_vertices(out->built_in, &vertex_count);
    indices = kit_scene_indices(out->built_in, &triangle_count);
    if (!scene_reserve(out, vertex_count, triangle_count))
        return 0;
    memcpy(out->vertices, vertices, 3 * vertex_count * sizeof(float));
    memcpy(out->indices, indices, 3 * triangle_count * sizeof(uint32_t));
    out->vertex_count = vertex_count;
    out->triangle_count = triangle_count;
    snprintf(out->name, sizeof out->name, "%s", name);
    return 1;
}

static int exists(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return 0;
    fclose(file);
    return 1;
}

/* The path to open: as given, or in $HUG_SCENES. NULL after a message. */
static char *find_file(const char *what)
{
    const char *folder = getenv("HUG_SCENES");
    size_t length = strlen(what) + (folder ? strlen(folder) : 0) + 2;
    char *path = (char *)malloc(length);
    if (!path) {
        message("%s: no memory for its path", what);
        return NULL;
    }
    snprintf(path, length, "%s", what);
    if (exists(path))
        return path;
    if (folder && !strchr(what, '/')) {
        snprintf(path, length, "%s/%s", folder, what);
        if (exists(path))
            return path;
        message("%s: neither here nor in HUG_SCENES (%s)", what, folder);
    } else {
        message("%s: %s", what, strerror(errno));
    }
    free(path);
    return NULL;
}

static int load_file(const char *what, scene *out)
{
    const char *base;
    size_t length;
    out->path = find_file(what);
    if (!out->path || !scene_read_file(out->path, out))
        return 0;
    if (out->not_triangles)
        message("%s: %lu points or lines left out", out->path, (unsigned long)out->not_triangles);
    base = strrchr(out->path, '/');
    base = base ? base + 1 : out->path;
    length = strcspn(base, ".");
    if (length >= sizeof out->name)
        length = sizeof out->name - 1;
    memcpy(out->name, base, length);
    out->name[length] = '\0';
    return 1;
}

int scene_load(const char *what, scene *out)
{
    kit_status status;
    memset(out, 0, sizeof *out);
    if (strpbrk(what, "./")) {
        if (!load_file(what, out))
            return 0;
    } else if (!load_built_in(what, out)) {
        return 0;
    }
    status = kit_bounds(out->vertices, 3 * sizeof(float), out->vertex_count, &out->bounds);
    if (status != KIT_OK) {
        message("scene %s: no finite vertex to put a box around: %s", out->name,
                kit_status_string(status));
        return 0;
    }
    return 1;
}

void scene_free(scene *s)
{
    kit_scene_free(s->built_in);
    free(s->path);
    free(s->vertices);
    free(s->indices);
    memset(s, 0, sizeof *s);
}

kit_soup scene_soup(const scene *s)
{
    kit_soup soup;
    soup.vertices = s->vertices;
    soup.vertex_count = s->vertex_count;
    soup.indices = s->indices;
    soup.triangle_count = s->triangle_count;
    return soup;
}
