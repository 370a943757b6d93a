/* Pictures of a frame, as PNG files. */
#ifndef PICTURE_H
#define PICTURE_H

#include "frame.h"

#define PICTURE_COUNT 3

typedef enum { PICTURE_SHADED, PICTURE_DEPTH, PICTURE_STEPS } picture_mode;

/* By picture_mode: shaded, depth, steps. */
extern const char *const picture_names[PICTURE_COUNT];

/* shaded: by the angles to the eye and to a light above it.
 * depth: white near, black far, on a scale of logarithms.
 * steps: a heat map from 0 to steps_max; if that is 0, to what 99.5 % stay within.
 * Returns 1, or 0 after a message. */
int picture_write(const char *path, picture_mode mode, const frame *f, const kit_view *view,
                  uint32_t steps_max);

#endif
