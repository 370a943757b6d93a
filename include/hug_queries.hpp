// hug_queries.hpp - the queries of hug.hpp, which includes it, that ask for more than one
// answer: all hits, hits that a function accepts, the nearest point.
#ifndef HUG_QUERIES_HPP
#define HUG_QUERIES_HPP

#include "hug.hpp"

namespace hug {

using probe = hug_probe;
using nearest = hug_nearest;

// How many hits were found, and whether there are more behind them.
struct found {
    std::size_t count;
    bool more;
};

// hug_intersect_all: the first hits, as many as there is room for; those that follow
// after, if it is not null.
inline result<found> intersect_all(scene_view in, const ray &along, span<hit> room,
                                   const hit *after = nullptr)
{
    std::size_t count = 0;
    std::int32_t more = 0;
    status code = hug_intersect_all(in.get(), &along, after, room.data(), room.size(), &count,
                                    &more);
    if (code != HUG_OK)
        return result<found>::failure(code);
    return found{count, more != 0};
}

// Calls f(const hit &) for every hit in order, in room for 16 at a time; f returns false
// to stop.
template <class F>
void for_each_hit(scene_view in, const ray &along, F &&f)
{
    hit room[16];
    const hit *after = nullptr;
    hit last;
    for (;;) {
        result<found> next = intersect_all(in, along, room, after);
        if (!next)
            return;
        for (std::size_t i = 0; i < next->count; i++)
            if (!f(static_cast<const hit &>(room[i])))
                return;
        if (!next->more)
            return;
        last = room[next->count - 1];
        after = &last;
    }
}

namespace detail {
template <class F>
std::int32_t accept(void *of, std::size_t index, const ray *along, const hit *at)
{
    return (*static_cast<F *>(of))(index, *along, *at) ? 1 : 0;
}
} // namespace detail

// accept(std::size_t index, const ray &, const hit &) -> bool, which must not throw: true
// for a hit that counts.
template <class F>
hit intersect_filtered(scene_view in, const ray &along, F &accept)
{
    hit at;
    hug_intersect_filtered(in.get(), &along, &at, detail::accept<F>, std::addressof(accept));
    return at;
}
template <class F>
bool occluded_filtered(scene_view in, const ray &along, F &accept)
{
    return hug_occluded_filtered(in.get(), &along, detail::accept<F>, std::addressof(accept)) != 0;
}
template <class F>
void intersect_filtered(scene_view in, span<const ray> rays, span<hit> hits, F &accept)
{
    hug_intersect_n_filtered(in.get(), rays.data(), 0, hits.data(), 0, rays.size(),
                             detail::accept<F>, std::addressof(accept));
}
template <class F>
void occluded_filtered(scene_view in, span<const ray> rays, span<std::uint8_t> blocked, F &accept)
{
    hug_occluded_n_filtered(in.get(), rays.data(), 0, blocked.data(), rays.size(),
                            detail::accept<F>, std::addressof(accept));
}

constexpr probe make_probe(std::array<float, 3> org,
                           float radius = std::numeric_limits<float>::infinity()) noexcept
{
    return {{org[0], org[1], org[2]}, radius, none, 0, none, none};
}
constexpr bool is_found(const nearest &of) noexcept { return of.geom != none; }

inline nearest closest_point(scene_view in, const probe &around)
{
    nearest of;
    hug_closest_point(in.get(), &around, &of);
    return of;
}

// Of the triangle alone.
inline hit intersect_triangle(const ray &along, const float (&corners)[9])
{
    hit at;
    hug_intersect_triangle(&along, corners, &at);
    return at;
}

} // namespace hug

#endif
