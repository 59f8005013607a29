// Compiled with -O3 (src/CMakeLists.txt): the loop of add() is most of what prefiltering costs.
#include "row_sums.hpp"
#include <algorithm>
#include <cmath>

namespace prelight::resident {

RowSums::RowSums(const Image& image, uint32_t channels, uint32_t step)
    : width_(image.width), height_(image.height), channels_(channels), step_(step), run_(2 * size_t(width_) / step + 1),
      stride_(run_ * step), sums_(stride_ * channels * height_) {
    for (uint32_t y = 0; y < height_; ++y)
        for (uint32_t channel = 0; channel < channels; ++channel) {
            double* sums = &sums_[(size_t(y) * channels_ + channel) * stride_];
            double sum = 0;
            for (uint32_t x = 0; x <= 2 * width_; ++x) {
                sums[index(x)] = sum;
                sum += static_cast<double>(image.at(x % width_, y)[static_cast<int>(channel)]);
            }
        }
}

RowSums::Place RowSums::place_of(double column) const {
    const double turns = std::floor(column / width_), within = column - turns * width_;
    const auto first = std::min(static_cast<uint32_t>(within), width_ - 1);
    return {index(first), index(first + 1), within - first, turns};
}

void RowSums::add(std::span<double> out, uint32_t channel, const Window& window) const {
    const Place begin = place_of(window.from), end = place_of(window.from + window.columns);
    const double *upper = row(channel, window.upper), *lower = row(channel, window.lower);
    const double turns = (end.turns - begin.turns) *
                         (window.upper_weight * upper[index(width_)] + window.lower_weight * lower[index(width_)]);
    const double *u0 = upper + begin.sum, *u1 = upper + begin.next, *u2 = upper + end.sum, *u3 = upper + end.next;
    const double *l0 = lower + begin.sum, *l1 = lower + begin.next, *l2 = lower + end.sum, *l3 = lower + end.next;
    const double uw = window.upper_weight, lw = window.lower_weight;
    const double a0 = uw * (begin.share - 1), a1 = -uw * begin.share, a2 = uw * (1 - end.share), a3 = uw * end.share;
    const double b0 = lw * (begin.share - 1), b1 = -lw * begin.share, b2 = lw * (1 - end.share), b3 = lw * end.share;
    double* __restrict sums = out.data();
    for (size_t i = 0, count = out.size(); i < count; ++i)
        sums[i] += turns + a0 * u0[i] + a1 * u1[i] + a2 * u2[i] + a3 * u3[i] + b0 * l0[i] + b1 * l1[i] + b2 * l2[i] +
                   b3 * l3[i];
}

} // namespace prelight::resident
