#include "compare/embree_side.h"

#include <stdio.h>
#include <string.h>

#include "message.h"

static void on_error(void *user, enum RTCError code, const char *text)
{
    (void)user;
    message("Embree: %s (error %d)", text ? text : "no description", (int)code);
}

/* Called for every allocation (bytes above 0) and release (below) of the device. */
static bool on_memory(void *user, ssize_t bytes, bool post)
{
    (void)post;
    ((embree_side *)user)->held += bytes;
    return true;
}

/* on_error has said what the matter is. */
static int failed(embree_side *e)
{
    return rtcGetDeviceError(e->device) != RTC_ERROR_NONE;
}

int embree_open(const scene *from, const embree_kind *kind, unsigned threads, embree_side *out)
{
    char config[32];
    memset(out, 0, sizeof *out);
    out->from = from;
    out->kind = kind;
    snprintf(config, sizeof config, "threads=%u", threads);
    out->device = rtcNewDevice(config);
    if (!out->device) {
        message("Embree: no device (error %d)", (int)rtcGetDeviceError(NULL));
        return 0;
    }
    rtcSetDeviceErrorFunction(out->device, on_error, NULL);
    rtcSetDeviceMemoryMonitorFunction(out->device, on_memory, out);
    return !failed(out);
}

int embree_build(embree_side *e)
{
    const scene *s = e->from;
    long long before = e->held;
    RTCGeometry geometry = rtcNewGeometry(e->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    e->built = rtcNewScene(e->device);
    if (!geometry || !e->built || failed(e)) {
        message("Embree: cannot make a scene for %s", s->name);
        return 0;
    }
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               s->vertices, 0, 3 * sizeof(float), s->vertex_count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, s->indices,
                               0, 3 * sizeof(uint32_t), s->triangle_count);
    /* A scene of low quality leaves the builder to its geometries. */
    rtcSetGeometryBuildQuality(geometry, e->kind->quality);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(e->built, geometry, 0);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(e->built, e->kind->flags);
    rtcSetSceneBuildQuality(e->built, e->kind->quality);
    rtcCommitScene(e->built);
    if (failed(e)) {
        message("Embree: cannot build %s", s->name);
        return 0;
    }
    e->scene_bytes = (unsigned long long)(e->held - before);
    return 1;
}

void embree_release(embree_side *e)
{
    if (e->built)
        rtcReleaseScene(e->built);
    e->built = NULL;
}

void embree_close(embree_side *e)
{
    embree_release(e);
    if (e->device)
        rtcReleaseDevice(e->device);
    e->device = NULL;
}
