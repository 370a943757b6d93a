#include "path_tracer/world.hpp"

#include <algorithm>

namespace {

// Neighbours in the mesh share a colour, and one group of so many is a mirror.
constexpr std::uint32_t group = 12, mirrors = 8;
constexpr float sun_radius = 0.02f; // radians, four times the real one's
constexpr float lamp_radius = 0.05f; // of how far it reaches

vec corner(const scene &from, std::uint32_t index)
{
    const float *at = from.vertices + 3 * std::size_t(index);
    return {at[0], at[1], at[2]};
}

// Muted colours around the circle of hues.
vec tint(std::uint32_t number)
{
    float hue = 6.2831853f * float(number & 1023) / 1024, pale = float(number >> 10 & 255) / 255;
    vec wave{std::cos(hue), std::cos(hue - 2.0944f), std::cos(hue + 2.0944f)};
    return vec{0.5f, 0.47f, 0.43f} + wave * (0.05f + 0.25f * pale * pale);
}

// Bands along one side of each triangle, so that u and v are seen too.
float pattern(float u, float v) { return std::fmod(4 * (u + 2 * v), 1.0f) < 0.5f ? 1.0f : 0.86f; }

} // namespace

world::world(const scene &from, vec up) : from_(from), up_(up)
{
    vec a, b;
    frame_of(up, a, b);
    sun_ = unit(up + a * 0.55f + b * 0.75f);
}

surface world::surface_of(const hug::ray &ray, const hug::hit &hit) const
{
    const std::uint32_t *triangle = from_.indices + 3 * std::size_t(hit.prim);
    surface of;
    of.at = corner(from_, triangle[0]) * (1 - hit.u - hit.v) +
            corner(from_, triangle[1]) * hit.u + corner(from_, triangle[2]) * hit.v;
    of.normal = unit({hit.ng[0], hit.ng[1], hit.ng[2]});
    if (dot(of.normal, {ray.dir[0], ray.dir[1], ray.dir[2]}) > 0)
        of.normal = of.normal * -1;
    std::uint32_t number = mixed(hit.prim / group);
    of.mirror = number % mirrors == 0;
    of.albedo = of.mirror ? vec{0.8f, 0.84f, 0.86f} : tint(number >> 4) * pattern(hit.u, hit.v);
    return of;
}

vec world::sky(vec direction, bool with_sun) const
{
    float height = std::sqrt(std::max(dot(direction, up_), 0.0f)), near = dot(direction, sun_);
    vec colour = vec{0.85f, 0.84f, 0.8f} * (1 - height) + vec{0.12f, 0.3f, 0.75f} * height;
    colour = colour + vec{1, 0.8f, 0.5f} * (0.35f * std::pow(std::max(near, 0.0f), 24.0f));
    if (with_sun && near > std::cos(sun_radius))
        return sunlight() * 8;
    return dot(direction, up_) < 0 ? colour * 0.35f : colour;
}

vec world::towards_sun(float r, float s) const
{
    vec a, b;
    frame_of(sun_, a, b);
    float radius = sun_radius * std::sqrt(r), angle = 6.2831853f * s;
    return unit(sun_ + a * (radius * std::cos(angle)) + b * (radius * std::sin(angle)));
}

void world::hang_lamp(vec at, float distance)
{
    lamp_ = at;
    reach_ = distance;
}

vec world::lamp(float r, float s) const
{
    float z = 1 - 2 * r, across = std::sqrt(1 - z * z), angle = 6.2831853f * s;
    return lamp_ + vec{across * std::cos(angle), across * std::sin(angle), z} * (lamp_radius * reach_);
}

vec world::lamplight(float distance) const
{
    // No brighter near by: a few paths that end beside the lamp would spoil their pixels.
    float near = std::max(distance / reach_, 0.35f);
    return vec{0.9f, 0.8f, 0.65f} * (1 / (near * near));
}
