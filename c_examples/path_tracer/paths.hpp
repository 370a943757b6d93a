// A path tracer that follows many paths at a time, so that its kernel is asked for
// streams of rays: all paths of a batch meet their next surface, then all look at the sun
// and the lamp.
#ifndef PATHS_HPP
#define PATHS_HPP

#include <vector>

#include "path_tracer/kernel.hpp"
#include "path_tracer/world.hpp"

class paths {
public:
    paths(const world &of, kernel &by, const kit_view &from, unsigned size, unsigned bounces);

    // Adds one sample to pixels first to first + count of a picture of size x size.
    void add_sample(std::uint32_t sample, std::size_t first, std::size_t count,
                    std::vector<vec> &picture);

private:
    struct path {
        vec throughput;
        std::uint32_t pixel;
        bool sees_sun; // its last surface was a mirror, or it comes from the eye
        sequence random;
    };

    void start(std::uint32_t sample, std::size_t first, std::size_t count);
    void meet(std::vector<vec> &picture, bool last);
    void look_at_lights(std::vector<vec> &picture);
    void ask(const hug::ray &ray, vec light, std::uint32_t pixel);
    void leave(path of, const hug::ray &ray, const hug::hit &hit, bool last);

    const world &world_;
    kernel &kernel_;
    vec eye_, ahead_, right_, up_;
    unsigned size_, bounces_;
    std::vector<path> paths_, next_;
    std::vector<hug::ray> rays_, next_rays_, to_lights_;
    std::vector<hug::hit> hits_;
    std::vector<vec> light_;
    std::vector<std::uint32_t> light_pixels_;
    std::vector<std::uint8_t> blocked_;
};

#endif
