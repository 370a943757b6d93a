#define _DEFAULT_SOURCE
#include "compare/scene_list.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "hug_kit.h"
#include "json_file.h"
#include "message.h"

static int no_memory(void)
{
    message("no memory for the list of scenes");
    return 0;
}

/* folder NULL: what is a built-in scene. */
static listed_scene *add_scene(scene_list *list, const char *folder, const char *what)
{
    size_t length = (folder ? strlen(folder) + 1 : 0) + strlen(what) + 1;
    listed_scene *grown =
        (listed_scene *)realloc(list->scenes, (list->count + 1) * sizeof *list->scenes);
    listed_scene *added;
    if (!grown)
        return NULL;
    list->scenes = grown;
    added = &list->scenes[list->count];
    memset(added, 0, sizeof *added);
    added->what = (char *)malloc(length);
    if (!added->what)
        return NULL;
    snprintf(added->what, length, "%s%s%s", folder ? folder : "", folder ? "/" : "", what);
    added->label = added->what + (folder ? strlen(folder) + 1 : 0);
    list->count++;
    return added;
}

static int add_view(listed_scene *to, const char *name)
{
    char **grown = (char **)realloc(to->views, (to->view_count + 1) * sizeof *to->views);
    size_t length = strlen(name) + 1;
    if (!grown)
        return 0;
    to->views = grown;
    grown[to->view_count] = (char *)malloc(length);
    if (!grown[to->view_count])
        return 0;
    memcpy(grown[to->view_count++], name, length);
    return 1;
}

static int list_built_in(scene_list *out)
{
    size_t i, j;
    for (i = 0; i < kit_scene_count(); i++) {
        listed_scene *added = add_scene(out, NULL, kit_scene_name(i));
        kit_scene *made = NULL;
        kit_view unused;
        const char *name;
        int ok = added && kit_scene_generate(added->what, &made) == KIT_OK;
        for (j = 0; ok && j < kit_scene_view_count(made); j++)
            ok = kit_scene_view(made, j, &name, &unused) == KIT_OK && add_view(added, name);
        kit_scene_free(made);
        if (!ok)
            return no_memory();
    }
    return 1;
}

static int list_json(const char *folder, const char *path, scene_list *out)
{
    cJSON *root = json_load(path);
    const cJSON *entry, *view;
    int ok = root != NULL;
    cJSON_ArrayForEach(entry, root)
    {
        const char *file = json_string(entry, "file");
        listed_scene *added;
        if (!file) {
            message("%s: an entry without \"file\"", path);
            ok = 0;
            break;
        }
        added = add_scene(out, folder, file);
        ok = added != NULL;
        cJSON_ArrayForEach(view, cJSON_GetObjectItemCaseSensitive(entry, "views"))
        {
            const char *name = json_string(view, "name");
            ok = ok && (!name || add_view(added, name));
        }
        if (!ok) {
            no_memory();
            break;
        }
    }
    cJSON_Delete(root);
    return ok;
}

static int is_model(const struct dirent *entry)
{
    const char *dot = strrchr(entry->d_name, '.');
    return dot && (strcasecmp(dot, ".ply") == 0 || strcasecmp(dot, ".obj") == 0);
}

static int list_files(const char *folder, scene_list *out)
{
    struct dirent **entries;
    int i, ok = 1, count = scandir(folder, &entries, is_model, alphasort);
    if (count < 0) {
        message("HUG_SCENES: %s: %s", folder, strerror(errno));
        return 0;
    }
    for (i = 0; i < count; i++) {
        ok = ok && add_scene(out, folder, entries[i]->d_name) != NULL;
        free(entries[i]);
    }
    free(entries);
    return ok || no_memory();
}

static int list_folder(const char *folder, scene_list *out)
{
    size_t length = strlen(folder) + sizeof "/scenes.json";
    char *path = (char *)malloc(length);
    int ok;
    if (!path)
        return no_memory();
    snprintf(path, length, "%s/scenes.json", folder);
    ok = access(path, F_OK) == 0 ? list_json(folder, path, out) : list_files(folder, out);
    free(path);
    if (ok && out->count == 0) {
        message("HUG_SCENES: %s: no scenes in it", folder);
        return 0;
    }
    return ok;
}

int scene_list_make(scene_list *out)
{
    const char *folder = getenv("HUG_SCENES");
    memset(out, 0, sizeof *out);
    if (folder && *folder)
        return list_folder(folder, out);
    message("HUG_SCENES names no folder: the built-in scenes");
    return list_built_in(out);
}

void scene_list_free(scene_list *list)
{
    size_t i, j;
    for (i = 0; i < list->count; i++) {
        for (j = 0; j < list->scenes[i].view_count; j++)
            free(list->scenes[i].views[j]);
        free(list->scenes[i].views);
        free(list->scenes[i].what);
    }
    free(list->scenes);
    memset(list, 0, sizeof *list);
}
