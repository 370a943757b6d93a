#include "picture.h"

#include <errno.h>
#include <math.h>
#include <stb_image_write.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"

const char *const picture_names[PICTURE_COUNT] = {"shaded", "depth", "steps"};

typedef struct {
    double near_log, far_log; /* depth */
    float to_light[3];        /* shaded: of length 1 */
    uint32_t steps_max;       /* steps: at least 1 */
} scale;

static double dot(const float a[3], const float b[3])
{
    return (double)a[0] * b[0] + (double)a[1] * b[1] + (double)a[2] * b[2];
}

static unsigned char byte(double value)
{
    if (!(value > 0.0))
        return 0;
    return value < 1.0 ? (unsigned char)(value * 255.0 + 0.5) : 255;
}

/* From the eye, and from a light above it to the right, whose cosine is stretched
 * over the whole sphere so that no face is black. */
static void shade(const hug_ray *ray, const hug_hit *hit, const float to_light[3],
                  unsigned char rgb[3])
{
    double length = sqrt(dot(hit->ng, hit->ng)), dir_length = sqrt(dot(ray->dir, ray->dir));
    double eye = 0.0, light = 0.0, bright;
    if (hit->geom == HUG_NONE) {
        rgb[0] = 46;
        rgb[1] = 58;
        rgb[2] = 74;
        return;
    }
    /* in double, so that only a normal beyond float's range has no length */
    if (length > 0.0 && length < HUGE_VAL) {
        eye = -dot(hit->ng, ray->dir) / (length * dir_length);
        light = dot(hit->ng, to_light) / length;
    }
    if (eye < 0.0) { /* the back of the triangle: its other normal */
        eye = -eye;
        light = -light;
    }
    bright = 0.1 + 0.4 * eye + 0.45 * (0.5 + 0.5 * light);
    rgb[0] = byte(bright);
    rgb[1] = byte(0.98 * bright);
    rgb[2] = byte(0.94 * bright);
}

static void shade_depth(const hug_hit *hit, const scale *s, unsigned char rgb[3])
{
    double range = s->far_log - s->near_log;
    double grey = 0.0;
    if (hit->geom != HUG_NONE)
        grey = 1.0 - 0.85 * (range > 0.0 ? (log((double)hit->t) - s->near_log) / range : 0.0);
    rgb[0] = rgb[1] = rgb[2] = byte(grey);
}

/* Black, blue, purple, red, orange, yellow, white. */
static void heat(double share, unsigned char rgb[3])
{
    static const unsigned char stops[7][3] = {{0, 0, 0},     {30, 20, 120},  {120, 20, 140},
                                              {205, 40, 75}, {245, 125, 20}, {250, 215, 60},
                                              {255, 255, 255}};
    double place = (share < 1.0 ? share : 1.0) * 6.0;
    int lower = place < 6.0 ? (int)place : 5, channel;
    for (channel = 0; channel < 3; channel++) {
        double from = stops[lower][channel], to = stops[lower + 1][channel];
        rgb[channel] = (unsigned char)(from + (place - lower) * (to - from) + 0.5);
    }
}

static int ascending(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Near and far leave out a hundredth of the hits each, so that one pixel that
 * touches the eye does not turn the rest black. Returns 0 without memory. */
static int scale_depth(const frame *f, scale *out)
{
    float *depths = (float *)malloc((f->count + 1) * sizeof *depths);
    size_t i, n = 0;
    if (!depths)
        return 0;
    for (i = 0; i < f->count; i++)
        if (f->hits[i].geom != HUG_NONE && f->hits[i].t > 0.0f)
            depths[n++] = f->hits[i].t;
    if (n) {
        qsort(depths, n, sizeof *depths, ascending);
        out->near_log = log((double)depths[n / 100]);
        out->far_log = log((double)depths[n - 1 - n / 100]);
    }
    free(depths);
    return 1;
}

/* Above the eye and to its right. */
static void place_light(const kit_view *view, float out[3])
{
    float ahead[3], right[3];
    double length;
    int i;
    for (i = 0; i < 3; i++)
        ahead[i] = view->at[i] - view->eye[i];
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        right[i] = ahead[j] * view->up[k] - ahead[k] * view->up[j];
    }
    for (i = 0; i < 3; i++)
        out[i] = (float)(view->up[i] / sqrt(dot(view->up, view->up)) +
                         0.6 * right[i] / sqrt(dot(right, right)) -
                         0.4 * ahead[i] / sqrt(dot(ahead, ahead)));
    length = sqrt(dot(out, out));
    for (i = 0; i < 3; i++)
        out[i] = (float)(out[i] / length);
}

/* What all but a two-hundredth of the pixels stay within: the few that take many
 * times more would leave the rest black. 0 without memory. */
static uint32_t usual_steps(const frame *f)
{
    float *sorted = (float *)malloc(f->count * sizeof *sorted);
    uint32_t most;
    size_t i;
    if (!sorted)
        return 0;
    for (i = 0; i < f->count; i++)
        sorted[i] = (float)f->steps[i];
    qsort(sorted, f->count, sizeof *sorted, ascending);
    most = (uint32_t)sorted[f->count - 1 - f->count / 200];
    free(sorted);
    return most ? most : 1;
}

static int make_scale(picture_mode mode, const frame *f, const kit_view *view, uint32_t steps_max,
                      scale *out)
{
    memset(out, 0, sizeof *out);
    place_light(view, out->to_light);
    out->steps_max = steps_max;
    if (mode == PICTURE_STEPS && steps_max == 0) {
        out->steps_max = usual_steps(f);
        return out->steps_max != 0;
    }
    return mode != PICTURE_DEPTH || scale_depth(f, out);
}

int picture_write(const char *path, picture_mode mode, const frame *f, const kit_view *view,
                  uint32_t steps_max)
{
    unsigned char *pixels = (unsigned char *)malloc(3 * f->count + 1);
    scale s;
    size_t i;
    int ok;
    if (!pixels || !make_scale(mode, f, view, steps_max, &s)) {
        message("%s: no memory for its pixels", path);
        free(pixels);
        return 0;
    }
    for (i = 0; i < f->count; i++) {
        size_t place = (size_t)f->xy[2 * i + 1] * f->size + f->xy[2 * i];
        unsigned char *rgb = pixels + 3 * place;
        if (mode == PICTURE_SHADED)
            shade(&f->rays[i], &f->hits[i], s.to_light, rgb);
        else if (mode == PICTURE_DEPTH)
            shade_depth(&f->hits[i], &s, rgb);
        else
            heat((double)f->steps[i] / s.steps_max, rgb);
    }
    errno = 0;
    ok = stbi_write_png(path, (int)f->size, (int)f->size, 3, pixels, 3 * (int)f->size);
    if (!ok)
        message("%s: cannot be written: %s", path, errno ? strerror(errno) : "unknown reason");
    free(pixels);
    return ok;
}
