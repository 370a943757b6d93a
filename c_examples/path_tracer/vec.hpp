// Three floats, and random numbers.
#ifndef VEC_HPP
#define VEC_HPP

#include <cmath>
#include <cstdint>

struct vec {
    float x, y, z;
};

inline vec operator+(vec a, vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vec operator-(vec a, vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec operator*(vec a, vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline vec operator*(vec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline float dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vec cross(vec a, vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline vec unit(vec a) { return a * (1 / std::sqrt(dot(a, a))); }
inline float luminance(vec a) { return 0.2126f * a.x + 0.7152f * a.y + 0.0722f * a.z; }

// Two unit vectors at right angles to n and to each other.
inline void frame_of(vec n, vec &a, vec &b)
{
    a = unit(cross(std::fabs(n.x) > 0.6f ? vec{0, 1, 0} : vec{1, 0, 0}, n));
    b = cross(n, a);
}

inline std::uint32_t mixed(std::uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// A sequence for each pixel and sample, whatever else is traced.
class sequence {
public:
    sequence() = default;
    sequence(std::uint32_t pixel, std::uint32_t sample)
        : state_(mixed(pixel ^ mixed(sample + 0x9e3779b9u)))
    {
    }
    float next() // in [0, 1)
    {
        state_ = state_ * 747796405u + 2891336453u;
        return float(mixed(state_) >> 8) * (1.0f / 16777216);
    }

private:
    std::uint32_t state_ = 0;
};

#endif
