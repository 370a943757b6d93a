#include "compare/summary.h"

#include <math.h>
#include <string.h>

static int same_contender(const query_row *a, const query_row *b)
{
    return a->peer == b->peer && a->stream == b->stream && strcmp(a->name, b->name) == 0 &&
           strcmp(a->isa, b->isa) == 0;
}

static int same_query(const query_row *a, const query_row *b)
{
    return a->set == b->set && same_contender(a, b);
}

static int same_build(const build_row *a, const build_row *b)
{
    return a->peer == b->peer && a->threads == b->threads && strcmp(a->name, b->name) == 0;
}

int first_contender(const results *r, size_t row)
{
    size_t i = 0;
    while (!same_contender(&r->queries[i], &r->queries[row]))
        i++;
    return i == row;
}

int first_query(const results *r, size_t row)
{
    size_t i = 0;
    while (!same_query(&r->queries[i], &r->queries[row]))
        i++;
    return i == row;
}

int first_build(const results *r, size_t row)
{
    size_t i = 0;
    while (!same_build(&r->builds[i], &r->builds[row]))
        i++;
    return i == row;
}

/* The mean of count logarithms, or 0 of none; -infinity, of a 0, gives 0. */
static double mean_of(double logarithms, size_t count)
{
    return count ? exp(logarithms / (double)count) : 0.0;
}

static void take_ratio(summary *s, double ratio, const char *scene, const char *view)
{
    s->mean += log(ratio);
    if (s->count++ && ratio >= s->least)
        return;
    s->least = ratio;
    s->scene = scene;
    s->view = view;
}

summary sum_queries(const results *r, const query_row *like)
{
    summary s;
    size_t i;
    memset(&s, 0, sizeof s);
    s.scene = s.view = "";
    for (i = 0; i < r->query_count; i++) {
        const query_row *row = &r->queries[i];
        /* a set of no rays, where no primary ray hits, says nothing */
        if (same_query(row, like) && row->rays > 0)
            take_ratio(&s, query_ratio(row), row->scene, row->view);
    }
    s.mean = mean_of(s.mean, s.count);
    return s;
}

summary sum_builds(const results *r, const build_row *like)
{
    summary s;
    size_t i;
    memset(&s, 0, sizeof s);
    s.scene = s.view = "";
    for (i = 0; i < r->build_count; i++) {
        const build_row *row = &r->builds[i];
        if (!same_build(row, like))
            continue;
        take_ratio(&s, build_ratio(row), row->scene, "");
        s.bytes += log(bytes_per_triangle(row->bytes, row->triangles));
        s.wall += log(ratio_of(row->reference_wall, row->wall));
        s.mega += log(millions(row->triangles, row->cpu));
    }
    s.mean = mean_of(s.mean, s.count);
    s.bytes = mean_of(s.bytes, s.count);
    s.wall = mean_of(s.wall, s.count);
    s.mega = mean_of(s.mega, s.count);
    return s;
}

const query_row *same_in_set(const results *r, const query_row *like, int set)
{
    size_t i;
    for (i = 0; i < r->query_count; i++)
        if (r->queries[i].set == set && same_contender(&r->queries[i], like))
            return &r->queries[i];
    return NULL;
}
