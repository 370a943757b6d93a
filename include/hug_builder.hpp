// hug_builder.hpp - the builder of hug.hpp, which includes it: a hug_build_desc that is
// filled in by name.
#ifndef HUG_BUILDER_HPP
#define HUG_BUILDER_HPP

#include <vector>

#include "hug.hpp"

namespace hug {

// Borrows what it is given until the scene is built. Every setting has a default; what
// has no function here is a field of desc().
class builder {
public:
    builder() noexcept { desc_.struct_size = sizeof desc_; }

    // Packed x, y, z and packed triangles; without indices, three vertices a triangle.
    builder &add(span<const float> vertices, span<const std::uint32_t> indices,
                 std::uint32_t mask = 0)
    {
        return add(mesh(vertices, indices.data(), indices.size() / 3, HUG_INDEX_U32, mask));
    }
    builder &add(span<const float> vertices, span<const std::uint16_t> indices,
                 std::uint32_t mask = 0)
    {
        return add(mesh(vertices, indices.data(), indices.size() / 3, HUG_INDEX_U16, mask));
    }
    builder &add(span<const float> vertices, std::uint32_t mask = 0)
    {
        return add(mesh(vertices, nullptr, vertices.size() / 9, HUG_INDEX_NONE, mask));
    }
    builder &add(const hug_geometry &geometry)
    {
        geometries_.push_back(geometry);
        return *this;
    }

    builder &structure(hug_structure which) noexcept { return desc_.structure = which, *this; }
    builder &quality(hug_quality which) noexcept { return desc_.quality = which, *this; }
    builder &flags(std::uint32_t which) noexcept { return desc_.flags = which, *this; }

    // f(double fraction) -> bool, true to go on; f must not throw, and outlive the build.
    template <class F>
    builder &progress(F &f) noexcept
    {
        desc_.progress_user = std::addressof(f);
        desc_.progress = [](void *of, double fraction) noexcept -> std::int32_t {
            return (*static_cast<F *>(of))(fraction) ? 0 : 1;
        };
        return *this;
    }

    // f(std::size_t tasks, task) with task(std::size_t index): calls it once for every
    // index, on whatever threads, and returns when all calls have; as for progress.
    template <class F>
    builder &parallel_for(F &f) noexcept
    {
        desc_.parallel_user = std::addressof(f);
        desc_.parallel_for = [](void *of, std::size_t tasks, hug_task_fn run,
                                void *context) noexcept {
            (*static_cast<F *>(of))(tasks, [=](std::size_t index) { run(context, index); });
        };
        return *this;
    }

    // For fields without a function, and for hug_measure and hug_build_into.
    hug_build_desc &desc() noexcept
    {
        desc_.geometries = geometries_.data();
        desc_.geometry_count = geometries_.size();
        return desc_;
    }

    result<scene> build() noexcept { return scene::build(desc()); }
    status rebuild(scene &of) noexcept { return of.rebuild(desc()); }

private:
    static hug_geometry mesh(span<const float> vertices, const void *indices,
                             std::size_t triangles, hug_index_type type, std::uint32_t mask)
    {
        hug_geometry of{};
        of.vertices = vertices.data();
        of.vertex_count = vertices.size() / 3;
        of.indices = indices;
        of.triangle_count = triangles;
        of.index_type = type;
        of.mask = mask;
        return of;
    }

    hug_build_desc desc_{};
    std::vector<hug_geometry> geometries_;
};

} // namespace hug

#endif
