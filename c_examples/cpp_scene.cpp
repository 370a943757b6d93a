// What it teaches: hug.hpp at work, and checked: scenes that own their memory, errors as
// values or as exceptions, spans, streams, saving, rebuilding, threads lent by lambda.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include "hug.hpp"

namespace {

void require(bool condition, const char *what)
{
    if (condition)
        return;
    std::fprintf(stderr, "cpp_scene: %s\n", what);
    std::exit(1);
}

constexpr unsigned side = 40;

// A wavy square over [0, side] x [0, side].
struct mesh {
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;

    explicit mesh(float height)
    {
        for (unsigned i = 0; i <= side * (side + 2); i++) {
            float x = float(i % (side + 1)), y = float(i / (side + 1));
            vertices.insert(vertices.end(), {x, y, height + float(i % 3) / 4});
        }
        for (unsigned y = 0; y < side; y++)
            for (unsigned x = 0; x < side; x++) {
                unsigned a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
                indices.insert(indices.end(), {a, b, c, b, d, c});
            }
    }
};

std::vector<hug::ray> rays_from_above()
{
    std::vector<hug::ray> rays;
    for (unsigned i = 0; i < 500; i++)
        rays.push_back(hug::make_ray({float(i % 25) * 1.9f, float(i / 25) * 2.3f, 9}, {0, 0, -1}));
    return rays;
}

void check_queries(hug::scene_view scene)
{
    std::vector<hug::ray> rays = rays_from_above();
    std::vector<hug::hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    hug::counters counted{};
    std::size_t found = 0;
    scene.intersect(rays, hits);
    scene.occluded(rays, blocked);
    for (std::size_t i = 0; i < rays.size(); i++) {
        hug::hit one = scene.intersect(rays[i]), same = scene.intersect(rays[i], counted);
        require(std::memcmp(&one, &hits[i], sizeof one) == 0, "a stream's hit is another");
        require(std::memcmp(&one, &same, sizeof one) == 0, "a counted query's hit is another");
        require(scene.occluded(rays[i]) == hug::is_hit(one), "occluded and hit differ");
        require(scene.occluded(rays[i]) == bool(blocked[i]), "a stream's occlusion is another");
        found += hug::is_hit(one);
        hug::hit behind = scene.intersect(hug::skipping(rays[i], one));
        require(!hug::is_hit(one) || behind.prim != one.prim, "the triangle to skip was hit");
    }
    require(found > 100 && found < rays.size(), "not some of the rays hit");
    require(counted.voxels > 0 && counted.hits >= found, "nothing was counted");
}

void check_errors()
{
    float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint32_t wrong[3] = {0, 1, 7};
    auto failed = hug::builder().add(triangle, wrong).build();
    require(!failed && failed.code() == HUG_ERROR_INDEX_RANGE, "a wrong index was taken");
    require(std::strlen(failed.message()) > 10, "the error says nothing");
    try {
        hug::builder().add(triangle, wrong).build().value();
        require(false, "value() of an error came back");
    } catch (const hug::error &error) {
        require(error.code() == HUG_ERROR_INDEX_RANGE, "the exception has another code");
    }
    require(!hug::scene_view::open({}), "nothing was opened as a scene");
    auto stop = [](double) { return false; };
    auto cancelled = hug::builder().add(triangle).progress(stop).build();
    require(cancelled.code() == HUG_ERROR_CANCELLED, "the build was not cancelled");
}

// What hug_queries.hpp wraps.
void check_more_queries(hug::scene_view scene)
{
    std::size_t hits = 0;
    for (const hug::ray &ray : rays_from_above()) {
        hug::hit first = scene.intersect(ray), room[4];
        auto all = hug::intersect_all(scene, ray, room);
        require(all && (all->count > 0) == hug::is_hit(first), "all hits and one differ");
        auto others = [&](std::size_t, const hug::ray &, const hug::hit &at) {
            return at.prim != first.prim;
        };
        hug::hit next = hug::intersect_filtered(scene, ray, others);
        require(!hug::is_hit(first) || next.prim != first.prim, "a rejected hit was taken");
        hug::for_each_hit(scene, ray, [&](const hug::hit &) { return hits++, true; });
    }
    hug::nearest near = hug::closest_point(scene, hug::make_probe({3, 3, 9}));
    require(hits > 0 && hug::is_found(near), "nothing is near");
}

// Same bytes with threads and without; they can be opened where they are.
void check_building(const mesh &of)
{
    auto threads = [](std::size_t tasks, auto task) {
        auto half = [&](std::size_t from) {
            for (std::size_t i = from; i < tasks; i += 2)
                task(i);
        };
        std::thread other(half, 1);
        half(0);
        other.join();
    };
    double last = -1;
    auto watch = [&](double fraction) { return last = fraction, true; };
    hug::builder recipe;
    recipe.add(of.vertices, of.indices).structure(HUG_STRUCTURE_RECURSIVE);
    hug::scene alone = recipe.build().value();
    hug::scene shared = recipe.parallel_for(threads).progress(watch).build().value();
    hug::span<const std::byte> a = alone.data(), b = shared.data();
    require(last == 1, "the progress did not end at 1");
    require(a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size()) == 0,
            "threads changed the scene");
    check_queries(hug::scene_view::open(a).value());
    check_more_queries(alone);
}

void check_owning(const mesh &first, const mesh &second)
{
    hug::builder recipe;
    hug::scene scene =
        recipe.add(first.vertices, first.indices).flags(HUG_BUILD_KEEP_SCRATCH).build().value();
    hug::scene moved = std::move(scene);
    require(!scene.get() && moved.get(), "a moved scene is in two places");
    require(!scene.occluded(hug::make_ray({1, 1, 9}, {0, 0, -1})), "no scene has a hit");
    scene = std::move(moved);
    check_queries(scene);
    float before = scene.bounds().upper[2];
    hug::builder again;
    require(again.add(second.vertices, second.indices).rebuild(scene) == HUG_OK, "not rebuilt");
    require(scene.bounds().upper[2] > before, "the rebuilt scene is the old one");
    require(scene.stats().triangles == first.indices.size() / 3, "not all triangles are there");
}

} // namespace

int main()
{
    mesh low(0), high(2);
    check_errors();
    check_building(low);
    check_owning(low, high);
    std::printf("cpp_scene: ok, hug %s\n", hug_version());
}
