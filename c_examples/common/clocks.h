/* Clocks, and the median that is taken of what they say. */
#ifndef CLOCKS_H
#define CLOCKS_H

#include <stddef.h>

double seconds_wall(void);
/* CPU time of the calling thread: for queries, which use no other. */
double seconds_thread(void);
/* CPU time of all threads: for builds, which might. */
double seconds_process(void);

/* Sorts the values; the mean of the middle two for an even count, 0 for none. */
double median(double *values, size_t count);

#endif
