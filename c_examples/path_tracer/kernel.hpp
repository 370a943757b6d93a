// What a path tracer asks of a ray-tracing kernel, and the two that answer it here.
#ifndef KERNEL_HPP
#define KERNEL_HPP

#include <embree3/rtcore.h>

#include <memory>
#include <vector>

#include "hug.hpp"

extern "C" {
#include "scene.h"
}

// Rays are hug's. A ray that starts on a triangle names it (skip_geom, skip_prim).
class kernel {
public:
    virtual ~kernel() = default;
    virtual void closest(hug::span<const hug::ray> rays, hug::span<hug::hit> hits) = 0;
    virtual void occluded(hug::span<const hug::ray> rays, hug::span<std::uint8_t> blocked) = 0;

    double build_seconds = 0;
    double query_seconds = 0; // in the library's functions alone
    std::size_t rays = 0;
};

// Asks hug for streams: rays of a path tracer go all ways.
class hug_kernel final : public kernel {
public:
    explicit hug_kernel(const scene &from);
    void closest(hug::span<const hug::ray> rays, hug::span<hug::hit> hits) override;
    void occluded(hug::span<const hug::ray> rays, hug::span<std::uint8_t> blocked) override;

private:
    hug::scene built_;
};

// Asks Embree for one ray after the other, as its users do for rays that go all ways.
// Embree has no triangle to skip: rays that have one begin a little later.
class embree_kernel final : public kernel {
public:
    explicit embree_kernel(const scene &from);
    ~embree_kernel() override;
    void closest(hug::span<const hug::ray> rays, hug::span<hug::hit> hits) override;
    void occluded(hug::span<const hug::ray> rays, hug::span<std::uint8_t> blocked) override;

private:
    RTCDevice device_;
    RTCScene built_;
    float offset_;
    std::vector<RTCRayHit> records_;
};

#endif
