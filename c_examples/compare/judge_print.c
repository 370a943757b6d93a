#include "compare/judge_print.h"

#include "message.h"

static int print_ray(const trial *what, size_t nth, const char *why, size_t ray)
{
    const hug_ray *r = &what->rays[ray];
    if (nth == PRINT_MOST)
        message("%s, %s rays: more of these, not printed; the counts have them all",
                what->structure, what->set);
    if (nth >= PRINT_MOST)
        return 0;
    message("%s: %s, %s rays, ray %lu: %s", what->from->name, what->structure, what->set,
            (unsigned long)ray, why);
    message("  org %a %a %a  tmin %a", r->org[0], r->org[1], r->org[2], r->tmin);
    message("  dir %a %a %a  tmax %a", r->dir[0], r->dir[1], r->dir[2], r->tmax);
    return 1;
}

static void print_hit(const trial *what, const char *who, const hug_hit *hit)
{
    const scene *s = what->from;
    int corner;
    if (hit->geom == HUG_NONE) {
        message("  %s: miss", who);
        return;
    }
    message("  %s: geometry %lu, primitive %lu, t %a (%.9g), u %a, v %a", who,
            (unsigned long)hit->geom, (unsigned long)hit->prim, hit->t, hit->t, hit->u, hit->v);
    for (corner = 0; corner < 3 && hit->prim < s->triangle_count; corner++) {
        const float *p = s->vertices + 3 * (size_t)s->indices[3 * (size_t)hit->prim + corner];
        message("    v%d %a %a %a", corner, p[0], p[1], p[2]);
    }
}

void print_hits(const trial *what, size_t nth, const char *why, size_t ray, const hug_hit *ours,
                const char *other, const hug_hit *theirs)
{
    if (!print_ray(what, nth, why, ray))
        return;
    print_hit(what, "hug", ours);
    print_hit(what, other, theirs);
}

void print_occlusion(const trial *what, size_t nth, const char *why, size_t ray, int ours,
                     const char *other, int theirs)
{
    if (!print_ray(what, nth, why, ray))
        return;
    message("  hug: %s", ours ? "occluded" : "free");
    message("  %s: %s", other, theirs ? "occluded" : "free");
}
