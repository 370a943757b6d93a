#include "compare/settings.h"

#include <stddef.h>
#include <string.h>

#include "compare/peers.h"
#include "message.h"
#include "options.h"
#include "structures.h"

static int read_number(const char *name, const char *text, unsigned long least,
                       unsigned long most, unsigned *out)
{
    unsigned long number;
    if (!parse_count(name, text, least, most, &number))
        return 0;
    *out = (unsigned)number;
    return 1;
}

/* All are the three of the paper: auto is one of them under another name, but with
 * --all it is what the tables are about. */
static int read_structures(const char *text, int every_scene, unsigned *out)
{
    if (!text && every_scene)
        text = "auto,uniform,recursive,hug";
    if (!text || strcmp(text, "all") == 0)
        text = "uniform,recursive,hug";
    return parse_choice("--structure", text, structure_names, COMPARED_COUNT, out);
}

/* The last two words stand for two queries each. */
static int read_queries(const char *text, unsigned *out)
{
    static const char *const words[QUERY_COUNT + 2] = {
        "closest", "occluded", "closest_stream", "occluded_stream", "single", "stream"};
    const unsigned single = 1u << QUERY_CLOSEST | 1u << QUERY_OCCLUDED;
    const unsigned stream = 1u << QUERY_CLOSEST_STREAM | 1u << QUERY_OCCLUDED_STREAM;
    unsigned chosen;
    if (!parse_choice("--query", text, words, QUERY_COUNT + 2, &chosen))
        return 0;
    *out = chosen & (single | stream);
    if (chosen & (1u << QUERY_COUNT))
        *out |= single;
    if (chosen & (2u << QUERY_COUNT))
        *out |= stream;
    return 1;
}

static int read_peers(const char *text, unsigned *out)
{
    unsigned chosen = 0;
    if (strcmp(text, "none") != 0 &&
        !parse_choice("--peers", text, peer_words, PEER_COUNT - 1, &chosen))
        return 0;
    *out = chosen << 1 | 1u << PEER_REFERENCE;
    return 1;
}

int settings_asks(const settings *with, int set, int stream)
{
    int query = set == RAYS_SHADOW ? QUERY_OCCLUDED : QUERY_CLOSEST;
    if (stream)
        query += QUERY_CLOSEST_STREAM;
    return (with->sets & (1u << set)) && (with->queries & (1u << query));
}

static int consistent(const settings *s, const char *views, int csv, int markdown)
{
    int set, asked = 0;
    for (set = 0; set < RAY_SET_COUNT; set++)
        asked |= settings_asks(s, set, 0) || settings_asks(s, set, 1);
    if (!asked)
        message("--query and --rays leave nothing: shadow rays ask for occlusion, all others "
                "for closest hits");
    else if (csv && markdown)
        message("--csv and --markdown exclude each other");
    else if (s->all && (s->scene_name || s->camera.view || s->camera.camera || s->camera.file))
        message("--all goes with none of --scene, --view, --camera and --cameras");
    else if (!s->all && views)
        message("--views is for --all");
    else
        return 1;
    return 0;
}

int settings_read(int argc, char **argv, settings *out)
{
    static const char *const view_words[2] = {"first", "all"};
    static const char *const quality_words[3] = {"default", "fast", "high"};
    const char *structures = NULL, *sets = "all", *queries = "all", *peer_list = "none";
    const char *size = "1024", *rounds = "5", *build_rounds = NULL, *threads = "1";
    const char *views = NULL, *isas = NULL, *quality = "default";
    int csv = 0, markdown = 0, compact = 0;
    unsigned every_view = 0, frame, fineness;
    const option table[] = {{"--scene", &out->scene_name, NULL},
                            {"--all", NULL, &out->all},
                            {"--views", &views, NULL},
                            {"--structure", &structures, NULL},
                            {"--rays", &sets, NULL},
                            {"--query", &queries, NULL},
                            {"--peers", &peer_list, NULL},
                            {"--isa", &isas, NULL},
                            {"--view", &out->camera.view, NULL},
                            {"--cameras", &out->camera.file, NULL},
                            {"--camera", &out->camera.camera, NULL},
                            {"--size", &size, NULL},
                            {"--rounds", &rounds, NULL},
                            {"--build-rounds", &build_rounds, NULL},
                            {"--threads", &threads, NULL},
                            {"--quality", &quality, NULL},
                            {"--compact", NULL, &compact},
                            {"--csv", NULL, &csv},
                            {"--markdown", NULL, &markdown},
                            {"--help", NULL, &out->help}};

    memset(out, 0, sizeof *out);
    out->argc = argc;
    out->argv = argv;
    if (!options_parse(argc, argv, table, sizeof table / sizeof *table))
        return 0;
    if (out->help)
        return 1;
    if (!read_structures(structures, out->all, &out->structures) ||
        !parse_choice("--rays", sets, ray_set_names, RAY_SET_COUNT, &out->sets) ||
        !read_queries(queries, &out->queries) || !read_peers(peer_list, &out->peers) ||
        !parse_one("--quality", quality, quality_words, 3, &fineness) ||
        (views && !parse_one("--views", views, view_words, 2, &every_view)))
        return 0;
    if (!read_number("--size", size, 1, KIT_MAX_FRAME, &frame) ||
        !read_number("--rounds", rounds, 1, MOST_ROUNDS, &out->rounds) ||
        !read_number("--build-rounds", build_rounds ? build_rounds : rounds, 1, MOST_ROUNDS,
                     &out->build_rounds) ||
        !read_number("--threads", threads, 1, MOST_THREADS, &out->threads))
        return 0;
    if (!consistent(out, views, csv, markdown) || !isas_read(isas, &out->isas))
        return 0;
    if (!out->all && !out->scene_name)
        out->scene_name = "kitchen";
    out->build.quality = fineness;
    out->build.flags = compact ? HUG_BUILD_COMPACT : 0;
    out->every_view = (int)every_view;
    out->size = frame;
    out->format = csv ? FORMAT_CSV : markdown ? FORMAT_MARKDOWN : FORMAT_TEXT;
    return 1;
}
