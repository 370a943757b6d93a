#include "compare/isas.h"

#include <stdio.h>
#include <string.h>

#include "hug.h"
#include "message.h"

/* Whether the library takes the name; *chosen is what it goes back to. */
static int runs(const char *name, const char *chosen)
{
    if (hug_force_isa(name) != HUG_OK)
        return 0;
    hug_force_isa(chosen);
    return 1;
}

static int add(const char *name, size_t length, const char *chosen, isa_list *out)
{
    char *place = out->names[out->count];
    size_t i;
    if (out->count == MOST_ISAS) {
        message("--isa: more than %d names", MOST_ISAS);
        return 0;
    }
    snprintf(place, sizeof out->names[0], "%.*s", (int)length, name);
    if (strlen(place) != length || !runs(place, chosen)) {
        message("--isa %.*s: unknown, or not of this processor; without it: %s", (int)length,
                name, chosen);
        return 0;
    }
    for (i = 0; i < out->count; i++) {
        if (strcmp(out->names[i], place) == 0) {
            message("--isa %s: named twice", place);
            return 0;
        }
    }
    out->count++;
    return 1;
}

int isas_read(const char *text, isa_list *out)
{
    const char *chosen = hug_isa();
    memset(out, 0, sizeof *out);
    if (!text)
        return add(chosen, strlen(chosen), chosen, out);
    for (;;) {
        size_t length = strcspn(text, ",");
        if (!add(text, length, chosen, out))
            return 0;
        if (text[length] == '\0')
            return 1;
        text += length + 1;
    }
}
