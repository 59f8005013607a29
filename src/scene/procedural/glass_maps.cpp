#include <cmath>
#include <glm/vec4.hpp>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/glass_maps.hpp>
#include <scene/procedural/map_painting.hpp>

namespace prelight {

using map_painting::smooth;

TextureImage smoke_puff() {
    const city::TileNoise billows(4, 17, 3);
    const auto texel = [&](glm::vec2 uv) {
        const double out = 2 * std::hypot(double(uv.x) - 0.5, double(uv.y) - 0.5);
        const double edge = smooth(0.98, 0.05, out), uneven = 0.5 + 0.5 * smooth(0.3, 0.7, double(billows(uv)));
        return glm::vec4(1, 1, 1, static_cast<float>(edge * uneven));
    };
    return city::paint("smoke", 64, 64, texel, false);
}

TextureImage puff_slopes() {
    return map_painting::normals_of("puff slopes", [](double u, double v) {
        const double out = 2 * std::hypot(u - 0.5, v - 0.5);
        return 0.6 * std::sqrt(std::max(1 - out * out, 0.04));
    });
}

} // namespace prelight
