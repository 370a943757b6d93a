#include "compare/run_set.h"

#include <stdlib.h>
#include <string.h>

#include "clocks.h"
#include "compare/judge.h"
#include "compare/lanes.h"
#include "compare/report.h"
#include "message.h"

static int measure(lane_set *l)
{
    contender contenders[MOST_LANES + PEER_COUNT];
    const settings *with = l->c->with;
    size_t count = l->count + l->rival_count, i;
    l->seconds = (double *)calloc(count * with->rounds, sizeof *l->seconds);
    if (!l->seconds) {
        message("no memory for %u rounds", with->rounds);
        return 0;
    }
    lanes_enter(l, contenders);
    for (i = 0; i < count; i++) {
        contenders[i].seconds = l->seconds + i * with->rounds;
        contenders[i].wall = NULL;
    }
    return rounds_run(ray_set_names[l->set], contenders, count, l->rays->count,
                      l->rays->count / 8, with->rounds, seconds_thread);
}

/* The first answers against the reference. All other lanes gave the same bits, or
 * failed already, so that the verdicts are those of every structure. */
static int judge(lane_set *l)
{
    tally verdicts;
    trial what = lanes_trial(l, &l->lanes[0]);
    int structure, ok;
    memset(&verdicts, 0, sizeof verdicts);
    ok = l->first.hits ? judge_hits(&what, l->first.hits, l->reference.hits, &verdicts)
                       : judge_occlusion(&what, l->first.occluded, l->reference.occluded,
                                         &verdicts);
    for (structure = 0; structure < COMPARED_COUNT; structure++) {
        tally *t = &l->c->tallies[structure][l->set];
        if (!l->c->built[structure])
            continue;
        memcpy(t->found, verdicts.found, sizeof t->found);
        memcpy(t->decided, verdicts.decided, sizeof t->decided);
    }
    return ok;
}

/* Medians are taken of copies: they sort, and rounds must stay paired. */
static void fill_times(const lane_set *l, size_t contender_at, query_row *row)
{
    unsigned round, rounds = l->c->with->rounds;
    const double *own = l->seconds + contender_at * rounds;
    const double *reference = l->seconds + l->count * rounds;
    double copy[2][MOST_ROUNDS];
    for (round = 0; round < rounds; round++) {
        double ratio = ratio_of(reference[round], own[round]);
        if (round == 0 || ratio < row->ratio_least)
            row->ratio_least = ratio;
        if (round == 0 || ratio > row->ratio_most)
            row->ratio_most = ratio;
    }
    memcpy(copy[0], own, rounds * sizeof *own);
    memcpy(copy[1], reference, rounds * sizeof *own);
    row->seconds = median(copy[0], rounds);
    row->reference = median(copy[1], rounds);
}

static query_row new_row(const lane_set *l, const char *name)
{
    const comparison *c = l->c;
    query_row row;
    memset(&row, 0, sizeof row);
    memcpy(row.scene, c->from->name, sizeof row.scene);
    strncat(row.view, c->view_name, sizeof row.view - 1);
    row.triangles = c->from->triangle_count;
    row.rays = l->rays->count;
    row.set = l->set;
    row.name = name;
    row.isa = "";
    return row;
}

static int keep(const lane_set *l, const query_row *row, const build_row *build)
{
    report_query(l->c, row, build);
    return results_add_query(l->c->found, row);
}

static int report(const lane_set *l)
{
    comparison *c = l->c;
    size_t i;
    for (i = 0; i < l->count; i++) {
        const lane *from = &l->lanes[i];
        query_row row = new_row(l, c->builds[from->structure].name);
        row.stream = from->stream;
        row.isa = from->query.isa;
        memcpy(row.found, c->tallies[from->structure][l->set].found, sizeof row.found);
        fill_times(l, i, &row);
        if (!keep(l, &row, &c->builds[from->structure]))
            return 0;
    }
    /* the reference itself is in every row */
    for (i = 1; i < l->rival_count; i++) {
        const rival *from = &l->rivals[i];
        query_row row = new_row(l, peers[from->peer].name);
        row.peer = 1;
        memcpy(row.found, from->differs.found, sizeof row.found);
        fill_times(l, l->count + i, &row);
        if (!keep(l, &row, &c->peer_builds[peers[from->peer].build]))
            return 0;
    }
    return 1;
}

int run_set(comparison *c, int set, const ray_set *rays)
{
    lane_set *l = (lane_set *)calloc(1, sizeof *l);
    int ok;
    if (!l) {
        message("no memory for %s rays", ray_set_names[set]);
        return 0;
    }
    l->c = c;
    l->set = set;
    l->rays = rays;
    ok = lanes_make(l) && measure(l) && judge(l) && report(l);
    free(l->seconds);
    lanes_free(l);
    free(l);
    return ok;
}
