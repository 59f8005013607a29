#pragma once
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <prelight/scene.hpp>

/// Textures from functions of the place in them, each axis 0 … 1, v downwards.
namespace prelight::map_painting {

inline constexpr uint32_t size = 256; ///< texels a side

inline uint8_t code(double value) { return static_cast<uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0))); }
inline glm::dvec4 texel(glm::dvec3 rgb) { return {rgb, 1}; }
inline glm::dvec4 texel(glm::dvec4 rgba) { return rgba; }

/// `value(u, v)`: dvec3 or dvec4, components 0 … 1.
template <class Function>
TextureImage map_of(const char* name, Function value) {
    TextureImage image{.name = name, .width = size, .height = size, .rgba = {}};
    image.rgba.reserve(size_t(4) * size * size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const glm::dvec4 v = texel(value((x + 0.5) / size, (y + 0.5) / size));
            image.rgba.insert(image.rgba.end(), {code(v.x), code(v.y), code(v.z), code(v.w)});
        }
    return image;
}

/// A normal map of heights in the unit of texture coordinates.
template <class Height>
TextureImage normals_of(const char* name, Height height) {
    return map_of(name, [&](double u, double v) {
        constexpr double step = 0.5 / size;
        const double du = (height(u + step, v) - height(u - step, v)) / (2 * step);
        const double dv = (height(u, v + step) - height(u, v - step)) / (2 * step);
        return glm::normalize(glm::dvec3(-du, dv, 1)) * 0.5 + 0.5; // +Y up, v runs down
    });
}

inline double smooth(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace prelight::map_painting
