#include <algorithm>
#include <cmath>
#include <scene/environment_codes.hpp>

namespace prelight {

Rgbe to_rgbe(glm::vec3 radiance) {
    for (int c = 0; c < 3; ++c)
        radiance[c] = std::isfinite(radiance[c]) ? std::max(radiance[c], 0.0f) : 0.0f;
    const float largest = std::max({radiance.r, radiance.g, radiance.b});
    if (largest < 1e-32f)
        return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent); // largest < 2^exponent
    const auto mantissa = [&](float v) { return std::lround(std::ldexp(v, 8 - exponent)); };
    if (mantissa(largest) > 255)
        ++exponent;
    if (exponent > 127)
        return {255, 255, 255, 255};
    return {static_cast<uint8_t>(mantissa(radiance.r)), static_cast<uint8_t>(mantissa(radiance.g)),
            static_cast<uint8_t>(mantissa(radiance.b)), static_cast<uint8_t>(exponent + 128)};
}

glm::vec3 from_rgbe(Rgbe code) {
    if (code[3] == 0)
        return glm::vec3(0);
    const float scale = std::ldexp(1.0f, code[3] - 128 - 8);
    return glm::vec3(code[0], code[1], code[2]) * scale;
}

TextureImage to_picture(const std::string& name, const Image& map) {
    TextureImage picture{name, map.width, map.height, {}};
    for (const glm::vec3& p : map.pixels) {
        const Rgbe code = to_rgbe(p);
        picture.rgba.insert(picture.rgba.end(), code.begin(), code.end());
    }
    return picture;
}

Image from_picture(const TextureImage& picture) {
    Image map(picture.width, picture.height);
    for (size_t i = 0; i < map.pixels.size(); ++i) {
        const uint8_t* p = &picture.rgba[4 * i];
        map.pixels[i] = from_rgbe({p[0], p[1], p[2], p[3]});
    }
    return map;
}

} // namespace prelight
