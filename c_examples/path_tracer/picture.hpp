// From sums of light to what a PNG file holds, and how far two of these are apart.
#ifndef PICTURE_HPP
#define PICTURE_HPP

#include <vector>

#include "path_tracer/vec.hpp"

// Three bytes a pixel, of pixels that are sums of so many samples.
std::vector<unsigned char> developed(const std::vector<vec> &picture, unsigned samples);

// Of pictures of the same size.
void print_difference(const std::vector<unsigned char> &a, const std::vector<unsigned char> &b);

#endif
