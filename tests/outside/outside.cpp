// A C++ program of somebody else's, built by CMake against an installed hug.
#include <cstdio>
#include <hug.hpp>
#include <vector>

int main()
{
    std::vector<float> vertices{0, 0, 0, 1, 0, 0, 0, 1, 0};
    auto scene = hug::builder().add(vertices).build();
    if (!scene) {
        std::fprintf(stderr, "%s\n", scene.message());
        return 1;
    }
    hug::hit hit = scene->intersect(hug::make_ray({0.25f, 0.5f, 2}, {0, 0, -1}));
    std::printf("hug %s: t %g\n", hug_version(), hit.t);
    return !hug::is_hit(hit);
}
