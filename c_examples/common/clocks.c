#define _POSIX_C_SOURCE 200809L
#include "clocks.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(clockid_t clock)
{
    struct timespec time;
    if (clock_gettime(clock, &time) != 0) {
        /* figures from a clock that does not run would be worse than none */
        perror("clock_gettime");
        exit(2);
    }
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

double seconds_wall(void)
{
    return now(CLOCK_MONOTONIC);
}

double seconds_thread(void)
{
    return now(CLOCK_THREAD_CPUTIME_ID);
}

double seconds_process(void)
{
    return now(CLOCK_PROCESS_CPUTIME_ID);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double median(double *values, size_t count)
{
    if (count == 0)
        return 0.0;
    qsort(values, count, sizeof *values, ascending);
    return count % 2 ? values[count / 2] : 0.5 * (values[count / 2 - 1] + values[count / 2]);
}
