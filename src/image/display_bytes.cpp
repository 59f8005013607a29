#include <cmath>
#include <image/display_bytes.hpp>

namespace prelight {
namespace {

uint8_t to_byte(float value) {
    if (!(value > 0)) // also NaN, whose cast to an integer would be undefined
        return 0;
    return value >= 1 ? 255 : static_cast<uint8_t>(std::lround(value * 255));
}

} // namespace

std::vector<uint8_t> display_bytes(const Image& display) {
    std::vector<uint8_t> bytes;
    bytes.reserve(display.pixels.size() * 3);
    for (const glm::vec3& pixel : display.pixels)
        for (int channel = 0; channel < 3; ++channel)
            bytes.push_back(to_byte(pixel[channel]));
    return bytes;
}

} // namespace prelight
