#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <scene/procedural/cookie_maps.hpp>

namespace prelight {
namespace {

constexpr double pi = std::numbers::pi;

uint8_t code(double value) { return static_cast<uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0))); }

/// Each texel is the mean of sixteen places in it, so that edges are smooth.
template <class Colour>
TextureImage painted(const char* name, uint32_t width, uint32_t height, Colour colour) {
    constexpr int fine = 4;
    TextureImage image{.name = name, .width = width, .height = height, .rgba = {}};
    image.rgba.reserve(size_t(4) * width * height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            glm::dvec3 sum(0);
            for (int v = 0; v < fine; ++v)
                for (int u = 0; u < fine; ++u)
                    sum += colour((x + (u + 0.5) / fine) / width, (y + (v + 0.5) / fine) / height);
            sum /= fine * fine;
            image.rgba.insert(image.rgba.end(), {code(sum.x), code(sum.y), code(sum.z), 255});
        }
    return image;
}

/// Inside a star of five points around the origin, one of them up.
bool in_star(glm::dvec2 p, double radius) {
    const double fifth = 2 * pi / 5, off = std::abs(std::remainder(std::atan2(p.x, -p.y), fifth));
    const glm::dvec2 place = glm::length(p) * glm::dvec2(std::cos(off), std::sin(off));
    const glm::dvec2 tip(radius, 0), notch = 0.42 * radius * glm::dvec2(std::cos(fifth / 2), std::sin(fifth / 2));
    const glm::dvec2 edge = notch - tip, from_tip = place - tip;
    return edge.x * from_tip.y - edge.y * from_tip.x > 0; // the side of the origin
}

constexpr std::array<glm::dvec3, 5> glass{
    {{1, 0.85, 0.55}, {1, 0.45, 0.25}, {0.35, 0.7, 1}, {0.45, 0.95, 0.5}, {0.85, 0.5, 1}}};

} // namespace

TextureImage window_cookie() {
    return painted("window", 256, 256, [](double u, double v) {
        // Within a cone's circle: half as wide as high, round at the top.
        const double x = (u - 0.5) / 0.28, y = (v - 0.5) / 0.42;
        const double arch = y < -0.33 ? glm::length(glm::dvec2(x, (y + 0.33) / 0.667)) : std::abs(x);
        if (arch > 1 || y > 1)
            return glm::dvec3(0);
        const double column = (x + 1) * 1.5, row = (y + 1) * 2.5;
        const double across = std::abs(column - std::round(column)) / 1.5,
                     down = std::abs(row - std::round(row)) / 2.5 * 1.5;
        if (arch > 0.94 || across < 0.045 || down < 0.045)
            return glm::dvec3(0);
        return glass[size_t(int(column) * 2 + int(row) * 3) % glass.size()];
    });
}

TextureImage lantern_cookie() {
    return painted("lantern", 512, 256, [](double u, double v) {
        constexpr int rows = 6, columns = 12; // 30° each
        constexpr glm::dvec3 metal(0.012), lit(1, 0.8, 0.5);
        const double row = v * rows, column = u * columns + (int(row) % 2 ? 0.5 : 0.0);
        if (row < 0.6)
            return lit; // open above
        if (row < 1 || row >= 5)
            return metal;
        const glm::dvec2 place(column - std::floor(column) - 0.5, row - std::floor(row) - 0.5);
        const bool slit = std::abs(place.y) > 0.465 && row > 1.5 && row < 4.5;
        return slit || in_star(place, 0.4) ? lit : metal;
    });
}

TextureImage dice_cookie() {
    return painted("dice", 768, 128, [](double u, double v) {
        constexpr std::array<glm::dvec3, 6> colours{
            {{1, 0.5, 0.4}, {0.5, 1, 0.5}, {1, 1, 0.9}, {0.5, 0.7, 1}, {1, 0.9, 0.4}, {0.9, 0.6, 1}}};
        constexpr std::array<std::array<glm::dvec2, 6>, 6> pips{
            {{{{0, 0}}},
             {{{-1, -1}, {1, 1}}},
             {{{-1, -1}, {0, 0}, {1, 1}}},
             {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}},
             {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {0, 0}}},
             {{{-1, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {1, 1}}}}};
        const auto face = static_cast<size_t>(u * 6);
        const glm::dvec2 place(2 * (u * 6 - double(face)) - 1, 2 * v - 1);
        for (size_t pip = 0; pip <= face; ++pip)
            if (glm::distance(place, pips[face][pip] * 0.5) < 0.2)
                return colours[face];
        return std::max(std::abs(place.x), std::abs(place.y)) > 0.93 ? colours[face] * 0.6 : glm::dvec3(0.01);
    });
}

std::string wall_lamp_profile() {
    std::string text = "IESNA:LM-63-2002\n[TEST] procedural\n[MANUFAC] Prelight\n[LUMCAT] wall lamp\n[LUMINAIRE] beam, "
                       "ring and up-light\n"
                       "TILT=NONE\n1 1000 1 37 5 1 2 0.1 0.1 0.2\n1 1 12\n";
    for (int v = 0; v <= 180; v += 5)
        text += fmt::format("{}{}", v, v % 60 == 55 || v == 180 ? '\n' : ' ');
    text += "0 22.5 45 67.5 90\n";
    for (const double around : {0.0, 22.5, 45.0, 67.5, 90.0})
        for (int v = 0; v <= 180; v += 5) {
            const double wide = 14 + 10 * std::sin(around * pi / 180); // degrees: an oval beam
            const double beam = 900 * std::exp(-v * v / (2 * wide * wide));
            const double ring = 160 * std::exp(-(v - 48.0) * (v - 48.0) / 50);
            const double up = v > 120 ? 220 * std::pow(std::sin((v - 120) * pi / 120), 2) : 0;
            text += fmt::format("{}{}", std::lround(beam + ring + up), v % 60 == 55 || v == 180 ? '\n' : ' ');
        }
    return text;
}

} // namespace prelight
