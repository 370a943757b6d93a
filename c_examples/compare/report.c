#include "compare/report.h"

#include <embree3/rtcore.h>
#include <stdio.h>
#include <string.h>

#include "hug.h"
#include "message.h"

static double mrays(size_t rays, double seconds)
{
    return seconds > 0.0 ? 1e-6 * (double)rays / seconds : 0.0;
}

static double ratio(double embree_seconds, double hug_seconds)
{
    return hug_seconds > 0.0 ? embree_seconds / hug_seconds : 0.0;
}

/* A name as a CSV field: quoted where it must be. */
static void put_field(const char *text)
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

void report_begin(int csv, const scene *s, size_t dropped)
{
    if (dropped)
        message("%s: hug leaves out %lu triangles, degenerate or not finite; Embree has them all",
                s->name, (unsigned long)dropped);
    if (csv) {
        puts("scene,triangles,structure,rays,query,isa,hug_mrays,embree_mrays,ratio,ratio_min,"
             "ratio_max,hug_build_ms,embree_build_ms,hug_bytes,embree_bytes,hit_mismatch,"
             "t_mismatch,prim_mismatch");
        return;
    }
    printf("%s: %lu triangles; hug %s (%s), Embree %s\n\n", s->name,
           (unsigned long)s->triangle_count, hug_version(), hug_isa(), RTC_VERSION_STRING);
    printf("%-10s %10s %10s %10s %10s %13s %13s\n", "structure", "build ms", "Embree ms", "B/tri",
           "Embree", "bytes", "Embree");
}

static double per_triangle(unsigned long long bytes, size_t triangles)
{
    return triangles ? (double)bytes / (double)triangles : 0.0;
}

void report_build(int csv, const build_figures *b)
{
    if (!csv)
        printf("%-10s %10.1f %10.1f %10.1f %10.1f %13llu %13llu\n", b->structure,
               1e3 * b->hug_seconds, 1e3 * b->embree_seconds,
               per_triangle(b->hug_bytes, b->triangles),
               per_triangle(b->embree_bytes, b->triangles), b->hug_bytes, b->embree_bytes);
}

void report_queries(int csv)
{
    if (!csv)
        printf("\nMillions of rays per second; ratio above 1: hug is faster\n"
               "%-10s %-8s %-12s %9s %8s %8s %6s %13s %6s %6s %6s\n",
               "structure", "rays", "query", "number", "hug", "Embree", "ratio", "min - max",
               "hit!=", "t!=", "prim!=");
    fflush(stdout);
}

void report_line(int csv, const scene *s, const build_figures *b, const query_figures *q,
                 const tally *t)
{
    double hug = mrays(q->rays, q->hug_seconds), embree = mrays(q->rays, q->embree_seconds);
    double median_ratio = ratio(q->embree_seconds, q->hug_seconds);
    unsigned long hit = (unsigned long)t->found[CLASS_HIT];
    unsigned long other_t = (unsigned long)t->found[CLASS_T];
    unsigned long tie = (unsigned long)t->found[CLASS_TIE];
    if (csv) {
        put_field(s->name);
        printf(",%lu,%s,%s,%s,%s,%.4f,%.4f,%.4f,%.4f,%.4f,%.3f,%.3f,%llu,%llu,%lu,%lu,%lu\n",
               (unsigned long)s->triangle_count, b->structure, q->set, q->query, hug_isa(),
               hug, embree, median_ratio, q->ratio_least, q->ratio_most, 1e3 * b->hug_seconds,
               1e3 * b->embree_seconds, b->hug_bytes, b->embree_bytes, hit, other_t, tie);
    } else {
        printf("%-10s %-8s %-12s %9lu %8.3f %8.3f %6.3f %6.3f-%6.3f %6lu %6lu %6lu\n",
               b->structure, q->set, q->query, (unsigned long)q->rays, hug, embree, median_ratio,
               q->ratio_least, q->ratio_most, hit, other_t, tie);
    }
    fflush(stdout);
}

void report_decided(int csv, int any)
{
    FILE *to = csv ? stderr : stdout;
    if (!any)
        fprintf(to, "\nThe two agree on every ray, but for t within 1e-4\n");
    else
        fprintf(to,
                "\nDifferences, decided by exact arithmetic; of equal t the lowest id is right\n"
                "%-10s %-8s %-20s %9s %16s %9s %9s\n",
                "structure", "rays", "difference", "number", "only hug right", "both",
                "hug wrong");
}

static void put_decision(FILE *to, const build_figures *b, const char *set, const char *what,
                         size_t found, const size_t decided[3])
{
    if (found)
        fprintf(to, "%-10s %-8s %-20s %9lu %16lu %9lu %9lu\n", b->structure, set, what,
                (unsigned long)found, (unsigned long)decided[KIT_OURS],
                (unsigned long)decided[KIT_BOTH], (unsigned long)decided[KIT_THEIRS]);
}

void report_decisions(int csv, const build_figures *b, const char *set, const tally *t)
{
    static const char *const names[CLASS_COUNT] = {"hit or miss", "t", "triangle, same t"};
    FILE *to = csv ? stderr : stdout;
    size_t own[3];
    int i;
    for (i = 0; i < CLASS_COUNT; i++)
        put_decision(to, b, set, names[i], t->found[i], t->decided[i]);
    memset(own, 0, sizeof own);
    own[KIT_THEIRS] = t->inconsistent;
    put_decision(to, b, set, "hug from itself", t->inconsistent, own);
}
