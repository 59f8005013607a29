#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/decal_maps.hpp>
#include <scene/procedural/map_painting.hpp>

namespace prelight {
namespace {

using namespace map_painting;

double from_middle(double u, double v) { return 2 * std::hypot(u - 0.5, v - 0.5); }

double noise(double u, double v, uint32_t seed) {
    static const city::TileNoise fields[] = {city::TileNoise(6, 11, 4), city::TileNoise(5, 23, 3),
                                             city::TileNoise(24, 5, 3)};
    return fields[seed](glm::vec2(u, v));
}

/// 1 in a crack, 0 beside it: the borders between cells of a bent lattice, wider in the middle.
double crack(double u, double v) {
    const double bend = 0.08 * (noise(u, v, 1) - 0.5);
    static const city::TileCells lattice(4, 7);
    const city::Cellular cells = lattice(glm::vec2(u + bend, v - bend));
    const double width = 0.11 * (1 - smooth(0.25, 0.95, from_middle(u, v) + 0.3 * (noise(u, v, 0) - 0.5)));
    return width > 0 ? 1 - smooth(0.3 * width, width, static_cast<double>(cells.second - cells.nearest)) : 0;
}

/// Height of bolts' heads, 0 … 1.
double bolt(double u, double v) {
    const double x = u * 4 - std::floor(u * 4) - 0.5, y = v * 2 - std::floor(v * 2) - 0.5;
    const double r = std::hypot(x, y) / 0.3;
    return r < 1 ? std::sqrt(1 - r * r) : 0;
}

} // namespace

TextureImage crack_colours() {
    return map_of("crack colours", [](double u, double v) {
        const double depth = crack(u, v);
        return glm::dvec4(glm::dvec3(0.16, 0.14, 0.13), depth);
    });
}

TextureImage crack_normals() {
    return normals_of("crack normals", [](double u, double v) { return -0.012 * crack(u, v); });
}

TextureImage arrow() {
    return map_of("arrow", [](double u, double v) {
        const double x = std::abs(u - 0.5), head = (v - 0.08) * 0.75;
        const bool in = v < 0.5 ? v > 0.08 && x < head : v < 0.94 && x < 0.11;
        const double worn = smooth(0.26, 0.36, noise(u, v, 0));
        return glm::dvec4(0.95, 0.78, 0.12, in ? worn : 0.0);
    });
}

TextureImage target() {
    return map_of("target", [](double u, double v) {
        const double r = from_middle(u, v), line = std::min(std::abs(u - 0.5), std::abs(v - 0.5));
        const double ring = smooth(0.06, 0.04, std::abs(r - 0.8)), cross = r < 0.95 ? smooth(0.018, 0.01, line) : 0;
        return glm::dvec4(0.85, 0.1, 0.08, std::max(ring, cross));
    });
}

TextureImage bolt_colours() {
    return map_of("bolt colours",
                  [](double u, double v) { return glm::dvec4(0.72, 0.73, 0.76, smooth(0.02, 0.1, bolt(u, v))); });
}

TextureImage bolt_normals() {
    return normals_of("bolt normals", [](double u, double v) { return 0.06 * bolt(u, v); });
}

TextureImage puddle() {
    return map_of("puddle", [](double u, double v) {
        return glm::dvec4(1, 1, 1, smooth(0.9, 0.72, from_middle(u, v) + 0.7 * (noise(u, v, 1) - 0.5)));
    });
}

TextureImage scorch() {
    return map_of("scorch", [](double u, double v) {
        const double soot = smooth(1.0, 0.25, from_middle(u, v) + 0.5 * (noise(u, v, 2) - 0.5));
        return glm::dvec4(0.1, 0.09, 0.08, soot * soot);
    });
}

} // namespace prelight
