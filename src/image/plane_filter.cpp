#include <algorithm>
#include <image/plane_filter.hpp>

namespace prelight {

void normalise_signs(Kernel& kernel) {
    double positive = 0, negative = 0;
    for (const double weight : kernel)
        (weight > 0 ? positive : negative) += weight;
    for (double& weight : kernel)
        weight /= weight > 0 ? positive : negative < 0 ? -negative : 1;
}

Plane separable(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
    const auto width = static_cast<ptrdiff_t>(plane.width);
    const auto height = static_cast<ptrdiff_t>(plane.height);
    const auto radius_x = static_cast<ptrdiff_t>(along_x.size() / 2);
    const auto radius_y = static_cast<ptrdiff_t>(along_y.size() / 2);

    Plane rows(plane.width, plane.height);
    std::vector<double> line(static_cast<size_t>(width + 2 * radius_x));
    for (ptrdiff_t y = 0; y < height; ++y) {
        const double* in = plane.values.data() + y * width;
        for (ptrdiff_t x = 0; x < width + 2 * radius_x; ++x)
            line[static_cast<size_t>(x)] = in[std::clamp<ptrdiff_t>(x - radius_x, 0, width - 1)];
        double* out = rows.values.data() + y * width;
        for (size_t k = 0; k < along_x.size(); ++k)
            for (ptrdiff_t x = 0; x < width; ++x)
                out[x] += along_x[k] * line[static_cast<size_t>(x) + k];
    }

    Plane result(plane.width, plane.height);
    for (ptrdiff_t y = 0; y < height; ++y) {
        double* out = result.values.data() + y * width;
        for (size_t k = 0; k < along_y.size(); ++k) {
            const ptrdiff_t row = std::clamp<ptrdiff_t>(y + static_cast<ptrdiff_t>(k) - radius_y, 0, height - 1);
            const double* in = rows.values.data() + row * width;
            for (ptrdiff_t x = 0; x < width; ++x)
                out[x] += along_y[k] * in[x];
        }
    }
    return result;
}

} // namespace prelight
