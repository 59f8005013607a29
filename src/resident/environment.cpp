#include "environment.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <numbers>
#include <parallel/parallel_for.hpp>
#include <prelight/error.hpp>

namespace prelight::resident {
namespace {

constexpr double pi = std::numbers::pi;
/// Of level 0, whatever the map has: the rougher levels are then wide enough to be mixed between texels.
constexpr uint32_t width = 1024;
constexpr uint32_t level_count = 7;

void check(const Environment& environment) {
    const Image& image = environment.image;
    if (image.height == 0 || image.width != 2 * image.height)
        throw Error(fmt::format("{}: an environment map is twice as wide as high, and this one has {}x{} pixels",
                                environment.name, image.width, image.height));
    for (const glm::vec3& p : image.pixels)
        for (int c = 0; c < 3; ++c)
            if (!(p[c] >= 0) || !std::isfinite(p[c]))
                throw Error(fmt::format("{}: a pixel of the environment map is negative or not finite", environment.name));
}

/// By area: what shrinks keeps its mean. A picture that is smaller stays.
Image shrink(const Image& source, uint32_t to) {
    if (source.width <= to)
        return source;
    Image out(to, to / 2);
    parallel_for(out.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < out.width; ++x) {
            const double scale = double(source.width) / to;
            const double x0 = x * scale, x1 = (x + 1) * scale, y0 = y * scale, y1 = (y + 1) * scale;
            glm::dvec3 sum(0);
            for (auto sy = uint32_t(y0); sy < std::min<double>(std::ceil(y1), source.height); ++sy)
                for (auto sx = uint32_t(x0); sx < std::min<double>(std::ceil(x1), source.width); ++sx) {
                    const double w = std::min<double>(sx + 1, x1) - std::max<double>(sx, x0);
                    const double h = std::min<double>(sy + 1, y1) - std::max<double>(sy, y0);
                    sum += w * h * glm::dvec3(source.pixels[size_t(sy) * source.width + sx]);
                }
            out.pixels[size_t(y) * to + x] = glm::vec3(sum / (scale * scale));
        }
    });
    return out;
}

/// Direction of the place (u, v) in 0 … 1: scene.hpp's Environment.
glm::dvec3 direction_of(double u, double v) {
    const double azimuth = (u - 0.5) * 2 * pi, polar = v * pi;
    return {std::sin(azimuth) * std::sin(polar), std::cos(polar), -std::cos(azimuth) * std::sin(polar)};
}

glm::dvec3 bilinear(const Image& image, glm::dvec3 d) {
    const double u = std::atan2(d.x, -d.z) / (2 * pi) + 0.5, v = std::acos(std::clamp(d.y, -1.0, 1.0)) / pi;
    const double x = u * image.width - 0.5, y = std::clamp(v * image.height - 0.5, 0.0, image.height - 1.0);
    const auto column = [&](double at) { return uint32_t((int64_t(at) + image.width) % image.width); };
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const uint32_t x0 = column(std::floor(x)), x1 = column(std::floor(x) + 1);
    const auto y0 = uint32_t(y), y1 = std::min(y0 + 1, image.height - 1);
    const auto at = [&](uint32_t px, uint32_t py) { return glm::dvec3(image.pixels[size_t(py) * image.width + px]); };
    return (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) + (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

Image widen(const Image& source) {
    Image out(width, width / 2);
    parallel_for(out.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < width; ++x)
            out.pixels[size_t(y) * width + x] = glm::vec3(bilinear(source, direction_of((x + 0.5) / width, (y + 0.5) / out.height)));
    });
    return out;
}

double radical_inverse(uint32_t bits) {
    double value = 0, half = 0.5;
    for (; bits; bits >>= 1, half /= 2)
        value += (bits & 1) * half;
    return value;
}

/// What a mirror of this roughness shows of `source`, seen along its normal: samples of the half vector by
/// their density D N·H, each light weighted by N·L.
Image rough(const Image& source, double roughness, uint32_t samples, uint32_t wide) {
    const double alpha2 = std::pow(roughness, 4);
    std::vector<std::pair<glm::dvec3, double>> lights; // around +Z
    for (uint32_t i = 0; i < samples; ++i) {
        const double e = radical_inverse(i), azimuth = 2 * pi * (i + 0.5) / samples;
        const double cosine2 = (1 - e) / (1 + (alpha2 - 1) * e), cosine = std::sqrt(cosine2);
        const double sine = std::sqrt(std::max(1 - cosine2, 0.0));
        const glm::dvec3 h(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
        const glm::dvec3 l = 2 * h.z * h - glm::dvec3(0, 0, 1);
        if (l.z > 0)
            lights.emplace_back(l, l.z);
    }
    Image out(wide, wide / 2);
    parallel_for(out.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < wide; ++x) {
            const glm::dvec3 n = direction_of((x + 0.5) / wide, (y + 0.5) / out.height);
            const glm::dvec3 t = glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), n));
            const glm::dvec3 b = glm::cross(n, t);
            glm::dvec3 sum(0);
            double weights = 0;
            for (const auto& [l, weight] : lights) {
                sum += weight * bilinear(source, t * l.x + b * l.y + n * l.z);
                weights += weight;
            }
            out.pixels[size_t(y) * wide + x] = glm::vec3(sum / weights);
        }
    });
    return out;
}

/// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001; divided by π.
void project(const Image& image, glm::vec3 (&out)[9]) {
    glm::dvec3 sums[9]{};
    for (uint32_t y = 0; y < image.height; ++y) {
        const double v = (y + 0.5) / image.height;
        const double area = 2 * pi / image.width * (std::cos(double(y) / image.height * pi) - std::cos((y + 1.0) / image.height * pi));
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::dvec3 d = direction_of((x + 0.5) / image.width, v);
            const double basis[9]{0.282095, 0.488603 * d.y, 0.488603 * d.z, 0.488603 * d.x, 1.092548 * d.x * d.y,
                                  1.092548 * d.y * d.z, 0.315392 * (3 * d.z * d.z - 1), 1.092548 * d.x * d.z,
                                  0.546274 * (d.x * d.x - d.y * d.y)};
            for (int i = 0; i < 9; ++i)
                sums[i] += area * basis[i] * glm::dvec3(image.pixels[size_t(y) * image.width + x]);
        }
    }
    constexpr double band[9]{1, 2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25, 0.25, 0.25, 0.25, 0.25};
    constexpr double scale[9]{0.282095, 0.488603, 0.488603, 0.488603, 1.092548, 1.092548, 0.315392, 1.092548, 0.546274};
    for (int i = 0; i < 9; ++i) // the basis' factors too, so that a shader multiplies by polynomials alone
        out[i] = glm::vec3(sums[i] * band[i] * scale[i]);
}

} // namespace

EnvironmentLevels prefilter(const Environment* environment) {
    EnvironmentLevels out;
    if (!environment) {
        out.images.emplace_back(1u, 1u);
        return out;
    }
    check(*environment);
    out.images.push_back(shrink(environment->image, width));
    if (out.images[0].width < width)
        out.images[0] = widen(environment->image);
    project(shrink(environment->image, 64), out.irradiance);
    for (uint32_t level = 1; level < level_count; ++level) {
        // From a smaller picture the wider the lobe is: each sample then stands for what lies between them.
        const Image source = shrink(environment->image, std::max(256u >> (level - 1), 32u));
        out.images.push_back(rough(source, double(level) / (level_count - 1), std::min(32u << level, 256u), width >> level));
    }
    return out;
}

shared::EnvironmentConstants environment_constants(const EnvironmentLevels& levels, double exposure) {
    shared::EnvironmentConstants constants{};
    for (int i = 0; i < 9; ++i)
        constants.irradiance[i] = glm::vec4(levels.irradiance[i] * float(exposure), 0);
    constants.levels = glm::vec4(float(levels.images.size() - 1), float(exposure), 0, 0);
    return constants;
}

gpu::UniqueSampler make_environment_sampler(const gpu::Context& context) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler handle = VK_NULL_HANDLE;
    gpu::check(vkCreateSampler(context.device(), &info, nullptr, &handle), "environment sampler");
    return {context.device(), handle};
}

} // namespace prelight::resident
