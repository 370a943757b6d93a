#include "structures.h"

#include <string.h>

#include "message.h"

const char *const structure_names[STRUCTURE_COUNT] = {"auto", "uniform", "recursive", "hug"};

int structure_build(const scene *s, const hug_build_desc *options, hug_scene **out)
{
    hug_geometry geometry;
    hug_build_desc desc = *options;
    hug_status status;

    memset(&geometry, 0, sizeof geometry);
    geometry.vertices = s->vertices;
    geometry.vertex_count = s->vertex_count;
    geometry.indices = s->indices;
    geometry.index_type = HUG_INDEX_U32;
    geometry.triangle_count = s->triangle_count;

    desc.struct_size = sizeof desc;
    desc.geometries = &geometry;
    desc.geometry_count = 1;

    status = hug_build(&desc, out);
    if (status != HUG_OK) {
        message("scene %s: building \"%s\": %s", s->name, structure_names[desc.structure],
                hug_status_string(status));
        return 0;
    }
    return 1;
}

int structure_stats(const hug_scene *built, hug_scene_stats *out)
{
    hug_status status;
    memset(out, 0, sizeof *out);
    out->struct_size = sizeof *out;
    status = hug_stats(built, out);
    if (status != HUG_OK) {
        message("statistics: %s", hug_status_string(status));
        return 0;
    }
    return 1;
}
