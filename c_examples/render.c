/* What it teaches: scene files, cameras and counted queries. Renders a scene file or a
 * built-in scene to PNG: shaded, depth, or a heat map of the steps that each pixel's ray
 * took. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "camera.h"
#include "clocks.h"
#include "message.h"
#include "options.h"
#include "render/frame.h"
#include "render/picture.h"
#include "scene.h"
#include "structures.h"

static const char help[] =
    "usage: render [--scene SCENE] [options]\n"
    "\n"
    "  --scene SCENE      a file that Assimp reads (PLY, OBJ, ...), also looked for in\n"
    "                     the folder $HUG_SCENES; or a built-in scene: kitchen, building,\n"
    "                     building_walls, city, garden (default: kitchen)\n"
    "  --view NAME        a view of the built-in scene, or of the file in its scenes.json\n"
    "  --cameras FILE     where the file's views are (default: scenes.json beside it)\n"
    "  --camera ex,ey,ez,ax,ay,az,ux,uy,uz,fov\n"
    "                     eye, point looked at, up, vertical field of view in degrees\n"
    "                     (without a view or camera: a built-in scene's first view,\n"
    "                     for a file one from inside its bounding box)\n"
    "  --structure NAME   auto, uniform, recursive or hug (default: auto)\n"
    "  --mode MODES       shaded, depth, steps, several with commas, or all\n"
    "                     (default: shaded)\n"
    "  --steps-max N      steps that are white in the heat map, for comparing pictures\n"
    "                     (default: what 99.5 % of the pixels stay within)\n"
    "  --size N           pixels along each side (default: 1024)\n"
    "  --out FILE         the picture (default: SCENE.png); of several modes each gets\n"
    "                     its name before the ending: FILE-depth.png\n"
    "  --help             this text\n";

typedef struct {
    const char *scene_name, *out;
    camera_options camera;
    unsigned modes;
    hug_build_desc build;
    uint32_t size, steps_max;
    int help;
} settings;

static int read_settings(int argc, char **argv, settings *out)
{
    const char *modes = "shaded", *structure = "auto", *size = "1024", *steps = "0";
    unsigned long number;
    const option table[] = {{"--scene", &out->scene_name, NULL},
                            {"--view", &out->camera.view, NULL},
                            {"--cameras", &out->camera.file, NULL},
                            {"--camera", &out->camera.camera, NULL},
                            {"--structure", &structure, NULL},
                            {"--mode", &modes, NULL},
                            {"--steps-max", &steps, NULL},
                            {"--size", &size, NULL},
                            {"--out", &out->out, NULL},
                            {"--help", NULL, &out->help}};

    memset(out, 0, sizeof *out);
    out->scene_name = "kitchen";
    if (!options_parse(argc, argv, table, sizeof table / sizeof *table))
        return 0;
    if (!parse_choice("--mode", modes, picture_names, PICTURE_COUNT, &out->modes))
        return 0;
    if (!parse_one("--structure", structure, structure_names, STRUCTURE_COUNT,
                   &out->build.structure))
        return 0;
    if (!parse_count("--size", size, 1, KIT_MAX_FRAME, &number))
        return 0;
    out->size = (uint32_t)number;
    if (!parse_count("--steps-max", steps, 0, 1000000, &number))
        return 0;
    out->steps_max = (uint32_t)number;
    return 1;
}

/* FILE.png, or FILE-mode.png when there are several. */
static void picture_path(const settings *s, const scene *from, int mode, char *out, size_t size)
{
    const char *base = s->out ? s->out : from->name;
    const char *dot = strrchr(base, '.'), *slash = strrchr(base, '/');
    int stem = s->out && dot && (!slash || dot > slash) ? (int)(dot - base) : (int)strlen(base);
    const char *ending = base[stem] ? base + stem : ".png";
    if (s->modes & (s->modes - 1))
        snprintf(out, size, "%.*s-%s%s", stem, base, picture_names[mode], ending);
    else
        snprintf(out, size, "%.*s%s", stem, base, ending);
}

static int write_pictures(const settings *s, const scene *from, const frame *f,
                          const kit_view *view)
{
    char path[4096];
    int mode;
    for (mode = 0; mode < PICTURE_COUNT; mode++) {
        if (!(s->modes & (1u << mode)))
            continue;
        picture_path(s, from, mode, path, sizeof path);
        if (!picture_write(path, (picture_mode)mode, f, view, s->steps_max))
            return 0;
        printf("%s\n", path);
    }
    return 1;
}

static void print_figures(const scene *from, const hug_scene_stats *stats, double build_seconds,
                          const frame *f)
{
    double steps = 0.0;
    uint32_t most = 0;
    size_t i, hits = 0;
    for (i = 0; i < f->count; i++) {
        steps += f->steps[i];
        most = f->steps[i] > most ? f->steps[i] : most;
        hits += f->hits[i].geom != HUG_NONE;
    }
    printf("%s: %lu triangles (%lu more degenerate, %lu not finite: left out)\n", from->name,
           (unsigned long)stats->triangles, (unsigned long)stats->dropped_degenerate,
           (unsigned long)stats->dropped_non_finite);
    printf("%s: built in %.1f ms, %lu bytes\n", structure_names[stats->structure],
           1e3 * build_seconds, (unsigned long)stats->bytes);
    printf("%lu rows of %lu rays, %.1f %% hit, %.1f steps a ray, at most %lu\n",
           (unsigned long)f->size, (unsigned long)f->size,
           100.0 * (double)hits / (double)f->count, steps / (double)f->count,
           (unsigned long)most);
    printf("%.0f rays per second on one thread\n",
           f->seconds > 0.0 ? (double)f->count / f->seconds : 0.0);
}

static int render(const settings *s, const scene *from)
{
    hug_scene *built = NULL;
    hug_scene_stats stats;
    kit_view view;
    frame traced;
    double build_seconds;
    int ok;

    if (!camera_choose(&s->camera, from, &view))
        return 0;
    build_seconds = seconds_process();
    if (!structure_build(from, &s->build, &built))
        return 0;
    build_seconds = seconds_process() - build_seconds;
    memset(&traced, 0, sizeof traced);
    ok = structure_stats(built, &stats) && frame_trace(built, &view, s->size, &traced);
    if (ok) {
        ok = write_pictures(s, from, &traced, &view);
        print_figures(from, &stats, build_seconds, &traced);
    }
    frame_free(&traced);
    hug_free(built);
    return ok;
}

int main(int argc, char **argv)
{
    settings s;
    scene loaded;
    int ok;

    message_program("render");
    if (!read_settings(argc, argv, &s))
        return 2;
    if (s.help) {
        fputs(help, stdout);
        return 0;
    }
    ok = scene_load(s.scene_name, &loaded) && render(&s, &loaded);
    scene_free(&loaded);
    return ok ? 0 : 1;
}
