/* One ray set through hug, in one form and on one instruction set. */
#ifndef HUG_QUERY_H
#define HUG_QUERY_H

#include "compare/answers.h"
#include "compare/rounds.h"

typedef struct {
    const hug_scene *built;
    const hug_ray *rays;
    const char *isa;
    answers *out; /* of the last run; its kind says what is asked */
} hug_query;

/* What rounds_run times: a call a ray, or one call for all of them. The instruction
 * set is chosen before each run, for all queries of the process. */
void hug_query_enter(hug_query *q, int stream, contender *out);

#endif
