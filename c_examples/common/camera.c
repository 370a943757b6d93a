#include "camera.h"

#include <stddef.h>
#include <string.h>

#include "message.h"
#include "options.h"

static int from_numbers(const char *text, kit_view *out)
{
    float numbers[10];
    if (!parse_floats("--camera", text, numbers, 10))
        return 0;
    memcpy(out->eye, numbers, sizeof out->eye);
    memcpy(out->at, numbers + 3, sizeof out->at);
    memcpy(out->up, numbers + 6, sizeof out->up);
    out->fov_deg = numbers[9];
    return 1;
}

/* NULL takes the first view. */
static int from_built_in(const scene *s, const char *view, kit_view *out)
{
    size_t i, count = kit_scene_view_count(s->built_in);
    for (i = 0; i < count; i++) {
        const char *name;
        kit_status status = kit_scene_view(s->built_in, i, &name, out);
        if (status != KIT_OK) {
            message("scene %s: view %lu: %s", s->name, (unsigned long)i,
                    kit_status_string(status));
            return 0;
        }
        if (!view || strcmp(name, view) == 0)
            return 1;
    }
    message("scene %s has no view %s; it has:", s->name, view ? view : "at all");
    for (i = 0; i < count; i++) {
        const char *name;
        if (kit_scene_view(s->built_in, i, &name, out) == KIT_OK)
            message("  %s", name);
    }
    return 0;
}

static int choose(const camera_options *options, const scene *s, kit_view *out)
{
    kit_status status;
    if (options->camera && options->view) {
        message("--camera and --view exclude each other");
        return 0;
    }
    if (options->camera)
        return from_numbers(options->camera, out);
    if (s->built_in)
        return from_built_in(s, options->view, out);
    if (options->view)
        return camera_from_json(options->file, s, options->view, out);
    status = kit_view_derived(&s->bounds, out);
    if (status != KIT_OK) {
        message("scene %s: no view can be derived from its box: %s", s->name,
                kit_status_string(status));
        return 0;
    }
    return 1;
}

/* Whether the eye looks somewhere, and up leads elsewhere. */
static int has_frame(const kit_view *view)
{
    double ahead[3], square = 0.0;
    int i;
    for (i = 0; i < 3; i++)
        ahead[i] = (double)view->at[i] - view->eye[i];
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double right = ahead[j] * view->up[k] - ahead[k] * view->up[j];
        square += right * right;
    }
    return square > 0.0;
}

int camera_choose(const camera_options *options, const scene *s, kit_view *out)
{
    if (!choose(options, s, out))
        return 0;
    if (!(out->fov_deg > 0.0f && out->fov_deg < 180.0f)) {
        message("the camera's field of view is %g: it must be between 0 and 180 degrees",
                out->fov_deg);
        return 0;
    }
    if (!has_frame(out)) {
        message("the camera looks nowhere, or straight along its up direction");
        return 0;
    }
    return 1;
}

const char *camera_name(const camera_options *options, const scene *s)
{
    const char *name = "derived";
    kit_view unused;
    if (options->camera)
        return "camera";
    if (options->view)
        return options->view;
    if (s->built_in)
        kit_scene_view(s->built_in, 0, &name, &unused);
    return name;
}
