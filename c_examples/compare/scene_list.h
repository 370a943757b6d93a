/* The scenes that --all goes through. */
#ifndef SCENE_LIST_H
#define SCENE_LIST_H

#include <stddef.h>

typedef struct {
    char *what;        /* for scene_load */
    const char *label; /* for messages: never a path */
    char **views;      /* names; none: the view that is derived from the box */
    size_t view_count;
} listed_scene;

typedef struct {
    listed_scene *scenes;
    size_t count;
} scene_list;

/* The folder $HUG_SCENES, in the order of its scenes.json or, without one, every PLY
 * and OBJ file of it by name; without the variable the built-in scenes. Returns 1,
 * or 0 after a message. Free in both cases. */
int scene_list_make(scene_list *out);
void scene_list_free(scene_list *list);

#endif
