// What it teaches: hug in a renderer. A path tracer with diffuse and mirror surfaces,
// coloured by primitive id, under a sun and a sky, or lit by a lamp. It follows batches of
// paths, so its rays go to hug as streams (path_tracer/paths.cpp); a ray that leaves a
// surface names the triangle it starts on, so there is no epsilon (hug::skipping). Asking
// Embree instead is one class (path_tracer/kernel.cpp); --kernel both renders with each
// and says what they took and how far the pictures are apart. The picture is written
// again each time the number of samples has doubled.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stb_image_write.h>
#include <stdexcept>
#include <string>

#include "path_tracer/lamp.hpp"
#include "path_tracer/paths.hpp"
#include "path_tracer/picture.hpp"

extern "C" {
#include "camera.h"
#include "clocks.h"
#include "message.h"
#include "options.h"
}

namespace {

const char help[] =
    "usage: path_tracer [options]\n"
    "\n"
    "  --scene SCENE    a file that Assimp reads, also one in the folder $HUG_SCENES, or a\n"
    "                   built-in scene (default: city)\n"
    "  --view NAME, --cameras FILE, --camera NUMBERS\n"
    "                   where to look from: see render --help\n"
    "  --kernel NAME    hug, embree or both (default: hug)\n"
    "  --size N         pixels along each side (default: 512)\n"
    "  --samples N      paths a pixel (default: 16)\n"
    "  --bounces N      most surfaces a path leaves (default: 4)\n"
    "  --lamp X,Y,Z     a lamp there; or none; or auto, the default: one below the ceiling if\n"
    "                   hardly any daylight reaches the eye\n"
    "  --out FILE.png   the picture (default: path_tracer.png); with both, Embree's gets\n"
    "                   -embree before the ending\n"
    "  --help           this text\n";

const char *const kernel_names[] = {"hug", "embree", "both"};
enum { with_hug, with_embree, with_both };

struct settings {
    const char *scene_name = "city", *out = "path_tracer.png";
    camera_options camera{};
    enum { automatic, none, given } lamp = automatic;
    float lamp_at[3]{};
    unsigned kernels = with_hug;
    unsigned long size = 0, samples = 0, bounces = 0;
    int help = 0;
};

bool read_settings(int argc, char **argv, settings &s)
{
    const char *which = "hug", *size = "512", *samples = "16", *bounces = "4",
               *lamp = "auto";
    const option table[] = {{"--scene", &s.scene_name, nullptr},
                            {"--view", &s.camera.view, nullptr},
                            {"--cameras", &s.camera.file, nullptr},
                            {"--camera", &s.camera.camera, nullptr},
                            {"--kernel", &which, nullptr},
                            {"--size", &size, nullptr},
                            {"--samples", &samples, nullptr},
                            {"--bounces", &bounces, nullptr},
                            {"--lamp", &lamp, nullptr},
                            {"--out", &s.out, nullptr},
                            {"--help", nullptr, &s.help}};
    if (!options_parse(argc, argv, table, sizeof table / sizeof *table))
        return false;
    if (std::strcmp(lamp, "none") == 0)
        s.lamp = settings::none;
    else if (std::strcmp(lamp, "auto") != 0)
        s.lamp = settings::given;
    return (s.lamp != settings::given || parse_floats("--lamp", lamp, s.lamp_at, 3)) &&
           parse_one("--kernel", which, kernel_names, 3, &s.kernels) &&
           parse_count("--size", size, 1, 8192, &s.size) &&
           parse_count("--samples", samples, 1, 100000, &s.samples) &&
           parse_count("--bounces", bounces, 0, 64, &s.bounces);
}

std::vector<unsigned char> render(const settings &s, const world &of, const kit_view &view,
                                  kernel &by, const char *name, const std::string &out)
{
    constexpr std::size_t batch = 16384;
    unsigned size = unsigned(s.size);
    std::size_t pixels = std::size_t(size) * size;
    std::vector<vec> picture(pixels);
    std::vector<unsigned char> bytes;
    paths tracer(of, by, view, size, unsigned(s.bounces));
    progress bar;
    progress_start(&bar, name, s.samples * pixels);
    double start = seconds_thread();
    for (unsigned sample = 1; sample <= s.samples; sample++) {
        for (std::size_t first = 0; first < pixels; first += batch) {
            tracer.add_sample(sample, first, std::min(batch, pixels - first), picture);
            progress_at(&bar, (sample - 1) * pixels + first);
        }
        if ((sample & (sample - 1)) != 0 && sample != s.samples)
            continue;
        bytes = developed(picture, sample);
        int side = int(size);
        if (!stbi_write_png(out.c_str(), side, side, 3, bytes.data(), 3 * side))
            throw std::runtime_error(out + ": cannot be written");
    }
    double seconds = seconds_thread() - start;
    progress_end(&bar);
    std::printf("%-7s build %7.1f ms, queries %7.2f s (%.2f M rays/s), all of it %7.2f s: %s\n",
                name, 1e3 * by.build_seconds, by.query_seconds,
                1e-6 * double(by.rays) / by.query_seconds, seconds, out.c_str());
    return bytes;
}

// Both kernels render the same world: the lamp is where the first of them finds a place.
void light(const settings &s, kernel &by, const kit_view &view, world &of)
{
    vec at{s.lamp_at[0], s.lamp_at[1], s.lamp_at[2]};
    if (s.lamp == settings::none || (s.lamp == settings::automatic && !lamp_is_needed(by, view, &at)))
        return;
    vec away = at - vec{view.eye[0], view.eye[1], view.eye[2]};
    if (!(dot(away, away) > 0))
        throw std::runtime_error("--lamp: no place for one at the eye itself");
    of.hang_lamp(at, std::sqrt(dot(away, away)));
    std::printf("a lamp at %g,%g,%g\n", double(at.x), double(at.y), double(at.z));
}

void run(const settings &s, const scene &from, const kit_view &view)
{
    world of(from, unit({view.up[0], view.up[1], view.up[2]}));
    std::vector<unsigned char> ours, theirs;
    std::string out = s.out, other = out;
    if (s.kernels == with_both) {
        std::size_t dot = other.rfind('.');
        other.insert(dot == std::string::npos ? other.size() : dot, "-embree");
    }
    std::printf("%s: %zu triangles, %lu x %lu pixels, %lu samples\n", from.name,
                from.triangle_count, s.size, s.size, s.samples);
    if (s.kernels != with_embree) {
        hug_kernel by(from);
        light(s, by, view, of);
        ours = render(s, of, view, by, "hug", out);
    }
    if (s.kernels != with_hug) {
        embree_kernel by(from);
        if (s.kernels == with_embree)
            light(s, by, view, of);
        theirs = render(s, of, view, by, "Embree", other);
    }
    if (s.kernels == with_both)
        print_difference(ours, theirs);
}

} // namespace

int main(int argc, char **argv)
{
    settings s;
    scene from;
    kit_view view;
    int code = 1;
    message_program("path_tracer");
    if (!read_settings(argc, argv, s))
        return 2;
    if (s.help)
        return std::fputs(help, stdout) < 0;
    if (scene_load(s.scene_name, &from) && camera_choose(&s.camera, &from, &view)) {
        try {
            run(s, from, view);
            code = 0;
        } catch (const std::exception &error) {
            message("%s: %s", from.name, error.what());
        }
    }
    scene_free(&from);
    return code;
}
