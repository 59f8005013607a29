#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace prelight {

/// One channel of a picture in double precision, row by row.
struct Plane {
    uint32_t width = 0, height = 0;
    std::vector<double> values;
    Plane(uint32_t w, uint32_t h) : width(w), height(h), values(size_t(w) * h, 0.0) {}
};

/// Weights of a one-dimensional filter at −radius … radius; the number of weights is odd.
using Kernel = std::vector<double>;

template <typename Function>
Kernel make_kernel(int radius, Function weight) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x)
        kernel.push_back(weight(x));
    return kernel;
}

/// Scales the positive weights to sum to 1 and the negative ones to sum to −1.
void normalise_signs(Kernel& kernel);

/// Correlates rows with `along_x`, then columns with `along_y`. The picture's border is repeated
/// outwards.
Plane separable(const Plane& plane, const Kernel& along_x, const Kernel& along_y);

} // namespace prelight
