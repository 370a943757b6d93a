#include "compare/settings.h"

#include <stddef.h>
#include <string.h>

#include "options.h"
#include "structures.h"

const char settings_help[] =
    "usage: compare [--scene SCENE] [options]\n"
    "\n"
    "The same triangles and the same rays through hug and Embree: speed, memory, and\n"
    "every ray on which they differ, decided by exact arithmetic.\n"
    "\n"
    "  --scene SCENE      a file that Assimp reads (PLY, OBJ, ...), also looked for in\n"
    "                     the folder $HUG_SCENES; or a built-in scene: kitchen, building,\n"
    "                     building_walls, city, garden (default: kitchen)\n"
    "  --structure NAMES  auto, uniform, recursive, hug, several with commas, or all:\n"
    "                     the last three (default)\n"
    "  --rays SETS        primary, shadow, bounce1, bounce2, random, several with commas,\n"
    "                     or all (default)\n"
    "  --query FORMS      single (a call a ray), stream (a call for all), or all (default)\n"
    "  --view NAME        a view of the built-in scene, or of the file in its scenes.json\n"
    "  --cameras FILE     where the file's views are (default: scenes.json beside it)\n"
    "  --camera ex,ey,ez,ax,ay,az,ux,uy,uz,fov\n"
    "                     eye, point looked at, up, vertical field of view in degrees\n"
    "                     (without a view or camera: a built-in scene's first view,\n"
    "                     for a file one from inside its bounding box)\n"
    "  --size N           pixels along each side; the random set has N * N rays, at most\n"
    "                     1048576 (default: 1024)\n"
    "  --rounds N         how often each set is timed (default: 5)\n"
    "  --build-rounds N   how often each build is timed (default: as --rounds)\n"
    "  --isa NAME         the instruction set of hug's queries, portable or avx2\n"
    "                     (default: the fastest that the processor has)\n"
    "  --csv              CSV on standard output instead of tables; what the arbiter\n"
    "                     decided then goes to standard error\n"
    "  --help             this text\n"
    "\n"
    "Medians of the rounds, whose order rotates. Queries: CPU time of the one thread;\n"
    "builds: CPU time of the process. Embree: one thread, medium quality, default\n"
    "flags, rtcIntersect1 and rtcOccluded1; its bytes are those that it allocates,\n"
    "without the vertices and indices that it shares with this program.\n"
    "\n"
    "hit_mismatch: one hits, the other misses. t_mismatch: t differs by more than 1e-4\n"
    "of the larger. prim_mismatch: the same t within that, another triangle.\n"
    "Exit status: 0, 1 if anything failed or was decided against hug, 2 for bad options.\n";

static int read_number(const char *name, const char *text, unsigned long least,
                       unsigned long most, unsigned *out)
{
    unsigned long number;
    if (!parse_count(name, text, least, most, &number))
        return 0;
    *out = (unsigned)number;
    return 1;
}

/* All are the three of the paper: auto is one of them under another name. */
static int read_structures(const char *text, unsigned *out)
{
    if (strcmp(text, "all") == 0) {
        *out = 1u << HUG_STRUCTURE_UNIFORM | 1u << HUG_STRUCTURE_RECURSIVE |
               1u << HUG_STRUCTURE_HUG;
        return 1;
    }
    return parse_choice("--structure", text, structure_names, COMPARED_COUNT, out);
}

int settings_read(int argc, char **argv, settings *out)
{
    static const char *const form_names[FORM_COUNT] = {"single", "stream"};
    const char *structures = "all", *sets = "all", *forms = "all";
    const char *size = "1024", *rounds = "5", *build_rounds = NULL;
    unsigned frame;
    const option table[] = {{"--scene", &out->scene_name, NULL},
                            {"--structure", &structures, NULL},
                            {"--rays", &sets, NULL},
                            {"--query", &forms, NULL},
                            {"--view", &out->camera.view, NULL},
                            {"--cameras", &out->camera.file, NULL},
                            {"--camera", &out->camera.camera, NULL},
                            {"--size", &size, NULL},
                            {"--rounds", &rounds, NULL},
                            {"--build-rounds", &build_rounds, NULL},
                            {"--isa", &out->isa, NULL},
                            {"--csv", NULL, &out->csv},
                            {"--help", NULL, &out->help}};

    memset(out, 0, sizeof *out);
    out->scene_name = "kitchen";
    if (!options_parse(argc, argv, table, sizeof table / sizeof *table))
        return 0;
    if (!read_structures(structures, &out->structures) ||
        !parse_choice("--rays", sets, ray_set_names, RAY_SET_COUNT, &out->sets) ||
        !parse_choice("--query", forms, form_names, FORM_COUNT, &out->forms))
        return 0;
    if (!read_number("--size", size, 1, KIT_MAX_FRAME, &frame) ||
        !read_number("--rounds", rounds, 1, MOST_ROUNDS, &out->rounds) ||
        !read_number("--build-rounds", build_rounds ? build_rounds : rounds, 1, MOST_ROUNDS,
                     &out->build_rounds))
        return 0;
    out->size = frame;
    return 1;
}
