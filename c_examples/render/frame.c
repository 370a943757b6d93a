#include "frame.h"

#include <stdlib.h>
#include <string.h>

#include "clocks.h"
#include "message.h"

/* Rays between two looks at the clock. */
#define CHUNK 4096u

/* The kit's rays and hits are hug's, byte for byte. */
typedef char same_ray[sizeof(kit_ray) == sizeof(hug_ray) ? 1 : -1];
typedef char same_hit[sizeof(kit_hit) == sizeof(hug_hit) ? 1 : -1];

static int make_rays(const kit_view *view, frame *f)
{
    size_t written;
    kit_status status =
        kit_rays_primary(view, f->size, (kit_ray *)f->rays, f->count, &written);
    if (status == KIT_OK)
        status = kit_primary_pixels(f->size, f->xy, 2 * f->count, &written);
    if (status != KIT_OK) {
        message("the view's rays: %s", kit_status_string(status));
        return 0;
    }
    return 1;
}

static void trace(const hug_scene *built, frame *f)
{
    progress bar;
    size_t i;
    progress_start(&bar, "tracing", f->count);
    for (i = 0; i < f->count; i += CHUNK) {
        size_t n = f->count - i < CHUNK ? f->count - i : CHUNK;
        double start = seconds_thread();
        hug_intersect_n(built, f->rays + i, 0, f->hits + i, 0, n);
        f->seconds += seconds_thread() - start;
        progress_at(&bar, i + n);
    }
    progress_end(&bar);
}

/* Returns 0 if a counted query does not return the hit of the plain one. */
static int count_steps(const hug_scene *built, frame *f)
{
    progress bar;
    size_t i;
    progress_start(&bar, "counting steps", f->count);
    for (i = 0; i < f->count; i++) {
        hug_counters counters;
        hug_hit hit;
        memset(&counters, 0, sizeof counters);
        hug_intersect_counted(built, &f->rays[i], &hit, &counters);
        if (memcmp(&hit, &f->hits[i], sizeof hit) != 0) {
            progress_end(&bar);
            message("ray %lu: the counted query and the plain one differ", (unsigned long)i);
            return 0;
        }
        f->steps[i] = counters.voxels < 0xffffffffu ? (uint32_t)counters.voxels : 0xffffffffu;
        if (i % CHUNK == 0)
            progress_at(&bar, i);
    }
    progress_end(&bar);
    return 1;
}

int frame_trace(const hug_scene *built, const kit_view *view, uint32_t size, frame *out)
{
    memset(out, 0, sizeof *out);
    out->size = size;
    out->count = kit_primary_count(size);
    out->rays = (hug_ray *)malloc(out->count * sizeof *out->rays);
    out->xy = (uint32_t *)malloc(2 * out->count * sizeof *out->xy);
    out->hits = (hug_hit *)malloc(out->count * sizeof *out->hits);
    out->steps = (uint32_t *)malloc(out->count * sizeof *out->steps);
    if (!out->rays || !out->xy || !out->hits || !out->steps) {
        message("no memory for %lu rays", (unsigned long)out->count);
        return 0;
    }
    if (!make_rays(view, out))
        return 0;
    trace(built, out);
    return count_steps(built, out);
}

void frame_free(frame *f)
{
    free(f->rays);
    free(f->xy);
    free(f->hits);
    free(f->steps);
    memset(f, 0, sizeof *f);
}
