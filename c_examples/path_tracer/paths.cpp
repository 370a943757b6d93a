#include "path_tracer/paths.hpp"

namespace {

hug::ray ray_along(vec org, vec dir) { return hug::make_ray({org.x, org.y, org.z}, {dir.x, dir.y, dir.z}); }

} // namespace

paths::paths(const world &of, kernel &by, const kit_view &from, unsigned size, unsigned bounces)
    : world_(of), kernel_(by), size_(size), bounces_(bounces)
{
    eye_ = {from.eye[0], from.eye[1], from.eye[2]};
    ahead_ = unit(vec{from.at[0], from.at[1], from.at[2]} - eye_);
    float half = std::tan(from.fov_deg * 3.14159265f / 360);
    right_ = unit(cross(ahead_, {from.up[0], from.up[1], from.up[2]})) * half;
    up_ = cross(right_, ahead_);
}

void paths::start(std::uint32_t sample, std::size_t first, std::size_t count)
{
    paths_.clear();
    rays_.clear();
    for (std::size_t i = first; i < first + count; i++) {
        std::uint32_t pixel = std::uint32_t(i);
        path of{{1, 1, 1}, pixel, true, sequence(pixel, sample)};
        float x = (float(pixel % size_) + of.random.next()) / float(size_) * 2 - 1;
        float y = 1 - (float(pixel / size_) + of.random.next()) / float(size_) * 2;
        paths_.push_back(of);
        rays_.push_back(ray_along(eye_, unit(ahead_ + right_ * x + up_ * y)));
    }
}

// This light reaches the pixel unless something is in the ray's way.
void paths::ask(const hug::ray &ray, vec light, std::uint32_t pixel)
{
    to_lights_.push_back(ray);
    light_.push_back(light);
    light_pixels_.push_back(pixel);
}

// A path goes on from a surface: mirrored, or with its lights noted and a new direction.
void paths::leave(path of, const hug::ray &ray, const hug::hit &hit, bool last)
{
    surface at = world_.surface_of(ray, hit);
    vec direction{ray.dir[0], ray.dir[1], ray.dir[2]};
    of.throughput = of.throughput * at.albedo;
    of.sees_sun = at.mirror;
    if (at.mirror) {
        direction = direction - at.normal * (2 * dot(direction, at.normal));
    } else {
        float first = of.random.next(), second = of.random.next();
        vec sun = world_.towards_sun(first, second);
        float cosine = dot(sun, at.normal);
        if (cosine > 0)
            ask(hug::skipping(ray_along(at.at, sun), hit),
                of.throughput * world_.sunlight() * cosine, of.pixel);
        if (world_.has_lamp()) {
            float third = of.random.next(), fourth = of.random.next();
            vec away = world_.lamp(third, fourth) - at.at;
            float distance = std::sqrt(dot(away, away));
            cosine = dot(away, at.normal) / distance;
            if (cosine > 0) {
                hug::ray to_lamp = ray_along(at.at, unit(away));
                to_lamp.tmax = distance;
                ask(hug::skipping(to_lamp, hit),
                    of.throughput * world_.lamplight(distance) * cosine, of.pixel);
            }
        }
        // Cosine-weighted.
        vec a, b;
        frame_of(at.normal, a, b);
        float radius = of.random.next(), angle = 6.2831853f * of.random.next();
        direction = a * (std::sqrt(radius) * std::cos(angle)) +
                    b * (std::sqrt(radius) * std::sin(angle)) +
                    at.normal * std::sqrt(1 - radius);
    }
    // Dark paths end early, the others stand for them.
    float survives = std::fmin(1.0f, 2 * luminance(of.throughput));
    if (last || of.random.next() >= survives)
        return;
    of.throughput = of.throughput * (1 / survives);
    next_.push_back(of);
    next_rays_.push_back(hug::skipping(ray_along(at.at, unit(direction)), hit));
}

void paths::meet(std::vector<vec> &picture, bool last)
{
    hits_.resize(rays_.size());
    kernel_.closest(rays_, hits_);
    next_.clear();
    next_rays_.clear();
    for (std::size_t i = 0; i < rays_.size(); i++) {
        const float *dir = rays_[i].dir;
        const path &of = paths_[i];
        if (hug::is_hit(hits_[i]))
            leave(of, rays_[i], hits_[i], last);
        else
            picture[of.pixel] = picture[of.pixel] +
                                of.throughput * world_.sky({dir[0], dir[1], dir[2]}, of.sees_sun);
    }
    paths_.swap(next_);
    rays_.swap(next_rays_);
}

void paths::look_at_lights(std::vector<vec> &picture)
{
    blocked_.resize(to_lights_.size());
    kernel_.occluded(to_lights_, blocked_);
    for (std::size_t i = 0; i < to_lights_.size(); i++)
        if (!blocked_[i])
            picture[light_pixels_[i]] = picture[light_pixels_[i]] + light_[i];
    to_lights_.clear();
    light_.clear();
    light_pixels_.clear();
}

void paths::add_sample(std::uint32_t sample, std::size_t first, std::size_t count,
                       std::vector<vec> &picture)
{
    start(sample, first, count);
    for (unsigned bounce = 0; bounce <= bounces_ && !rays_.empty(); bounce++) {
        meet(picture, bounce == bounces_);
        look_at_lights(picture);
    }
}
