#include "path_tracer/kernel.hpp"

#include <cmath>
#include <stdexcept>

#include "hug_embree.h"

extern "C" {
#include "clocks.h"
}

hug_kernel::hug_kernel(const scene &from)
{
    double start = seconds_process();
    built_ = hug::builder()
                 .add({from.vertices, 3 * from.vertex_count}, {from.indices, 3 * from.triangle_count})
                 .build()
                 .value();
    build_seconds = seconds_process() - start;
}

void hug_kernel::closest(hug::span<const hug::ray> of, hug::span<hug::hit> hits)
{
    double start = seconds_thread();
    built_.intersect(of, hits);
    query_seconds += seconds_thread() - start;
    rays += of.size();
}

void hug_kernel::occluded(hug::span<const hug::ray> of, hug::span<std::uint8_t> blocked)
{
    double start = seconds_thread();
    built_.occluded(of, blocked);
    query_seconds += seconds_thread() - start;
    rays += of.size();
}

embree_kernel::embree_kernel(const scene &from)
{
    device_ = rtcNewDevice("threads=1");
    if (!device_)
        throw std::runtime_error("Embree gives no device");
    double start = seconds_process();
    built_ = rtcNewScene(device_);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               from.vertices, 0, 3 * sizeof(float), from.vertex_count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, from.indices,
                               0, 3 * sizeof(std::uint32_t), from.triangle_count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(built_, geometry, 0);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(built_);
    build_seconds = seconds_process() - start;
    float longest = 0;
    for (int k = 0; k < 3; k++)
        longest = std::fmax(longest, from.bounds.hi[k] - from.bounds.lo[k]);
    offset_ = 1e-5f * longest;
}

embree_kernel::~embree_kernel()
{
    rtcReleaseScene(built_);
    rtcReleaseDevice(device_);
}

void embree_kernel::closest(hug::span<const hug::ray> of, hug::span<hug::hit> hits)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    records_.resize(of.size());
    for (std::size_t i = 0; i < of.size(); i++) {
        hug_embree_to_rayhit(&of[i], &records_[i]);
        if (of[i].skip_geom != hug::none)
            records_[i].ray.tnear = offset_;
    }
    double start = seconds_thread();
    for (RTCRayHit &record : records_)
        rtcIntersect1(built_, &context, &record);
    query_seconds += seconds_thread() - start;
    for (std::size_t i = 0; i < of.size(); i++)
        hits[i] = hug_embree_hit(&records_[i]);
    rays += of.size();
}

void embree_kernel::occluded(hug::span<const hug::ray> of, hug::span<std::uint8_t> blocked)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    records_.resize(of.size());
    for (std::size_t i = 0; i < of.size(); i++) {
        hug_embree_to_ray(&of[i], &records_[i].ray);
        records_[i].ray.tnear = offset_;
    }
    double start = seconds_thread();
    for (RTCRayHit &record : records_)
        rtcOccluded1(built_, &context, &record.ray);
    query_seconds += seconds_thread() - start;
    for (std::size_t i = 0; i < of.size(); i++)
        blocked[i] = std::uint8_t(hug_embree_occluded(&records_[i].ray));
    rays += of.size();
}
