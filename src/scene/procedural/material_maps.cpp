#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <scene/environment_codes.hpp>
#include <scene/procedural/map_painting.hpp>
#include <scene/procedural/material_maps.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

using namespace map_painting;

/// Which brick, and how far inside it from its nearest edge.
struct Brick {
    int row, column;
    double inside;
};

Brick brick_at(double u, double v) {
    constexpr int rows = 8, columns = 8;
    v -= std::floor(v);
    u -= std::floor(u);
    const int row = std::min(int(v * rows), rows - 1);
    double across = u * columns + (row % 2 ? 0.5 : 0);
    const int column = int(std::floor(across)) % columns;
    across -= std::floor(across);
    const double down = v * rows - row;
    return {row, column, std::min({across, 1 - across, down, 1 - down})};
}

} // namespace

double brick_height(double u, double v) { return smooth(0.04, 0.16, brick_at(u, v).inside); }

TextureImage brick_colours() {
    return map_of("brick colours", [](double u, double v) {
        const Brick b = brick_at(u, v);
        const double shade = 0.75 + 0.25 * std::sin(12.9 * b.row + 7.3 * b.column);
        return b.inside < 0.08 ? glm::dvec3(0.62, 0.6, 0.56) : shade * glm::dvec3(0.72, 0.36, 0.26);
    });
}

TextureImage brick_heights() {
    return map_of("brick heights", [](double u, double v) { return glm::dvec3(brick_height(u, v)); });
}

TextureImage brick_normals() {
    return normals_of("brick normals", [](double u, double v) { return 0.012 * brick_height(u, v); });
}

TextureImage hammered_normals() {
    return normals_of("hammered normals", [](double u, double v) {
        return 0.004 * (std::sin(full_turn * 12 * u) * std::sin(full_turn * 12 * v) +
                        0.5 * std::sin(full_turn * (7 * u + 9 * v)));
    });
}

TextureImage bands() {
    return map_of("bands",
                  [](double, double v) { return glm::dvec3(smooth(-0.15, 0.15, std::sin(full_turn * 2 * v))); });
}

TextureImage checks() {
    return map_of("checks",
                  [](double u, double v) { return glm::dvec3(0.15 + 0.85 * ((int(u * 16) + int(v * 8)) % 2)); });
}

TextureImage circuits() {
    return map_of("circuits", [](double u, double v) {
        const double across = std::abs(u * 8 - std::floor(u * 8) - 0.5),
                     down = std::abs(v * 6 - std::floor(v * 6) - 0.5);
        const double line = 1 - smooth(0.02, 0.06, std::min(across, down));
        return line * glm::dvec3(0.1, 0.8, 1);
    });
}

Environment make_studio() {
    Environment studio{.name = "studio", .image = Image(128, 64)};
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 128; ++x) {
            const double up = 90 - (y + 0.5) * 180 / 64, round = (x + 0.5) * 360 / 128 - 180; // degrees
            glm::dvec3 c =
                up > 0 ? glm::mix(glm::dvec3(0.5, 0.55, 0.6), glm::dvec3(0.12, 0.25, 0.6), smooth(0, 70, up))
                       : glm::mix(glm::dvec3(0.3, 0.27, 0.22), glm::dvec3(0.08, 0.07, 0.06), smooth(0, 60, -up));
            const double window = smooth(28, 22, std::abs(round - 120)) * smooth(22, 16, std::abs(up - 30));
            c += window * glm::dvec3(3, 2.8, 2.4);
            const double lamp = smooth(14, 6, std::hypot(round + 140, up - 45));
            c += lamp * glm::dvec3(6, 3.2, 1.2);
            studio.image.at(x, y) = from_rgbe(to_rgbe(glm::vec3(c)));
        }
    return studio;
}

} // namespace prelight
