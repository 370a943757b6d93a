#include "compare/lanes.h"

#include <stdio.h>
#include <string.h>

#include "structures.h"

static void add_lane(lane_set *l, int structure, int stream, const char *isa)
{
    lane *added = &l->lanes[l->count++];
    added->of = l;
    added->structure = structure;
    added->stream = stream;
    added->query.built = l->c->built[structure];
    added->query.rays = l->rays->rays;
    added->query.isa = isa;
    added->query.out = &l->latest;
    snprintf(added->label, sizeof added->label, "%s, %s, %s", structure_names[structure],
             query_name(l->set, stream), isa);
}

static void add_rival(lane_set *l, int which)
{
    rival *added = &l->rivals[l->rival_count++];
    added->of = l;
    added->peer = which;
    added->query.built = l->c->embree[peers[which].build].built;
    added->query.width = peers[which].width;
    /* rays of a tile, and those from it to the same lights; bounces go anywhere */
    added->query.coherent =
        peers[which].width > 1 && (l->set == RAYS_PRIMARY || l->set == RAYS_SHADOW);
    added->query.rays = l->rays->rays;
    added->query.records = &l->records;
}

int lanes_make(lane_set *l)
{
    const settings *with = l->c->with;
    int occlusion = l->set == RAYS_SHADOW, structure, stream, which;
    size_t isa;
    for (structure = 0; structure < COMPARED_COUNT; structure++)
        for (stream = 0; stream < 2; stream++)
            for (isa = 0; isa < with->isas.count; isa++)
                if (l->c->built[structure] && settings_asks(with, l->set, stream))
                    add_lane(l, structure, stream, with->isas.names[isa]);
    for (which = 0; which < PEER_COUNT; which++)
        if (with->peers & (1u << which))
            add_rival(l, which);
    return embree_records_make(l->rays->count, occlusion, &l->records) &&
           answers_make(l->rays->count, occlusion, &l->latest) &&
           answers_make(l->rays->count, occlusion, &l->first) &&
           answers_make(l->rays->count, occlusion, &l->reference);
}

void lanes_free(lane_set *l)
{
    embree_records_free(&l->records);
    answers_free(&l->latest);
    answers_free(&l->first);
    answers_free(&l->reference);
}

trial lanes_trial(const lane_set *l, const lane *of)
{
    trial what;
    what.from = l->c->from;
    what.built = of->query.built;
    what.structure = of->label;
    what.set = ray_set_names[l->set];
    what.rays = l->rays->rays;
    what.count = l->rays->count;
    return what;
}

static int lane_finish(void *owner, unsigned round)
{
    lane *from = (lane *)owner;
    lane_set *l = from->of;
    trial what = lanes_trial(l, from);
    (void)round;
    if (l->first_known)
        differences_within(&what, l->lanes[0].label, &l->latest, &l->first,
                           &l->c->tallies[from->structure][l->set]);
    else
        answers_copy(&l->first, &l->latest);
    l->first_known = 1;
    return 1;
}

static int rival_finish(void *owner, unsigned round)
{
    rival *from = (rival *)owner;
    lane_set *l = from->of;
    if (round > 0)
        return 1;
    if (from->peer == PEER_REFERENCE) {
        embree_query_answers(&from->query, &l->reference);
    } else {
        embree_query_answers(&from->query, &l->latest);
        differences_count(&l->first, &l->latest, &from->differs);
    }
    return 1;
}

void lanes_enter(lane_set *l, contender *out)
{
    size_t i;
    for (i = 0; i < l->count; i++, out++) {
        hug_query_enter(&l->lanes[i].query, l->lanes[i].stream, out);
        out->finish = lane_finish;
        out->owner = &l->lanes[i];
    }
    for (i = 0; i < l->rival_count; i++, out++) {
        embree_query_enter(&l->rivals[i].query, out);
        out->finish = rival_finish;
        out->owner = &l->rivals[i];
    }
}
