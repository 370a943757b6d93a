#include "compare/rounds.h"

#include "message.h"

static int run_one(contender *c, size_t n, double (*clock)(void), double *seconds)
{
    double start;
    int ok;
    if (c->prepare)
        c->prepare(c->self);
    start = clock();
    ok = c->run(c->self, n);
    *seconds = clock() - start;
    return ok;
}

int rounds_run(const char *label, contender *contenders, size_t count, size_t n, size_t warm,
               unsigned rounds, double (*clock)(void))
{
    progress bar;
    size_t i;
    unsigned round;
    int ok = 1;
    progress_start(&bar, label, count * rounds);
    for (i = 0; i < count && warm && ok; i++) {
        double unused;
        ok = run_one(&contenders[i], warm, clock, &unused);
    }
    for (round = 0; round < rounds && ok; round++) {
        for (i = 0; i < count && ok; i++) {
            contender *c = &contenders[(i + round) % count];
            ok = run_one(c, n, clock, &c->seconds[round]);
            progress_at(&bar, round * count + i + 1);
        }
    }
    progress_end(&bar);
    return ok;
}
