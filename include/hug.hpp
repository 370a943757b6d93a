// hug.hpp - hug for C++17: a thin header over hug.h.
//
//     hug::scene scene = hug::builder().add(vertices, indices).build().value();
//     hug::hit hit = scene.intersect(hug::make_ray({0, 0, 2}, {0, 0, -1}));
//
// Each function here calls one of hug.h and costs what that call costs: nothing is
// allocated, copied or checked on the way. What is true of the C function (threads,
// lifetimes, bounds) is true of its wrapper; hug.h says it once.
//
// Errors. What can fail returns a hug::result, a value or a status. Look at it
// (if (auto scene = builder.build()) use(*scene);), or call value(), which throws a
// hug::error. Compiled without exceptions, value() ends the program instead.
// Queries cannot fail. They throw nothing either, but are not declared noexcept: hug.h's
// functions are not, and a compiler would guard each call.
#ifndef HUG_HPP
#define HUG_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

#include "hug.h"

namespace hug {

using ray = hug_ray;
using hit = hug_hit;
using counters = hug_counters;
using status = hug_status;
inline constexpr std::uint32_t none = 0xffffffffu;

// A ray that meets everything from tmin to tmax.
constexpr ray make_ray(std::array<float, 3> org, std::array<float, 3> dir, float tmin = 0.0f,
                       float tmax = std::numeric_limits<float>::infinity()) noexcept
{
    return {{org[0], org[1], org[2]}, tmin, {dir[0], dir[1], dir[2]}, tmax, none, 0, none, none};
}

// The same ray, through the triangle of a hit: for rays that start on it.
constexpr ray skipping(ray of, const hit &start) noexcept
{
    of.skip_geom = start.geom;
    of.skip_prim = start.prim;
    return of;
}

constexpr bool is_hit(const hit &of) noexcept { return of.geom != none; }

// Borrowed contiguous memory, as std::span of C++20 is.
template <class T>
class span {
public:
    constexpr span() noexcept = default;
    constexpr span(T *first, std::size_t count) noexcept : first_(first), count_(count) {}
    template <std::size_t N>
    constexpr span(T (&array)[N]) noexcept : first_(array), count_(N) {}
    // std::vector, std::array, std::span and whatever else has data() and size().
    template <class C, class P = decltype(std::declval<C &>().data()),
              class = std::enable_if_t<std::is_convertible_v<
                  std::remove_pointer_t<P> (*)[], T (*)[]>>,
              class = decltype(std::declval<C &>().size())>
    constexpr span(C &&of) noexcept : first_(of.data()), count_(of.size()) {}

    constexpr T *data() const noexcept { return first_; }
    constexpr std::size_t size() const noexcept { return count_; }
    constexpr bool empty() const noexcept { return count_ == 0; }
    constexpr T &operator[](std::size_t i) const noexcept { return first_[i]; }
    constexpr T *begin() const noexcept { return first_; }
    constexpr T *end() const noexcept { return first_ + count_; }
    constexpr span first(std::size_t n) const noexcept { return {first_, n}; }
    constexpr span subspan(std::size_t at, std::size_t n) const noexcept
    {
        return {first_ + at, n};
    }

private:
    T *first_ = nullptr;
    std::size_t count_ = 0;
};

// A status as an exception.
class error : public std::exception {
public:
    explicit error(status code) noexcept : code_(code) {}
    status code() const noexcept { return code_; }
    const char *what() const noexcept override { return hug_status_string(code_); }

private:
    status code_;
};

// A value, or the status that says why there is none.
template <class T>
class result {
public:
    result(T value) noexcept : value_(std::move(value)), code_(HUG_OK) {}
    static result failure(status code) noexcept { return result(code, 0); }

    bool has_value() const noexcept { return code_ == HUG_OK; }
    explicit operator bool() const noexcept { return has_value(); }
    status code() const noexcept { return code_; }
    const char *message() const noexcept { return hug_status_string(code_); }

    // Unchecked, for who has looked.
    T &operator*() & noexcept { return value_; }
    const T &operator*() const & noexcept { return value_; }
    T &&operator*() && noexcept { return std::move(value_); }
    T *operator->() noexcept { return &value_; }
    const T *operator->() const noexcept { return &value_; }

    T &value() & { return check(), value_; }
    const T &value() const & { return check(), value_; }
    T &&value() && { return check(), std::move(value_); }

private:
    result(status code, int) noexcept : code_(code) {}

    void check() const
    {
        if (has_value())
            return;
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
        throw error(code_);
#else
        std::terminate();
#endif
    }

    T value_{};
    status code_;
};

// A scene that somebody else keeps: a pointer, to be passed by value.
class scene_view {
public:
    constexpr scene_view() noexcept = default;
    constexpr explicit scene_view(const hug_scene *of) noexcept : of_(of) {}
    constexpr const hug_scene *get() const noexcept { return of_; }

    // Checks bytes, aligned to 64, that were saved, copied or mapped, and uses them where
    // they are.
    static result<scene_view> open(span<const std::byte> bytes, std::uint32_t flags = 0) noexcept
    {
        const hug_scene *opened;
        status code = hug_open(bytes.data(), bytes.size(), flags, &opened);
        if (code != HUG_OK)
            return result<scene_view>::failure(code);
        return scene_view(opened);
    }

    hit intersect(const ray &along) const
    {
        hit found;
        hug_intersect(of_, &along, &found);
        return found;
    }
    bool occluded(const ray &along) const { return hug_occluded(of_, &along) != 0; }

    // Streams. hits and blocked are at least as long as rays.
    void intersect(span<const ray> rays, span<hit> hits) const
    {
        hug_intersect_n(of_, rays.data(), 0, hits.data(), 0, rays.size());
    }
    void occluded(span<const ray> rays, span<std::uint8_t> blocked) const
    {
        hug_occluded_n(of_, rays.data(), 0, blocked.data(), rays.size());
    }

    // What is done is added to the counters.
    hit intersect(const ray &along, counters &add_to) const
    {
        hit found;
        hug_intersect_counted(of_, &along, &found, &add_to);
        return found;
    }
    bool occluded(const ray &along, counters &add_to) const
    {
        return hug_occluded_counted(of_, &along, &add_to) != 0;
    }

    // The arena, to be saved and opened again.
    span<const std::byte> data() const noexcept
    {
        std::size_t size;
        auto first = static_cast<const std::byte *>(hug_data(of_, &size));
        return {first, size};
    }

    struct box {
        std::array<float, 3> lower, upper;
    };
    box bounds() const noexcept
    {
        box of{};
        hug_bounds(of_, of.lower.data(), of.upper.data());
        return of;
    }

    hug_scene_stats stats() const noexcept
    {
        hug_scene_stats of{};
        of.struct_size = sizeof of;
        hug_stats(of_, &of);
        return of;
    }

private:
    const hug_scene *of_ = nullptr;
};

// A scene that is freed with this object.
class scene : public scene_view {
public:
    scene() noexcept = default;
    explicit scene(hug_scene *owned) noexcept : scene_view(owned), owned_(owned) {}
    scene(scene &&from) noexcept { swap(from); }
    scene &operator=(scene &&from) noexcept
    {
        scene(std::move(from)).swap(*this);
        return *this;
    }

    static result<scene> build(const hug_build_desc &desc) noexcept
    {
        hug_scene *built;
        status code = hug_build(&desc, &built);
        if (code != HUG_OK)
            return result<scene>::failure(code);
        return scene(built);
    }
    // hug_rebuild: for triangles that have moved. HUG_OK, or why not.
    status rebuild(const hug_build_desc &desc) noexcept
    {
        return hug_rebuild(owned_.get(), &desc);
    }

    void swap(scene &with) noexcept
    {
        owned_.swap(with.owned_);
        std::swap(static_cast<scene_view &>(*this), static_cast<scene_view &>(with));
    }

private:
    struct free {
        void operator()(hug_scene *of) const noexcept { hug_free(of); }
    };
    std::unique_ptr<hug_scene, free> owned_;
};

} // namespace hug

#include "hug_builder.hpp"
#include "hug_queries.hpp"

#endif
