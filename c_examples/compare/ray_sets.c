#include "compare/ray_sets.h"

#include <stdlib.h>
#include <string.h>

#include "message.h"

const char *const ray_set_names[RAY_SET_COUNT] = {"primary", "shadow", "bounce1", "bounce2",
                                                  "random"};

/* The kit's rays and hits are hug's, byte for byte. */
typedef char same_ray[sizeof(kit_ray) == sizeof(hug_ray) ? 1 : -1];
typedef char same_hit[sizeof(kit_hit) == sizeof(hug_hit) ? 1 : -1];

typedef struct {
    const hug_scene *built;
    const kit_box *bounds;
    const kit_view *view;
    uint32_t size;
    ray_set *sets;
    hug_hit *primary_hits, *bounce_hits;
} maker;

static int reserve(ray_set *set, size_t count)
{
    set->count = count;
    set->rays = (hug_ray *)malloc(count * sizeof *set->rays + 1);
    if (!set->rays)
        message("no memory for %lu rays", (unsigned long)count);
    return set->rays != NULL;
}

static int checked(const char *what, kit_status status)
{
    if (status != KIT_OK)
        message("%s rays: %s", what, kit_status_string(status));
    return status == KIT_OK;
}

/* hug's hits of a set, or NULL after a message. */
static hug_hit *hits_of(const hug_scene *built, const ray_set *set)
{
    hug_hit *hits = (hug_hit *)malloc(set->count * sizeof *hits + 1);
    progress bar;
    size_t i, chunk = 4096;
    if (!hits) {
        message("no memory for %lu hits", (unsigned long)set->count);
        return NULL;
    }
    progress_start(&bar, "making rays", set->count);
    for (i = 0; i < set->count; i += chunk) {
        size_t n = set->count - i < chunk ? set->count - i : chunk;
        hug_intersect_n(built, set->rays + i, 0, hits + i, 0, n);
        progress_at(&bar, i + n);
    }
    progress_end(&bar);
    return hits;
}

static int make_primary(maker *m)
{
    ray_set *set = &m->sets[RAYS_PRIMARY];
    size_t written;
    if (!reserve(set, kit_primary_count(m->size)) ||
        !checked("primary", kit_rays_primary(m->view, m->size, (kit_ray *)set->rays, set->count,
                                             &written)))
        return 0;
    m->primary_hits = hits_of(m->built, set);
    return m->primary_hits != NULL;
}

static int make_shadow(maker *m)
{
    ray_set *set = &m->sets[RAYS_SHADOW];
    const kit_ray *from = (const kit_ray *)m->sets[RAYS_PRIMARY].rays;
    const kit_hit *hits = (const kit_hit *)m->primary_hits;
    size_t written;
    return reserve(set, kit_shadow_count(m->size, hits)) &&
           checked("shadow", kit_rays_shadow(m->bounds, m->size, from, hits,
                                             (kit_ray *)set->rays, set->count, &written));
}

static int make_bounce(maker *m, uint32_t number, const ray_set *from, const hug_hit *hits,
                       ray_set *set)
{
    size_t written;
    return reserve(set, kit_bounce_count((const kit_hit *)hits, from->count)) &&
           checked("bounce", kit_rays_bounce(number, m->bounds, (const kit_ray *)from->rays,
                                             (const kit_hit *)hits, from->count,
                                             (kit_ray *)set->rays, set->count, &written));
}

static int make_bounces(maker *m, int second)
{
    ray_set *first = &m->sets[RAYS_BOUNCE1];
    if (!make_bounce(m, 1, &m->sets[RAYS_PRIMARY], m->primary_hits, first))
        return 0;
    if (!second)
        return 1;
    m->bounce_hits = hits_of(m->built, first);
    return m->bounce_hits && make_bounce(m, 2, first, m->bounce_hits, &m->sets[RAYS_BOUNCE2]);
}

static int make_random(maker *m)
{
    ray_set *set = &m->sets[RAYS_RANDOM];
    size_t count = (size_t)m->size * m->size;
    return reserve(set, count < KIT_RANDOM_COUNT ? count : KIT_RANDOM_COUNT) &&
           checked("random", kit_rays_random(m->bounds, (kit_ray *)set->rays, set->count));
}

int ray_sets_make(const hug_scene *built, const kit_box *bounds, const kit_view *view,
                  uint32_t size, unsigned wanted, ray_set out[RAY_SET_COUNT])
{
    maker m;
    int ok = 1;
    memset(&m, 0, sizeof m);
    memset(out, 0, RAY_SET_COUNT * sizeof *out);
    m.built = built;
    m.bounds = bounds;
    m.view = view;
    m.size = size;
    m.sets = out;
    /* every set but the random one starts from the primary hits */
    if (wanted & ~(1u << RAYS_RANDOM))
        ok = make_primary(&m);
    if (ok && (wanted & (1u << RAYS_SHADOW)))
        ok = make_shadow(&m);
    if (ok && (wanted & (1u << RAYS_BOUNCE1 | 1u << RAYS_BOUNCE2)))
        ok = make_bounces(&m, (wanted & (1u << RAYS_BOUNCE2)) != 0);
    if (ok && (wanted & (1u << RAYS_RANDOM)))
        ok = make_random(&m);
    free(m.primary_hits);
    free(m.bounce_hits);
    return ok;
}

void ray_sets_free(ray_set sets[RAY_SET_COUNT])
{
    int i;
    for (i = 0; i < RAY_SET_COUNT; i++)
        free(sets[i].rays);
    memset(sets, 0, RAY_SET_COUNT * sizeof *sets);
}
