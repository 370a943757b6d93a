#include "abi/check.h"

#include <stdio.h>

static unsigned count, failures;

void check_status(const char *file, int line, const char *call, hug_status got,
                  hug_status expected)
{
    count++;
    if (got == expected)
        return;
    failures++;
    fprintf(stderr, "%s:%d: %s: got %d (%s), expected %d (%s)\n", file, line, call, (int)got,
            hug_status_string(got), (int)expected, hug_status_string(expected));
}

int check_true(const char *file, int line, const char *text, int condition)
{
    count++;
    if (!condition) {
        failures++;
        fprintf(stderr, "%s:%d: not true: %s\n", file, line, text);
    }
    return condition;
}

unsigned check_count(void)
{
    return count;
}

unsigned check_failures(void)
{
    return failures;
}
