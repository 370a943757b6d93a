#include "path_tracer/picture.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

// Brightness to a byte: a curve with a toe and a shoulder (Narkowicz's fit of the ACES
// curve), then a display's gamma.
unsigned char byte(float sum, unsigned samples)
{
    float x = 0.75f * sum / float(samples);
    x = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
    return static_cast<unsigned char>(255 * std::pow(std::min(x, 1.0f), 1 / 2.2f) + 0.5f);
}

} // namespace

std::vector<unsigned char> developed(const std::vector<vec> &picture, unsigned samples)
{
    std::vector<unsigned char> bytes;
    for (vec sum : picture)
        bytes.insert(bytes.end(), {byte(sum.x, samples), byte(sum.y, samples), byte(sum.z, samples)});
    return bytes;
}

void print_difference(const std::vector<unsigned char> &a, const std::vector<unsigned char> &b)
{
    std::size_t differ = 0;
    double sum = 0;
    int most = 0;
    for (std::size_t i = 0; i < a.size(); i += 3) {
        int apart = 0;
        for (std::size_t k = i; k < i + 3; k++) {
            apart = std::max(apart, std::abs(a[k] - b[k]));
            sum += std::abs(a[k] - b[k]);
        }
        differ += apart > 0;
        most = std::max(most, apart);
    }
    std::printf("the pictures: mean difference %.4f of 255, largest %d, %.2f %% of pixels differ\n",
                sum / double(a.size()), most, 300.0 * double(differ) / double(a.size()));
}
