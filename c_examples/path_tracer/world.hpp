// What rays meet: surfaces coloured by primitive id, a sun, a sky, perhaps a lamp.
#ifndef WORLD_HPP
#define WORLD_HPP

#include "hug.hpp"
#include "path_tracer/vec.hpp"

extern "C" {
#include "scene.h"
}

struct surface {
    vec at, normal; // a unit vector towards the ray's side
    vec albedo;
    bool mirror;
};

class world {
public:
    // up: away from the ground.
    world(const scene &from, vec up);

    surface surface_of(const hug::ray &ray, const hug::hit &hit) const;

    // Light from beyond the scene; the sun's disc only where no shadow ray stands for it.
    vec sky(vec direction, bool with_sun) const;
    // A direction to a point of the disc.
    vec towards_sun(float r, float s) const;
    vec sunlight() const { return {3.6f, 3.2f, 2.7f}; }

    // A ball of light, not seen itself. What is so far from it is lit by a quarter of the sun.
    void hang_lamp(vec at, float distance);
    bool has_lamp() const { return reach_ > 0; }
    // A place on the ball.
    vec lamp(float r, float s) const;
    vec lamplight(float distance) const;

private:
    const scene &from_;
    vec up_, sun_, lamp_{};
    float reach_ = 0;
};

#endif
