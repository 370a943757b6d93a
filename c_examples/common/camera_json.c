/* Named views from a scenes.json. */
#include "camera.h"

#include <stdlib.h>
#include <string.h>

#include "json_file.h"
#include "message.h"

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* "scenes.json" in the folder of the scene; NULL without memory. */
static char *beside(const char *scene_path)
{
    size_t folder = (size_t)(file_name(scene_path) - scene_path);
    char *path = (char *)malloc(folder + sizeof "scenes.json");
    if (path) {
        memcpy(path, scene_path, folder);
        memcpy(path + folder, "scenes.json", sizeof "scenes.json");
    }
    return path;
}

static int read_vector(const cJSON *view, const char *key, float out[3])
{
    const cJSON *array = cJSON_GetObjectItemCaseSensitive(view, key);
    int i;
    if (cJSON_GetArraySize(array) != 3)
        return 0;
    for (i = 0; i < 3; i++) {
        const cJSON *number = cJSON_GetArrayItem(array, i);
        if (!cJSON_IsNumber(number))
            return 0;
        out[i] = (float)number->valuedouble;
    }
    return 1;
}

static int read_view(const cJSON *view, kit_view *out)
{
    const cJSON *fov = cJSON_GetObjectItemCaseSensitive(view, "fov_deg");
    if (!cJSON_IsNumber(fov))
        return 0;
    out->fov_deg = (float)fov->valuedouble;
    return read_vector(view, "eye", out->eye) && read_vector(view, "at", out->at) &&
           read_vector(view, "up", out->up);
}

static int look_up(const char *path, const cJSON *root, const char *scene_file, const char *name,
                   kit_view *out)
{
    const cJSON *entry = json_find(root, "file", scene_file), *views, *view;
    if (!entry) {
        message("%s: says nothing of %s", path, scene_file);
        return 0;
    }
    views = cJSON_GetObjectItemCaseSensitive(entry, "views");
    view = json_find(views, "name", name);
    if (!view) {
        message("%s: %s has no view %s; it has:", path, scene_file, name);
        cJSON_ArrayForEach(view, views)
        {
            const char *other = json_string(view, "name");
            message("  %s", other ? other : "(one without a name)");
        }
        return 0;
    }
    if (!read_view(view, out)) {
        message("%s: view %s of %s: needs eye, at, up (3 numbers each) and fov_deg", path, name,
                scene_file);
        return 0;
    }
    return 1;
}

int camera_from_json(const char *file, const scene *s, const char *view, kit_view *out)
{
    char *own_path = file ? NULL : beside(s->path);
    const char *path = file ? file : own_path;
    cJSON *root = path ? json_load(path) : NULL;
    int ok = 0;
    if (root)
        ok = look_up(path, root, file_name(s->path), view, out);
    else
        message("view %s: no cameras to look it up in (--cameras FILE names them)", view);
    cJSON_Delete(root);
    free(own_path);
    return ok;
}
