/* The five ray sets, from the kit; the hits that rays start on are hug's. */
#ifndef RAY_SETS_H
#define RAY_SETS_H

#include <stddef.h>
#include <stdint.h>

#include "hug.h"
#include "hug_kit.h"

enum { RAYS_PRIMARY, RAYS_SHADOW, RAYS_BOUNCE1, RAYS_BOUNCE2, RAYS_RANDOM, RAY_SET_COUNT };

extern const char *const ray_set_names[RAY_SET_COUNT];

typedef struct {
    hug_ray *rays;
    size_t count;
} ray_set;

/* Makes the wanted sets (bit i: set i), each the same whether the others are
 * wanted or not. Returns 1, or 0 after a message. Free in both cases. */
int ray_sets_make(const hug_scene *built, const kit_box *bounds, const kit_view *view,
                  uint32_t size, unsigned wanted, ray_set out[RAY_SET_COUNT]);
void ray_sets_free(ray_set sets[RAY_SET_COUNT]);

#endif
