#include "compare/rounds.h"

#include "clocks.h"
#include "message.h"

static int run_one(contender *c, size_t n, double (*clock)(void), double *seconds, double *wall)
{
    double start, wall_start;
    int ok;
    if (c->prepare && !c->prepare(c->self))
        return 0;
    wall_start = seconds_wall();
    start = clock();
    ok = c->run(c->self, n);
    *seconds = clock() - start;
    *wall = seconds_wall() - wall_start;
    return ok;
}

static int run_round(contender *c, size_t n, double (*clock)(void), unsigned round)
{
    double wall;
    if (!run_one(c, n, clock, &c->seconds[round], &wall))
        return 0;
    if (c->wall)
        c->wall[round] = wall;
    return !c->finish || c->finish(c->owner, round);
}

static size_t common_divisor(size_t a, size_t b)
{
    while (b) {
        size_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* From one contender to the next, in steps that reach all: a mere rotation would let
 * each always follow the same other, and find what that one left in the caches. */
static size_t step_after(size_t step, size_t count)
{
    do
        step = step < count ? step + 1 : 1;
    while (common_divisor(count, step) != 1);
    return step;
}

int rounds_run(const char *label, contender *contenders, size_t count, size_t n, size_t warm,
               unsigned rounds, double (*clock)(void))
{
    progress bar;
    size_t i, step = 1;
    unsigned round;
    int ok = 1;
    progress_start(&bar, label, count * rounds);
    for (i = 0; i < count && warm && ok; i++) {
        double seconds, wall;
        ok = run_one(&contenders[i], warm, clock, &seconds, &wall);
    }
    for (round = 0; round < rounds && ok; round++, step = step_after(step, count)) {
        for (i = 0; i < count && ok; i++) {
            ok = run_round(&contenders[(i * step + round) % count], n, clock, round);
            progress_at(&bar, round * count + i + 1);
        }
    }
    progress_end(&bar);
    return ok;
}
