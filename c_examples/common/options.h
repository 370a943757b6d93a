/* The command line: options "--name VALUE" or "--name=VALUE", and flags "--name".
 * Functions return 1, or 0 after a message that says what is wrong. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stddef.h>

typedef struct {
    const char *name;   /* with its two dashes */
    const char **value; /* receives the value, or NULL for a flag */
    int *flag;          /* becomes 1, or NULL for an option with a value */
} option;

int options_parse(int argc, char **argv, const option *table, size_t count);

/* A whole number from least to most. */
int parse_count(const char *name, const char *text, unsigned long least, unsigned long most,
                unsigned long *out);

/* Exactly count finite numbers separated by commas. */
int parse_floats(const char *name, const char *text, float *out, size_t count);

/* One of the names: *out is its place. */
int parse_one(const char *name, const char *text, const char *const *names, size_t count,
              unsigned *out);

/* A comma-separated choice of names, or "all" for every one: bit i is names[i]. */
int parse_choice(const char *name, const char *text, const char *const *names, size_t count,
                 unsigned *out);

#endif
