#include "reflectance_table.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace prelight::resident {
namespace {

constexpr uint32_t size = 32, samples = 512;

/// Half vectors by their density D N·H; what is left of the integrand is V N·L 4 V·H / N·H.
glm::vec3 reflectance(double nv, double roughness) {
    const double alpha2 = std::pow(std::max(roughness, 1e-2), 4), vx = std::sqrt(1 - nv * nv);
    double all = 0, grazing = 0;
    for (uint32_t i = 0; i < samples; ++i) {
        const double e = (i + 0.5) / samples, azimuth = 2 * std::numbers::pi * std::fmod(i * std::numbers::phi, 1.0);
        const double nh2 = (1 - e) / (1 + (alpha2 - 1) * e), nh = std::sqrt(nh2);
        const double vh = vx * std::sqrt(std::max(1 - nh2, 0.0)) * std::cos(azimuth) + nv * nh, nl = 2 * vh * nh - nv;
        if (vh <= 0 || nl <= 0)
            continue;
        const double smith =
            (nl + std::sqrt(alpha2 + (1 - alpha2) * nl * nl)) * (nv + std::sqrt(alpha2 + (1 - alpha2) * nv * nv));
        const double share = nl * 4 * vh / (nh * smith);
        all += share;
        grazing += share * std::pow(1 - vh, 5);
    }
    return {float((all - grazing) / samples), float(grazing / samples), 0};
}

} // namespace

Image make_reflectance_table() {
    Image table(size, size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            table.at(x, y) = reflectance(std::max(x / (size - 1.0), 1e-3), y / (size - 1.0));
    return table;
}

} // namespace prelight::resident
