// What it teaches: what hug.hpp adds to a call of hug.h, which is nothing. Each query is
// written twice, with the C functions and with the wrapper; a test compares the
// instructions of the two, and
//     cpp_cost plain|wrapped CALLS
// makes that many calls of each for a profiler that counts what is executed.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "hug.hpp"

#define SAME_CODE extern "C" __attribute__((noinline, visibility("default")))

SAME_CODE float plain_closest(const hug_scene *scene, const hug_ray *ray)
{
    hug_hit hit;
    hug_intersect(scene, ray, &hit);
    return hit.t;
}
SAME_CODE float wrapped_closest(const hug_scene *scene, const hug::ray *ray)
{
    return hug::scene_view(scene).intersect(*ray).t;
}

SAME_CODE bool plain_occluded(const hug_scene *scene, const hug_ray *ray)
{
    return hug_occluded(scene, ray) != 0;
}
SAME_CODE bool wrapped_occluded(const hug_scene *scene, const hug::ray *ray)
{
    return hug::scene_view(scene).occluded(*ray);
}

SAME_CODE void plain_stream(const hug_scene *scene, const hug_ray *rays, hug_hit *hits, size_t n)
{
    hug_intersect_n(scene, rays, 0, hits, 0, n);
}
SAME_CODE void wrapped_stream(const hug_scene *scene, const hug::ray *rays, hug::hit *hits,
                              size_t n)
{
    hug::scene_view(scene).intersect({rays, n}, {hits, n});
}

SAME_CODE hug_nearest plain_nearest(const hug_scene *scene, const hug_probe *probe)
{
    hug_nearest nearest;
    hug_closest_point(scene, probe, &nearest);
    return nearest;
}
SAME_CODE hug::nearest wrapped_nearest(const hug_scene *scene, const hug::probe *probe)
{
    return hug::closest_point(hug::scene_view(scene), *probe);
}

// Lets triangles of even numbers count.
static int32_t even(void *, size_t, const hug_ray *, const hug_hit *hit)
{
    return hit->prim % 2 == 0;
}
SAME_CODE float plain_filtered(const hug_scene *scene, const hug_ray *ray)
{
    char user;
    hug_hit hit;
    hug_intersect_filtered(scene, ray, &hit, even, &user);
    return hit.t;
}
SAME_CODE float wrapped_filtered(const hug_scene *scene, const hug::ray *ray)
{
    auto accept = [](size_t, const hug::ray &, const hug::hit &hit) { return hit.prim % 2 == 0; };
    return hug::intersect_filtered(hug::scene_view(scene), *ray, accept).t;
}

SAME_CODE size_t plain_all(const hug_scene *scene, const hug_ray *ray, hug_hit *room, size_t n)
{
    size_t count = 0;
    int32_t more = 0;
    if (hug_intersect_all(scene, ray, nullptr, room, n, &count, &more) != HUG_OK)
        return 0;
    return count + (more != 0);
}
SAME_CODE size_t wrapped_all(const hug_scene *scene, const hug::ray *ray, hug::hit *room, size_t n)
{
    auto found = hug::intersect_all(hug::scene_view(scene), *ray, {room, n});
    if (!found)
        return 0;
    return found->count + found->more;
}

SAME_CODE float plain_ray(const hug_scene *scene, const float *org)
{
    hug_ray ray = {{org[0], org[1], org[2]}, 0, {0, 0, -1}, 100, HUG_NONE, 0, HUG_NONE, HUG_NONE};
    hug_hit hit;
    hug_intersect(scene, &ray, &hit);
    return hit.t;
}
SAME_CODE float wrapped_ray(const hug_scene *scene, const float *org)
{
    hug::ray ray = hug::make_ray({org[0], org[1], org[2]}, {0, 0, -1}, 0, 100);
    return hug::scene_view(scene).intersect(ray).t;
}

int main(int argc, char **argv)
{
    float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    bool wrapped = argc > 1 && std::strcmp(argv[1], "wrapped") == 0;
    long calls = argc > 2 ? std::atol(argv[2]) : 1000;
    auto scene = hug::builder().add(triangle).build();
    if (!scene)
        return 1;
    const float org[3] = {0.25f, 0.5f, 2};
    hug::ray ray = hug::make_ray({org[0], org[1], org[2]}, {0, 0, -1});
    hug::probe probe = hug::make_probe({org[0], org[1], org[2]});
    hug::hit hit;
    float sum = 0;
    for (long i = 0; i < calls; i++)
        if (wrapped) {
            sum += wrapped_closest(scene->get(), &ray) + wrapped_ray(scene->get(), org);
            sum += wrapped_occluded(scene->get(), &ray);
            wrapped_stream(scene->get(), &ray, &hit, 1);
            sum += wrapped_nearest(scene->get(), &probe).distance;
            sum += wrapped_filtered(scene->get(), &ray);
            sum += float(wrapped_all(scene->get(), &ray, &hit, 1));
        } else {
            sum += plain_closest(scene->get(), &ray) + plain_ray(scene->get(), org);
            sum += plain_occluded(scene->get(), &ray);
            plain_stream(scene->get(), &ray, &hit, 1);
            sum += plain_nearest(scene->get(), &probe).distance;
            sum += plain_filtered(scene->get(), &ray);
            sum += float(plain_all(scene->get(), &ray, &hit, 1));
        }
    std::printf("%s %g\n", wrapped ? "wrapped" : "plain", double(sum));
}
