/* Which camera a picture or a comparison is taken with. */
#ifndef CAMERA_H
#define CAMERA_H

#include "scene.h"

/* What the command line said, each NULL if it did not. */
typedef struct {
    const char *camera; /* ten numbers: eye, at, up, vertical field of view in degrees */
    const char *view;   /* a name */
    const char *file;   /* where a scene file's named views are */
} camera_options;

/* --camera; or the named view, of a built-in scene or from a scenes.json; or,
 * without either, a built-in scene's first view, and for a file one from its box.
 * Returns 1, or 0 after a message. */
int camera_choose(const camera_options *options, const scene *s, kit_view *out);

/* What to call the view that camera_choose chose; borrowed from the options or the
 * scene. */
const char *camera_name(const camera_options *options, const scene *s);

/* Looks a scene file's view up in a scenes.json: an array of objects with "file"
 * and "views", which have "name", "eye", "at", "up" and "fov_deg". file NULL: the
 * scenes.json beside the scene. Returns 1, or 0 after a message. */
int camera_from_json(const char *file, const scene *s, const char *view, kit_view *out);

#endif
