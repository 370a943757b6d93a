#include "compare/report_text.h"

#include <stdio.h>
#include <string.h>

#include "compare/summary.h"

/* The name with the threads, if there are several. */
static const char *build_name(const build_row *row, char *room, size_t size)
{
    if (row->threads == 1)
        return row->name;
    snprintf(room, size, "%s x%u", row->name, row->threads);
    return room;
}

void text_scene(const comparison *c)
{
    if (c->found->query_count)
        putchar('\n');
    printf("%s: %lu triangles; hug %s (%s), Embree %s\n\n", c->from->name,
           (unsigned long)c->from->triangle_count, hug_version(), c->with->isas.names[0],
           RTC_VERSION_STRING);
    printf("Builds, times as CPU time and by the wall; ratio above 1: faster than Embree; "
           "bytes per triangle\n"
           "%-15s %9s %9s %6s %6s %7s %11s %7s %7s %7s %7s %9s\n",
           "structure", "CPU ms", "wall ms", "ratio", "wall", "Mtri/s", "bytes", "B/tri", "grids",
           "voxels", "refs", "triangles");
}

void text_build(const build_row *row)
{
    char room[32];
    size_t n = row->triangles;
    printf("%-15s %9.1f %9.1f %6.3f %6.3f %7.3f %11llu %7.1f", build_name(row, room, sizeof room),
           1e3 * row->cpu, 1e3 * row->wall, build_ratio(row),
           ratio_of(row->reference_wall, row->wall), millions(n, row->cpu), row->bytes,
           bytes_per_triangle(row->bytes, n));
    if (row->peer)
        printf(" %7s %7s %7s %9s\n", "-", "-", "-", "-");
    else
        printf(" %7.1f %7.1f %7.1f %9.1f\n", bytes_per_triangle(row->grids, n),
               bytes_per_triangle(row->voxels, n), bytes_per_triangle(row->refs, n),
               bytes_per_triangle(row->triangle_bytes, n));
}

void text_view(const char *name)
{
    printf("\nView %s: millions of rays per second; ratio above 1: faster than Embree a ray a "
           "call\n"
           "%-15s %-8s %-15s %-8s %9s %8s %8s %6s %13s %6s %6s %6s\n",
           name, "structure", "rays", "query", "isa", "number", "own", "Embree", "ratio",
           "min - max", "hit!=", "t!=", "prim!=");
}

void text_query(const query_row *row)
{
    printf("%-15s %-8s %-15s %-8s %9lu %8.3f %8.3f %6.3f %6.3f-%6.3f %6lu %6lu %6lu\n", row->name,
           ray_set_names[row->set], query_name(row->set, row->stream),
           row->peer ? "-" : row->isa, (unsigned long)row->rays, millions(row->rays, row->seconds),
           millions(row->rays, row->reference), query_ratio(row), row->ratio_least,
           row->ratio_most, (unsigned long)row->found[CLASS_HIT],
           (unsigned long)row->found[CLASS_T], (unsigned long)row->found[CLASS_TIE]);
}

void text_summary(const results *found)
{
    char room[32];
    size_t i;
    printf("\nRatios to Embree over all scenes and views\n%-15s %-8s %-15s %-8s %5s %6s %6s %s\n",
           "structure", "rays", "query", "isa", "cases", "mean", "least", "at");
    for (i = 0; i < found->query_count; i++) {
        const query_row *row = &found->queries[i];
        summary s;
        if (!first_query(found, i))
            continue;
        s = sum_queries(found, row);
        printf("%-15s %-8s %-15s %-8s %5lu %6.3f %6.3f %s %s\n", row->name,
               ray_set_names[row->set], query_name(row->set, row->stream),
               row->peer ? "-" : row->isa, (unsigned long)s.count, s.mean, s.least, s.scene,
               s.view);
    }
    printf("\nBuilds over all scenes\n%-15s %5s %6s %6s %6s %7s %7s %s\n", "structure", "cases",
           "mean", "wall", "least", "Mtri/s", "B/tri", "least at");
    for (i = 0; i < found->build_count; i++) {
        const build_row *row = &found->builds[i];
        summary s;
        if (!first_build(found, i))
            continue;
        s = sum_builds(found, row);
        printf("%-15s %5lu %6.3f %6.3f %6.3f %7.3f %7.1f %s\n",
               build_name(row, room, sizeof room), (unsigned long)s.count, s.mean, s.wall,
               s.least, s.mega, s.bytes, s.scene);
    }
}
