#include "compare/decisions.h"

#include <string.h>

#include "hug_kit.h"

static void put(FILE *to, const char *structure, const char *set, const char *what, size_t found,
                const size_t decided[3])
{
    if (found)
        fprintf(to, "%-10s %-8s %-20s %9lu %16lu %9lu %9lu\n", structure, set, what,
                (unsigned long)found, (unsigned long)decided[KIT_OURS],
                (unsigned long)decided[KIT_BOTH], (unsigned long)decided[KIT_THEIRS]);
}

static void put_tally(FILE *to, const char *structure, const char *set, const tally *t)
{
    static const char *const names[CLASS_COUNT] = {"hit or miss", "t", "triangle, same t"};
    size_t own[3];
    int i;
    for (i = 0; i < CLASS_COUNT; i++)
        put(to, structure, set, names[i], t->found[i], t->decided[i]);
    memset(own, 0, sizeof own);
    own[KIT_THEIRS] = t->inconsistent;
    put(to, structure, set, "hug from itself", t->inconsistent, own);
}

size_t print_decisions(FILE *to, const comparison *c)
{
    int set, structure;
    size_t found = 0, wrong = 0;
    for (set = 0; set < RAY_SET_COUNT; set++) {
        for (structure = 0; structure < COMPARED_COUNT; structure++) {
            found += tally_found(&c->tallies[structure][set]);
            wrong += tally_wrong(&c->tallies[structure][set]);
        }
    }
    if (!found)
        fprintf(to, "\n%s, %s: the two agree on every ray, but for t within 1e-4\n",
                c->from->name, c->view_name);
    else
        fprintf(to,
                "\n%s, %s: differences, decided by exact arithmetic; of equal t the lowest id "
                "is right\n%-10s %-8s %-20s %9s %16s %9s %9s\n",
                c->from->name, c->view_name, "structure", "rays", "difference", "number",
                "only hug right", "both", "hug wrong");
    for (set = 0; set < RAY_SET_COUNT; set++)
        for (structure = 0; structure < COMPARED_COUNT; structure++)
            if (c->built[structure])
                put_tally(to, c->builds[structure].name, ray_set_names[set],
                          &c->tallies[structure][set]);
    return wrong;
}
