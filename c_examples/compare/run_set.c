#include "compare/run_set.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clocks.h"
#include "compare/queries.h"
#include "message.h"

#define LANES (COMPARED_COUNT * FORM_COUNT)

/* One structure in one form. */
typedef struct {
    int structure, form;
    hug_query query;
    double *seconds;
} lane;

typedef struct {
    comparison *c;
    int set;
    const ray_set *rays;
    lane lanes[LANES];
    size_t count;
    embree_query embree;
    double *seconds; /* of all, lanes first and Embree last */
} running;

static int occlusion(int set)
{
    return set == RAYS_SHADOW;
}

static int prepare(running *r)
{
    const settings *with = r->c->with;
    int structure, form;
    for (structure = 0; structure < COMPARED_COUNT; structure++) {
        for (form = 0; form < FORM_COUNT; form++) {
            lane *l = &r->lanes[r->count];
            if (!(with->structures & (1u << structure)) || !(with->forms & (1u << form)))
                continue;
            l->structure = structure;
            l->form = form;
            r->count++;
            if (!hug_query_make(r->c->built[structure], r->rays->rays, r->rays->count,
                                occlusion(r->set), &l->query))
                return 0;
        }
    }
    r->seconds = (double *)calloc((r->count + 1) * with->rounds, sizeof *r->seconds);
    if (!r->seconds) {
        message("no memory for %u rounds", with->rounds);
        return 0;
    }
    return embree_query_make(r->c->embree.built, r->rays->rays, r->rays->count,
                             occlusion(r->set), &r->embree);
}

static int measure(running *r)
{
    contender contenders[LANES + 1];
    unsigned rounds = r->c->with->rounds;
    size_t i;
    int ok;
    for (i = 0; i < r->count; i++) {
        lane *l = &r->lanes[i];
        l->seconds = contenders[i].seconds = r->seconds + i * rounds;
        hug_query_enter(&l->query, l->form == FORM_STREAM, &contenders[i]);
    }
    contenders[r->count].seconds = r->seconds + r->count * rounds;
    embree_query_enter(&r->embree, &contenders[r->count]);
    ok = rounds_run(ray_set_names[r->set], contenders, r->count + 1, r->rays->count,
                    r->rays->count / 8, rounds, seconds_thread);
    if (ok)
        embree_query_finish(&r->embree);
    return ok;
}

/* A structure's first lane is judged against Embree, and every other lane of any
 * structure must say the same as the very first, bit for bit. */
static int judge(running *r, size_t i, tally *t)
{
    const lane *first = &r->lanes[0], *l = &r->lanes[i];
    int new_structure = i == 0 || l->structure != r->lanes[i - 1].structure;
    trial what;
    what.from = r->c->from;
    what.built = r->c->built[l->structure];
    what.structure = r->c->builds[l->structure].structure;
    what.set = ray_set_names[r->set];
    what.rays = r->rays->rays;
    what.count = r->rays->count;
    if (occlusion(r->set)) {
        judge_same_occlusion(&what, "another form of query, or structure", l->query.occluded,
                             first->query.occluded, t);
        return !new_structure ||
               judge_occlusion(&what, l->query.occluded, r->embree.flags, t);
    }
    judge_same_hits(&what, "another form of query, or structure", l->query.hits,
                    first->query.hits, t);
    return !new_structure || judge_hits(&what, l->query.hits, r->embree.hits, t);
}

/* Medians are taken of copies: they sort, and rounds must stay paired. */
static void figures(running *r, size_t i, query_figures *out)
{
    static const char *const queries[2][FORM_COUNT] = {{"intersect", "intersect_n"},
                                                       {"occluded", "occluded_n"}};
    unsigned round, rounds = r->c->with->rounds;
    const double *embree = r->seconds + r->count * rounds;
    double copy[2][MOST_ROUNDS];
    memset(out, 0, sizeof *out);
    out->set = ray_set_names[r->set];
    out->query = queries[occlusion(r->set)][r->lanes[i].form];
    out->rays = r->rays->count;
    for (round = 0; round < rounds; round++) {
        double ours = r->lanes[i].seconds[round];
        double ratio = ours > 0.0 ? embree[round] / ours : 0.0;
        if (round == 0 || ratio < out->ratio_least)
            out->ratio_least = ratio;
        if (round == 0 || ratio > out->ratio_most)
            out->ratio_most = ratio;
        copy[0][round] = ours;
        copy[1][round] = embree[round];
    }
    out->hug_seconds = median(copy[0], rounds);
    out->embree_seconds = median(copy[1], rounds);
}

static int report(running *r)
{
    size_t i;
    for (i = 0; i < r->count; i++) {
        int structure = r->lanes[i].structure;
        tally *t = &r->c->tallies[structure][r->set];
        query_figures query;
        if (!judge(r, i, t))
            return 0;
        figures(r, i, &query);
        report_line(r->c->with->csv, r->c->from, &r->c->builds[structure], &query, t);
    }
    return 1;
}

int run_set(comparison *c, int set, const ray_set *rays)
{
    running r;
    size_t i;
    int ok;
    memset(&r, 0, sizeof r);
    r.c = c;
    r.set = set;
    r.rays = rays;
    ok = prepare(&r) && measure(&r) && report(&r);
    for (i = 0; i < r.count; i++)
        hug_query_free(&r.lanes[i].query);
    embree_query_free(&r.embree);
    free(r.seconds);
    return ok;
}
