#include "path_tracer/lamp.hpp"

#include <algorithm>

namespace {

constexpr unsigned directions = 1024;
constexpr unsigned enough_sky = directions / 50;

// As many directions, evenly over all sides: a spiral from pole to pole.
std::vector<hug::ray> all_ways(vec eye)
{
    std::vector<hug::ray> rays;
    for (unsigned i = 0; i < directions; i++) {
        float z = 1 - (2 * float(i) + 1) / directions, radius = std::sqrt(1 - z * z);
        float angle = 2.3999632f * float(i); // the golden angle
        rays.push_back(hug::make_ray({eye.x, eye.y, eye.z},
                                     {radius * std::cos(angle), radius * std::sin(angle), z}));
    }
    return rays;
}

// How far it is to the next surface; 0 where there is none.
float distance(kernel &by, vec from, vec towards)
{
    hug::ray ray = hug::make_ray({from.x, from.y, from.z}, {towards.x, towards.y, towards.z});
    hug::hit hit;
    by.closest({&ray, 1}, {&hit, 1});
    return hug::is_hit(hit) ? hit.t : 0;
}

} // namespace

bool lamp_is_needed(kernel &by, const kit_view &from, vec *at)
{
    vec eye{from.eye[0], from.eye[1], from.eye[2]};
    vec ahead = unit(vec{from.at[0], from.at[1], from.at[2]} - eye);
    vec up = unit({from.up[0], from.up[1], from.up[2]});
    std::vector<hug::ray> rays = all_ways(eye);
    std::vector<hug::hit> hits(rays.size());
    by.closest(rays, hits);
    auto sky = std::count_if(hits.begin(), hits.end(),
                             [](const hug::hit &hit) { return !hug::is_hit(hit); });
    if (sky >= enough_sky)
        return false;
    vec middle = eye + ahead * (0.5f * distance(by, eye, ahead));
    *at = middle + up * (0.7f * distance(by, middle, up));
    return true;
}
