#include "compare/judge.h"

#include <string.h>

#include "compare/judge_print.h"
#include "message.h"

static int arbiter_failed(const trial *what, size_t ray, kit_status status)
{
    message("%s rays, ray %lu: the arbiter: %s", what->set, (unsigned long)ray,
            kit_status_string(status));
    return 0;
}

/* Whether our t is that of exact arithmetic, rounded once: the arbiter on a soup of
 * the one triangle. *out stays as it is if so. */
static int check_t(const trial *what, size_t ray, const hug_hit *ours, kit_verdict *out)
{
    const scene *s = what->from;
    float corners[9];
    kit_soup soup;
    kit_hit exact;
    kit_status status;
    int corner;
    for (corner = 0; corner < 3; corner++) {
        size_t vertex = s->indices[3 * (size_t)ours->prim + corner];
        memcpy(corners + 3 * corner, s->vertices + 3 * vertex, 3 * sizeof(float));
    }
    soup.vertices = corners;
    soup.vertex_count = 3;
    soup.indices = NULL;
    soup.triangle_count = 1;
    status = kit_exact_closest(&soup, (const kit_ray *)&what->rays[ray], &exact);
    if (status != KIT_OK)
        return arbiter_failed(what, ray, status);
    if (exact.geom == KIT_NONE || memcmp(&exact.t, &ours->t, sizeof exact.t) != 0)
        *out = KIT_THEIRS;
    return 1;
}

/* The verdict on two different answers about one ray's closest hit. */
static int decide(const trial *what, size_t ray, const hug_hit *ours, const hug_hit *theirs,
                  kit_verdict *out)
{
    const kit_ray *r = (const kit_ray *)&what->rays[ray];
    kit_soup soup = scene_soup(what->from);
    kit_status status = KIT_OK;
    /* our miss must be one among all triangles, not only beside Embree's */
    if (ours->geom == HUG_NONE)
        status = kit_judge_occluded(&soup, r, 0, 1, out);
    else if (ours->prim == theirs->prim)
        *out = KIT_OURS; /* only t differs, and check_t tells whether ours is exact */
    else
        status = kit_judge_closest(&soup, r, ours->prim, theirs->prim, out);
    if (status != KIT_OK)
        return arbiter_failed(what, ray, status);
    return ours->geom == HUG_NONE || check_t(what, ray, ours, out);
}

int judge_hits(const trial *what, const hug_hit *ours, const hug_hit *theirs, tally *t)
{
    progress bar;
    size_t i, wrong = 0;
    int ok = 1;
    progress_start(&bar, "judging differences", what->count);
    for (i = 0; i < what->count && ok; i++) {
        int class_of = difference_class(&ours[i], &theirs[i]);
        kit_verdict verdict;
        if (class_of == CLASS_COUNT)
            continue;
        t->found[class_of]++;
        ok = decide(what, i, &ours[i], &theirs[i], &verdict);
        if (ok) {
            t->decided[class_of][verdict]++;
            if (verdict == KIT_THEIRS)
                print_hits(what, wrong++, "decided against hug", i, &ours[i], "Embree",
                           &theirs[i]);
        }
        progress_at(&bar, i);
    }
    progress_end(&bar);
    return ok;
}

static int decide_occlusion(const trial *what, size_t ray, int ours, kit_verdict *out)
{
    const kit_ray *r = (const kit_ray *)&what->rays[ray];
    kit_soup soup = scene_soup(what->from);
    hug_hit hit;
    kit_status status;
    if (!ours) {
        status = kit_judge_occluded(&soup, r, 0, 1, out);
    } else if (hug_intersect(what->built, &what->rays[ray], &hit)) {
        /* the occluder that hug names is proof enough, and quicker than all triangles */
        status = kit_judge_closest(&soup, r, hit.prim, KIT_NONE, out);
    } else {
        *out = KIT_THEIRS; /* hug contradicts itself */
        status = KIT_OK;
    }
    return status == KIT_OK || arbiter_failed(what, ray, status);
}

int judge_occlusion(const trial *what, const uint8_t *ours, const uint8_t *theirs, tally *t)
{
    progress bar;
    size_t i, wrong = 0;
    int ok = 1;
    progress_start(&bar, "judging differences", what->count);
    for (i = 0; i < what->count && ok; i++) {
        kit_verdict verdict;
        if (!ours[i] == !theirs[i])
            continue;
        t->found[CLASS_HIT]++;
        ok = decide_occlusion(what, i, ours[i], &verdict);
        if (ok) {
            t->decided[CLASS_HIT][verdict]++;
            if (verdict == KIT_THEIRS)
                print_occlusion(what, wrong++, "decided against hug", i, ours[i], "Embree",
                                theirs[i]);
        }
        progress_at(&bar, i);
    }
    progress_end(&bar);
    return ok;
}
