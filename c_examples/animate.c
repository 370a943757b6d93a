/* What it teaches: triangles that move. The scene is built once with room to spare
 * (HUG_BUILD_KEEP_SCRATCH); each frame is rebuilt in the same memory by hug_rebuild,
 * which allocates nothing, and traced as a stream. HUG_QUALITY_FAST is the setting for
 * scenes that live for one frame. Beside it Embree does the same with its fastest
 * builder. The frames per second are of build and trace together, on one thread, in CPU
 * time; the pictures of the two are compared.
 *
 * usage: animate [--side N] [--size N] [--frames N] [--out PREFIX]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stb_image_write.h>

#include "clocks.h"
#include "hug_embree.h"
#include "lessons/waves.h"
#include "message.h"
#include "options.h"

static const char help[] =
    "usage: animate [options]\n"
    "\n"
    "  --side N      squares along each side of the mesh (default: 250, 125000 triangles)\n"
    "  --size N      pixels along each side (default: 256)\n"
    "  --frames N    frames to make (default: 24)\n"
    "  --out PREFIX  also write PREFIX-0000.png, ...\n"
    "  --help        this text\n";

typedef struct {
    unsigned side, size, frames;
    const char *out;
    float *vertices;
    uint32_t *indices;
    hug_ray *rays;
    hug_hit *hits;
    struct RTCRayHit *records;
    unsigned char *ours, *theirs;
    double build[2], trace[2];
    size_t differ;
} animation;

static int hug_frame(animation *a, hug_scene **scene)
{
    size_t count = (size_t)a->size * a->size, i;
    hug_geometry geometry = waves_geometry(a->side, a->vertices, a->indices);
    hug_build_desc desc = waves_desc(&geometry);
    hug_status status;
    double start = seconds_thread();
    desc.quality = HUG_QUALITY_FAST;
    desc.flags = HUG_BUILD_KEEP_SCRATCH;
    status = *scene ? hug_rebuild(*scene, &desc) : hug_build(&desc, scene);
    a->build[0] += seconds_thread() - start;
    if (status != HUG_OK) {
        message("hug: %s", hug_status_string(status));
        return 0;
    }
    start = seconds_thread();
    hug_intersect_n(*scene, a->rays, 0, a->hits, 0, count);
    a->trace[0] += seconds_thread() - start;
    for (i = 0; i < count; i++)
        a->ours[i] = waves_shade(&a->hits[i]);
    return 1;
}

static void embree_frame(animation *a, RTCScene scene)
{
    size_t count = (size_t)a->size * a->size, i;
    RTCGeometry geometry = rtcGetGeometry(scene, 0);
    struct RTCIntersectContext context;
    double start = seconds_process();
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
    rtcCommitScene(scene);
    a->build[1] += seconds_process() - start;
    rtcInitIntersectContext(&context);
    for (i = 0; i < count; i++)
        hug_embree_to_rayhit(&a->rays[i], &a->records[i]);
    start = seconds_thread();
    for (i = 0; i < count; i++)
        rtcIntersect1(scene, &context, &a->records[i]);
    a->trace[1] += seconds_thread() - start;
    for (i = 0; i < count; i++) {
        hug_hit hit = hug_embree_hit(&a->records[i]);
        a->theirs[i] = waves_shade(&hit);
    }
}

static RTCScene embree_scene(RTCDevice device, const animation *a)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    RTCScene scene = rtcNewScene(device);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               a->vertices, 0, 3 * sizeof(float), WAVES_VERTICES(a->side));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, a->indices,
                               0, 3 * sizeof(uint32_t), WAVES_TRIANGLES(a->side));
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
    rtcAttachGeometryByID(scene, geometry, 0);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
    return scene;
}

static int write_frame(const animation *a, unsigned frame)
{
    char path[4096];
    snprintf(path, sizeof path, "%s-%04u.png", a->out, frame);
    if (stbi_write_png(path, (int)a->size, (int)a->size, 1, a->ours, (int)a->size))
        return 1;
    message("%s: cannot be written", path);
    return 0;
}

static int animate(animation *a)
{
    size_t count = (size_t)a->size * a->size, i;
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene embree = device ? embree_scene(device, a) : NULL;
    hug_scene *scene = NULL;
    progress bar;
    unsigned frame;
    int ok = embree != NULL;
    if (!ok)
        message("Embree: no device");
    for (i = 0; i < count; i++)
        a->rays[i] = waves_ray((unsigned)(i % a->size), (unsigned)(i / a->size), a->size, a->size);
    waves_indices(a->side, a->indices);
    progress_start(&bar, "frames", a->frames);
    for (frame = 0; ok && frame < a->frames; frame++) {
        waves_vertices(a->side, 0.25f * (float)frame, a->vertices);
        ok = hug_frame(a, &scene);
        if (!ok)
            break;
        embree_frame(a, embree);
        for (i = 0; i < count; i++)
            a->differ += abs(a->ours[i] - a->theirs[i]) > 8;
        ok = !a->out || write_frame(a, frame);
        progress_at(&bar, frame + 1);
    }
    progress_end(&bar);
    hug_free(scene);
    if (embree)
        rtcReleaseScene(embree);
    if (device)
        rtcReleaseDevice(device);
    return ok;
}

static void print(const animation *a)
{
    static const char *const names[2] = {"hug", "Embree"};
    int i;
    printf("%u frames of %lu triangles, %u x %u rays; one thread\n", a->frames,
           (unsigned long)WAVES_TRIANGLES(a->side), a->size, a->size);
    for (i = 0; i < 2; i++)
        printf("%-8s build %7.2f ms, trace %7.2f ms: %6.1f frames per second\n", names[i],
               1e3 * a->build[i] / a->frames, 1e3 * a->trace[i] / a->frames,
               a->frames / (a->build[i] + a->trace[i]));
    printf("pixels that differ: %.4f %%\n",
           100.0 * (double)a->differ / ((double)a->size * a->size * a->frames));
}

static int read_options(int argc, char **argv, animation *a, int *asks_help)
{
    const char *side = "250", *size = "256", *frames = "24";
    unsigned long numbers[3];
    const option table[] = {{"--side", &side, NULL},     {"--size", &size, NULL},
                            {"--frames", &frames, NULL}, {"--out", &a->out, NULL},
                            {"--help", NULL, asks_help}};
    if (!options_parse(argc, argv, table, sizeof table / sizeof *table) ||
        !parse_count("--side", side, 1, 4000, &numbers[0]) ||
        !parse_count("--size", size, 1, 8192, &numbers[1]) ||
        !parse_count("--frames", frames, 1, 10000, &numbers[2]))
        return 0;
    a->side = (unsigned)numbers[0];
    a->size = (unsigned)numbers[1];
    a->frames = (unsigned)numbers[2];
    return 1;
}

int main(int argc, char **argv)
{
    animation a;
    size_t count, records;
    int asks_help = 0, ok = 0;
    message_program("animate");
    memset(&a, 0, sizeof a);
    if (!read_options(argc, argv, &a, &asks_help))
        return 2;
    if (asks_help)
        return fputs(help, stdout) < 0;
    count = (size_t)a.size * a.size;
    records = count * sizeof *a.records + 16;
    /* One float more: Embree loads 16 bytes a vertex. Its records are aligned to 16. */
    a.vertices = (float *)calloc(3 * WAVES_VERTICES(a.side) + 1, sizeof(float));
    a.indices = (uint32_t *)calloc(3 * WAVES_TRIANGLES(a.side), sizeof(uint32_t));
    a.rays = (hug_ray *)calloc(count, sizeof *a.rays);
    a.hits = (hug_hit *)calloc(count, sizeof *a.hits);
    a.records = (struct RTCRayHit *)calloc(1, records);
    a.ours = (unsigned char *)calloc(2, count);
    a.theirs = a.ours ? a.ours + count : NULL;
    if (a.vertices && a.indices && a.rays && a.hits && a.records && a.ours)
        ok = animate(&a);
    else
        message("no memory for %u x %u rays and the mesh", a.size, a.size);
    if (ok)
        print(&a);
    free(a.vertices);
    free(a.indices);
    free(a.rays);
    free(a.hits);
    free(a.records);
    free(a.ours);
    return ok ? 0 : 1;
}
