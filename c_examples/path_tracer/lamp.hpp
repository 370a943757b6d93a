// A lamp for scenes that no daylight reaches.
#ifndef LAMP_HPP
#define LAMP_HPP

#include "path_tracer/kernel.hpp"
#include "path_tracer/vec.hpp"

extern "C" {
#include "hug_kit.h"
}

// Whether it is dark where the eye is: hardly any straight line leads from it to the sky.
// If so, *at is a place below the ceiling, above the middle of what is ahead; straight
// lines lead there from the eye, so it is in the same room.
bool lamp_is_needed(kernel &by, const kit_view &from, vec *at);

#endif
