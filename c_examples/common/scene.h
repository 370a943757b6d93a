/* A triangle soup to trace, from a file or built in. */
#ifndef SCENE_H
#define SCENE_H

#include <stddef.h>
#include <stdint.h>

#include "hug_kit.h"

typedef struct {
    char name[128];  /* the file's name without folder and ending, or the built-in's */
    char *path;      /* the file, or NULL for a built-in scene */
    float *vertices; /* 3 a vertex, and one float more: Embree loads 16 bytes a vertex */
    size_t vertex_count;
    uint32_t *indices; /* 3 a triangle */
    size_t triangle_count;
    size_t not_triangles; /* points and lines of the file, left out */
    kit_box bounds;       /* of the finite vertices */
    kit_scene *built_in;  /* NULL for a file */
} scene;

/* Loads what --scene names: with a dot or slash in it a file (a bare name is also
 * looked for in the folder $HUG_SCENES), else a built-in scene. Returns 1, or 0
 * after a message. Free with scene_free in both cases. */
int scene_load(const char *what, scene *out);
void scene_free(scene *s);

/* The same triangles for the arbiter. */
kit_soup scene_soup(const scene *s);

/* Room in *out for so many vertices and triangles. Returns 1, or 0 after a message. */
int scene_reserve(scene *out, size_t vertex_count, size_t triangle_count);

/* Reads a file of any format that Assimp knows into *out: every mesh at its place
 * in the scene, polygons cut into triangles. Returns 1, or 0 after a message. */
int scene_read_file(const char *path, scene *out);

#endif
