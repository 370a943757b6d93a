#include "compare/report_markdown.h"

#include <stdio.h>
#include <string.h>

#include "compare/machine.h"
#include "compare/summary.h"

static void put_head(const settings *with)
{
    char machine[400], date[16], command[2000];
    size_t i;
    machine_name(machine, sizeof machine);
    machine_date(date, sizeof date);
    machine_command(with->argc, with->argv, command, sizeof command);
    printf("- Machine: %s\n- Date: %s\n- hug %s on", machine, date, hug_version());
    for (i = 0; i < with->isas.count; i++)
        printf("%s %s", i ? "," : "", with->isas.names[i]);
    printf("; Embree %s; compared by a program of %s\n", RTC_VERSION_STRING, machine_compiler);
    printf("- Command: `%s`\n- %u x %u pixels, %u rounds of queries, %u of builds\n", command,
           with->size, with->size, with->rounds, with->build_rounds);
}

/* The line under a table's heads: some columns of text, then of numbers. */
static void put_rule(int text, int numbers)
{
    while (text-- > 0)
        printf("|---");
    while (numbers-- > 0)
        printf("|---:");
    puts("|");
}

/* The contender's row of one scene, view, set and form, or NULL. */
static const query_row *cell(const results *found, const query_row *contender,
                             const query_row *place, int set, int stream)
{
    size_t i;
    for (i = 0; i < found->query_count; i++) {
        const query_row *row = &found->queries[i];
        if (row->set == set && row->stream == stream && !row->peer &&
            strcmp(row->name, contender->name) == 0 && strcmp(row->isa, contender->isa) == 0 &&
            strcmp(row->scene, place->scene) == 0 && strcmp(row->view, place->view) == 0)
            return row;
    }
    return NULL;
}

/* Whether no row before is of the same scene and view. */
static int first_place(const results *found, size_t row)
{
    const query_row *q = found->queries;
    size_t i = 0;
    while (strcmp(q[i].scene, q[row].scene) != 0 || strcmp(q[i].view, q[row].view) != 0)
        i++;
    return i == row;
}

static void put_scenes(const settings *with, const results *found)
{
    const query_row *first = &found->queries[0];
    int set, stream, columns = 0;
    size_t i;
    printf("\n### %s (%s), scene by scene\n\n| scene | view | triangles |", first->name,
           first->isa);
    for (set = 0; set < RAY_SET_COUNT; set++) {
        for (stream = 0; stream < 2; stream++) {
            if (!settings_asks(with, set, stream))
                continue;
            printf(" %s%s |", ray_set_names[set], stream ? ", stream" : "");
            columns++;
        }
    }
    putchar('\n');
    put_rule(2, 1 + columns);
    for (i = 0; i < found->query_count; i++) {
        const query_row *place = &found->queries[i];
        if (!first_place(found, i))
            continue;
        printf("| %s | %s | %lu |", place->scene, place->view, (unsigned long)place->triangles);
        for (set = 0; set < RAY_SET_COUNT; set++) {
            for (stream = 0; stream < 2; stream++) {
                const query_row *row = cell(found, first, place, set, stream);
                if (row)
                    printf(" %.2f |", query_ratio(row));
                else if (settings_asks(with, set, stream))
                    printf(" |");
            }
        }
        putchar('\n');
    }
}

static void put_means(const settings *with, const results *found)
{
    int set, columns = 0;
    size_t i;
    printf("\n### Geometric means, and minima with their scenes\n\n| | form | ISA |");
    for (set = 0; set < RAY_SET_COUNT; set++) {
        if (with->sets & (1u << set)) {
            printf(" %s |", ray_set_names[set]);
            columns++;
        }
    }
    putchar('\n');
    put_rule(3, columns);
    for (i = 0; i < found->query_count; i++) {
        const query_row *row = &found->queries[i];
        if (!first_contender(found, i))
            continue;
        printf("| %s | %s | %s |", row->name, row->stream ? "stream" : "single", row->isa);
        for (set = 0; set < RAY_SET_COUNT; set++) {
            const query_row *own = same_in_set(found, row, set);
            summary s;
            if (own) {
                s = sum_queries(found, own);
                printf(" %.2f (%.2f %s) |", s.mean, s.least, s.scene);
            } else if (with->sets & (1u << set)) {
                printf(" |");
            }
        }
        putchar('\n');
    }
}

static void put_build_scenes(const results *found)
{
    const char *first = found->builds[0].name;
    size_t i;
    printf("\n### Builds of %s, scene by scene\n\n| scene | triangles | ms | Embree ms | ratio | "
           "Mtri/s | B/tri | Embree B/tri | grids | voxels | refs | triangles |\n",
           first);
    put_rule(1, 11);
    for (i = 0; i < found->build_count; i++) {
        const build_row *b = &found->builds[i];
        size_t n = b->triangles;
        if (strcmp(b->name, first) != 0)
            continue;
        printf("| %s | %lu | %.1f | %.1f | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f "
               "|\n",
               b->scene, (unsigned long)n, 1e3 * b->cpu, 1e3 * b->reference_cpu, build_ratio(b),
               millions(n, b->cpu), bytes_per_triangle(b->bytes, n),
               bytes_per_triangle(b->reference_bytes, n), bytes_per_triangle(b->grids, n),
               bytes_per_triangle(b->voxels, n), bytes_per_triangle(b->refs, n),
               bytes_per_triangle(b->triangle_bytes, n));
    }
}

static void put_build_means(const results *found)
{
    size_t i;
    puts("\n### Builds, geometric means\n\n| | threads | speed to Embree | least | by the wall | "
         "Mtri/s | B/tri |");
    put_rule(1, 6);
    for (i = 0; i < found->build_count; i++) {
        const build_row *row = &found->builds[i];
        summary s;
        if (!first_build(found, i))
            continue;
        s = sum_builds(found, row);
        printf("| %s | %u | %.2f | %.2f %s | %.2f | %.2f | %.1f |\n", row->name, row->threads,
               s.mean, s.least, s.scene, s.wall, s.mega, s.bytes);
    }
}

void markdown_summary(const settings *with, const results *found)
{
    put_head(with);
    if (found->query_count) {
        put_scenes(with, found);
        put_means(with, found);
    }
    if (found->build_count) {
        put_build_scenes(found);
        put_build_means(found);
    }
}
