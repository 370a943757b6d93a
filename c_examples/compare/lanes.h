/* Who takes part in timing one ray set: lanes are hug's, rivals are Embree's. */
#ifndef LANES_H
#define LANES_H

#include "compare/comparison.h"
#include "compare/embree_query.h"
#include "compare/hug_query.h"

#define MOST_LANES (COMPARED_COUNT * 2 * MOST_ISAS)

struct lane_set;

/* One structure in one form on one instruction set. */
typedef struct {
    struct lane_set *of;
    int structure, stream;
    char label[64];
    hug_query query;
} lane;

/* One of PEER_*. */
typedef struct {
    struct lane_set *of;
    int peer;
    embree_query query;
    tally differs; /* from hug */
} rival;

typedef struct lane_set {
    comparison *c;
    int set;
    const ray_set *rays;
    lane lanes[MOST_LANES];
    size_t count;
    rival rivals[PEER_COUNT]; /* the reference first */
    size_t rival_count;
    embree_records records; /* of the rival that runs */
    answers latest;         /* of whoever runs */
    answers first;          /* hug's, which all other lanes must give again */
    answers reference;      /* Embree's, which are judged */
    int first_known;
    double *seconds; /* of all, lanes first */
} lane_set;

/* Takes in all that the settings ask of the set. Returns 1, or 0 after a message. Free
 * in both cases. */
int lanes_make(lane_set *l);
void lanes_free(lane_set *l);

/* All as contenders, lanes first. After each run its answers are compared. */
void lanes_enter(lane_set *l, contender *out);

trial lanes_trial(const lane_set *l, const lane *of);

#endif
