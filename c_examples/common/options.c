#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"

static const option *find(const char *argument, size_t length, const option *table, size_t count)
{
    size_t i;
    for (i = 0; i < count; i++)
        if (strlen(table[i].name) == length && strncmp(table[i].name, argument, length) == 0)
            return &table[i];
    return NULL;
}

int options_parse(int argc, char **argv, const option *table, size_t count)
{
    int i;
    for (i = 1; i < argc; i++) {
        const char *equals = strchr(argv[i], '=');
        size_t length = equals ? (size_t)(equals - argv[i]) : strlen(argv[i]);
        const option *found = find(argv[i], length, table, count);
        if (!found) {
            message("unknown option %s (--help lists them)", argv[i]);
            return 0;
        }
        if (found->flag && equals) {
            message("%s takes no value", found->name);
            return 0;
        }
        if (found->flag) {
            *found->flag = 1;
        } else if (equals) {
            *found->value = equals + 1;
        } else if (i + 1 < argc) {
            *found->value = argv[++i];
        } else {
            message("%s needs a value", found->name);
            return 0;
        }
    }
    return 1;
}

int parse_count(const char *name, const char *text, unsigned long least, unsigned long most,
                unsigned long *out)
{
    char *end;
    unsigned long value;
    errno = 0;
    value = strtoul(text, &end, 10);
    /* strtoul takes signs and spaces too: the first character must be a digit */
    if (*text < '0' || *text > '9' || *end != '\0' || errno || value < least || value > most) {
        message("%s %s: not a whole number from %lu to %lu", name, text, least, most);
        return 0;
    }
    *out = value;
    return 1;
}

int parse_floats(const char *name, const char *text, float *out, size_t count)
{
    const char *at = text;
    size_t i;
    for (i = 0; i < count; i++) {
        char *end;
        double value = strtod(at, &end);
        char expected = i + 1 < count ? ',' : '\0';
        out[i] = (float)value;
        if (end == at || *end != expected || !isfinite(out[i])) {
            message("%s %s: not %u finite numbers separated by commas", name, text,
                    (unsigned)count);
            return 0;
        }
        at = end + 1;
    }
    return 1;
}

/* how: what the text must be, before the names. */
static void list_names(const char *name, const char *text, const char *how,
                       const char *const *names, size_t count)
{
    char list[256] = "";
    size_t i;
    for (i = 0; i < count; i++) {
        strncat(list, i ? ", " : " ", sizeof list - strlen(list) - 1);
        strncat(list, names[i], sizeof list - strlen(list) - 1);
    }
    message("%s %s: must be %s%s", name, text, how, list);
}

/* The place of the name of this length, or count. */
static size_t place_of(const char *text, size_t length, const char *const *names, size_t count)
{
    size_t i = 0;
    while (i < count && (strlen(names[i]) != length || strncmp(names[i], text, length) != 0))
        i++;
    return i;
}

int parse_one(const char *name, const char *text, const char *const *names, size_t count,
              unsigned *out)
{
    size_t place = place_of(text, strlen(text), names, count);
    if (place == count) {
        list_names(name, text, "one of", names, count);
        return 0;
    }
    *out = (unsigned)place;
    return 1;
}

int parse_choice(const char *name, const char *text, const char *const *names, size_t count,
                 unsigned *out)
{
    const char *at = text;
    *out = 0;
    if (strcmp(text, "all") == 0) {
        *out = (1u << count) - 1;
        return 1;
    }
    for (;;) {
        size_t length = strcspn(at, ","), place = place_of(at, length, names, count);
        if (place == count) {
            list_names(name, text, "\"all\", or some of these with commas between them:", names,
                       count);
            return 0;
        }
        *out |= 1u << place;
        if (at[length] == '\0')
            return 1;
        at += length + 1;
    }
}
