#include "compare/report_csv.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "compare/summary.h"

enum {
    SCENE, TRIANGLES, STRUCTURE, RAYS, QUERY, ISA, HUG_MRAYS, EMBREE_MRAYS, RATIO, RATIO_MIN,
    RATIO_MAX, HUG_BUILD_MS, EMBREE_BUILD_MS, HUG_BYTES, EMBREE_BYTES, HIT_MISMATCH, T_MISMATCH,
    PRIM_MISMATCH, VIEW, NUMBER, HUG_BUILD_WALL_MS, EMBREE_BUILD_WALL_MS, BUILD_RATIO,
    BYTES_PER_TRIANGLE, GRID_BYTES, VOXEL_BYTES, REF_BYTES, TRIANGLE_BYTES, THREADS_BUILD_MS,
    THREADS_BUILD_WALL_MS, HUG_THREADS_BUILD_MS, HUG_THREADS_BUILD_WALL_MS, COLUMNS
};

static const char *const names[COLUMNS] = {
    "scene", "triangles", "structure", "rays", "query", "isa", "hug_mrays", "embree_mrays",
    "ratio", "ratio_min", "ratio_max", "hug_build_ms", "embree_build_ms", "hug_bytes",
    "embree_bytes", "hit_mismatch", "t_mismatch", "prim_mismatch", "view", "number",
    "hug_build_wall_ms", "embree_build_wall_ms", "build_ratio", "bytes_per_triangle",
    "grid_bytes", "voxel_bytes", "ref_bytes", "triangle_bytes", "embree_threads_build_ms",
    "embree_threads_build_wall_ms", "hug_threads_build_ms", "hug_threads_build_wall_ms"};

/* One line: what is not set stays empty. */
typedef struct {
    char text[COLUMNS][256];
} line;

static void set(line *l, int column, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void set(line *l, int column, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(l->text[column], sizeof l->text[column], format, list);
    va_end(list);
}

/* Quoted where it must be. */
static void put(const char *text)
{
    if (!strpbrk(text, ",\"\n")) {
        fputs(text, stdout);
        return;
    }
    putchar('"');
    for (; *text; text++) {
        if (*text == '"')
            putchar('"');
        putchar(*text);
    }
    putchar('"');
}

/* The last four columns are there only with --threads. */
static int columns(const settings *with)
{
    return with->threads > 1 ? COLUMNS : THREADS_BUILD_MS;
}

static void put_line(const settings *with, const line *l)
{
    int i;
    for (i = 0; i < columns(with); i++) {
        if (i)
            putchar(',');
        put(l->text[i]);
    }
    putchar('\n');
}

void csv_begin(const settings *with)
{
    int i;
    for (i = 0; i < columns(with); i++)
        printf("%s%s", i ? "," : "", names[i]);
    putchar('\n');
}

static void set_query(line *l, const query_row *row)
{
    set(l, STRUCTURE, "%s", row->name);
    set(l, RAYS, "%s", ray_set_names[row->set]);
    set(l, QUERY, "%s", query_name(row->set, row->stream));
    set(l, ISA, "%s", row->isa);
}

/* hug's columns stay empty in a peer's line; Embree's are then the peer's own. */
static void set_build(line *l, const build_row *b)
{
    double cpu = b->peer ? b->cpu : b->reference_cpu, wall = b->peer ? b->wall : b->reference_wall;
    set(l, EMBREE_BUILD_MS, "%.3f", 1e3 * cpu);
    set(l, EMBREE_BUILD_WALL_MS, "%.3f", 1e3 * wall);
    set(l, EMBREE_BYTES, "%llu", b->peer ? b->bytes : b->reference_bytes);
    set(l, BUILD_RATIO, "%.4f", build_ratio(b));
    set(l, BYTES_PER_TRIANGLE, "%.3f", bytes_per_triangle(b->bytes, b->triangles));
    if (b->peer)
        return;
    set(l, HUG_BUILD_MS, "%.3f", 1e3 * b->cpu);
    set(l, HUG_BUILD_WALL_MS, "%.3f", 1e3 * b->wall);
    set(l, HUG_BYTES, "%llu", b->bytes);
    set(l, GRID_BYTES, "%llu", b->grids);
    set(l, VOXEL_BYTES, "%llu", b->voxels);
    set(l, REF_BYTES, "%llu", b->refs);
    set(l, TRIANGLE_BYTES, "%llu", b->triangle_bytes);
}

void csv_query(const settings *with, const query_row *row, const build_row *build,
               const build_row *threaded, const build_row *hug_threaded)
{
    double own = millions(row->rays, row->seconds);
    line l;
    memset(&l, 0, sizeof l);
    set(&l, SCENE, "%s", row->scene);
    set(&l, VIEW, "%s", row->view);
    set(&l, TRIANGLES, "%lu", (unsigned long)row->triangles);
    set(&l, NUMBER, "%lu", (unsigned long)row->rays);
    set_query(&l, row);
    if (!row->peer)
        set(&l, HUG_MRAYS, "%.4f", own);
    set(&l, EMBREE_MRAYS, "%.4f", row->peer ? own : millions(row->rays, row->reference));
    set(&l, RATIO, "%.4f", query_ratio(row));
    set(&l, RATIO_MIN, "%.4f", row->ratio_least);
    set(&l, RATIO_MAX, "%.4f", row->ratio_most);
    set(&l, HIT_MISMATCH, "%lu", (unsigned long)row->found[CLASS_HIT]);
    set(&l, T_MISMATCH, "%lu", (unsigned long)row->found[CLASS_T]);
    set(&l, PRIM_MISMATCH, "%lu", (unsigned long)row->found[CLASS_TIE]);
    set_build(&l, build);
    set(&l, THREADS_BUILD_MS, "%.3f", 1e3 * threaded->cpu);
    set(&l, THREADS_BUILD_WALL_MS, "%.3f", 1e3 * threaded->wall);
    if (hug_threaded) {
        set(&l, HUG_THREADS_BUILD_MS, "%.3f", 1e3 * hug_threaded->cpu);
        set(&l, HUG_THREADS_BUILD_WALL_MS, "%.3f", 1e3 * hug_threaded->wall);
    }
    put_line(with, &l);
}

/* The line l, which says whose it is, with the mean and again with the least. */
static void put_summary(const settings *with, line *l, const summary *s, int ratio)
{
    set(l, SCENE, "geomean");
    set(l, NUMBER, "%lu", (unsigned long)s->count);
    set(l, ratio, "%.4f", s->mean);
    put_line(with, l);
    set(l, SCENE, "minimum");
    set(l, VIEW, "%s%s%s", s->scene, *s->view ? "/" : "", s->view);
    set(l, ratio, "%.4f", s->least);
    l->text[BYTES_PER_TRIANGLE][0] = '\0';
    put_line(with, l);
}

void csv_summary(const settings *with, const results *found)
{
    size_t i;
    line l;
    for (i = 0; i < found->query_count; i++) {
        summary s = sum_queries(found, &found->queries[i]);
        if (!first_query(found, i))
            continue;
        memset(&l, 0, sizeof l);
        set_query(&l, &found->queries[i]);
        put_summary(with, &l, &s, RATIO);
    }
    for (i = 0; i < found->build_count; i++) {
        const build_row *row = &found->builds[i];
        summary s = sum_builds(found, row);
        if (!first_build(found, i))
            continue;
        memset(&l, 0, sizeof l);
        set(&l, STRUCTURE, "%s", row->name);
        if (row->threads > 1)
            set(&l, STRUCTURE, "%s_threads%u", row->name, row->threads);
        set(&l, QUERY, "build");
        set(&l, BYTES_PER_TRIANGLE, "%.3f", s.bytes);
        put_summary(with, &l, &s, BUILD_RATIO);
    }
}
