/* The instruction sets that hug is timed on, one after the other in every round. */
#ifndef ISAS_H
#define ISAS_H

#include <stddef.h>

#define MOST_ISAS 8

typedef struct {
    char names[MOST_ISAS][16];
    size_t count;
} isa_list;

/* Names separated by commas, each of which must run on this processor; NULL for the
 * one that the library chooses. Returns 1, or 0 after a message. */
int isas_read(const char *text, isa_list *out);

#endif
