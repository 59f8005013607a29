#include "environment.hpp"
#include "row_sums.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <gpu/check.hpp>
#include <numbers>
#include <parallel/parallel_for.hpp>
#include <scene/check_environment.hpp>
#include <span>

namespace prelight::resident {
namespace {

using std::numbers::pi;
/// Of level 0, whatever the map has: the rougher levels are then wide enough to be mixed between texels.
constexpr uint32_t width = 1024;
constexpr uint32_t mirror_levels = 7; ///< each with two steps of roughness
constexpr uint32_t widest_sky = 4096; ///< as the background shows it: 64 MiB

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

/// Bilinear, round in columns. A picture that is wide enough stays.
Image widen(const Image& source, uint32_t wide) {
    if (source.width >= wide)
        return source;
    Image out(wide, wide / 2);
    parallel_for(out.height, [&](uint32_t y) {
        const double row = std::clamp((y + 0.5) / out.height * source.height - 0.5, 0.0, source.height - 1.0);
        const auto y0 = uint32_t(row), y1 = std::min(y0 + 1, source.height - 1);
        const auto down = float(row - y0);
        for (uint32_t x = 0; x < wide; ++x) {
            const double column = (x + 0.5) / wide * source.width + source.width - 0.5; // above 0
            const uint32_t x0 = uint32_t(column) % source.width, x1 = (x0 + 1) % source.width;
            const auto across = float(column - std::floor(column));
            out.pixels[size_t(y) * wide + x] = glm::mix(glm::mix(source.at(x0, y0), source.at(x1, y0), across),
                                                        glm::mix(source.at(x0, y1), source.at(x1, y1), across), down);
        }
    });
    return out;
}

Image resize(const Image& source, uint32_t wide) { return widen(shrink(source, wide), wide); }

bool is_grey(const Image& image) {
    return std::ranges::all_of(image.pixels, [](const glm::vec3& p) { return p.r == p.g && p.g == p.b; });
}

/// Step 0 is a mirror, step 1 has a roughness of 1/8; four steps double it, so that a lobe is twice as wide after two.
double roughness_of(uint32_t step) { return step == 0 ? 0 : std::exp2((step - 1) / 4.0) / 8; }

double radical_inverse(uint32_t bits) {
    double value = 0, half = 0.5;
    for (; bits; bits >>= 1, half /= 2)
        value += (bits & 1) * half;
    return value;
}

/// One direction of a lobe.
struct LobeSample {
    glm::dvec3 light{0}; ///< around +Z
    double weight;
    double spread; ///< radians: the side of the square that it stands for
};

/// Of a mirror of this roughness, seen along its normal: half vectors by their density D N·H, each light weighted by
/// N·L.
std::vector<LobeSample> lobe(double roughness, uint32_t samples) {
    const double alpha2 = std::pow(roughness, 4);
    std::vector<LobeSample> out;
    double weights = 0;
    for (uint32_t i = 0; i < samples; ++i) {
        const double e = radical_inverse(i), azimuth = 2 * pi * (i + 0.5) / samples;
        const double cosine2 = (1 - e) / (1 + (alpha2 - 1) * e), cosine = std::sqrt(cosine2);
        const double sine = std::sqrt(std::max(1 - cosine2, 0.0));
        const glm::dvec3 h(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
        const glm::dvec3 l = 2 * h.z * h - glm::dvec3(0, 0, 1);
        if (l.z <= 0)
            continue;
        const double f = cosine2 * (alpha2 - 1) + 1, density = alpha2 / (pi * f * f) / 4; // of lights, where N is V
        out.push_back({l, l.z, std::sqrt(1 / (samples * density))});
        weights += l.z;
    }
    for (LobeSample& sample : out)
        sample.weight /= weights;
    return out;
}

/// What the mirror shows in each direction. A sample takes the mean of what it stands for, so that a small bright light
/// is neither missed nor seen as many (Křivánek and Colbert, "Real-time Shading with Filtered Importance Sampling",
/// 2008): rows of a map as coarse as that, and of them as many columns, which near the poles are narrow. All normals of
/// a row look at the same places beside them, one sample is added to all at once. All widths are powers of two.
Image rough(const std::vector<RowSums>& maps, uint32_t channels, double roughness, uint32_t samples, uint32_t wide) {
    const std::vector<LobeSample> lights = lobe(roughness, samples);
    Image out(wide, wide / 2);
    parallel_for(out.height, [&](uint32_t y) {
        const glm::dvec3 n = direction_of(0.5, (y + 0.5) / out.height);
        const glm::dvec3 t = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), n)), b = glm::cross(n, t);
        // Of each map and channel. Where it is narrower than the picture, first the pixels that lie alike in its
        // columns, then the next such.
        std::vector<double> sums(maps.size() * channels * wide);
        const auto sums_of = [&](size_t level, uint32_t channel) {
            return std::span(sums).subspan((level * channels + channel) * wide, wide);
        };
        const auto phases = [&](const RowSums& map) { return std::max(wide / map.width(), 1u); };
        for (const LobeSample& sample : lights) {
            const glm::dvec3 d = t * sample.light.x + b * sample.light.y + n * sample.light.z;
            const double doublings = std::log2(sample.spread / (pi / maps[0].height()));
            const auto level = size_t(std::clamp(std::floor(doublings), 0.0, double(maps.size() - 1)));
            const RowSums& map = maps[level];
            const double row =
                std::clamp(std::acos(std::clamp(d.y, -1.0, 1.0)) / pi * map.height() - 0.5, 0.0, map.height() - 1.0);
            const auto upper = uint32_t(row), lower = std::min(upper + 1, map.height() - 1);
            const double sine = std::max(std::sqrt(std::max(1 - d.y * d.y, 0.0)), 1e-6);
            const double columns = std::clamp(sample.spread / sine / (2 * pi) * map.width(), 1.0, double(map.width()));
            const double left = std::atan2(d.x, -d.z) / (2 * pi) * map.width() - columns / 2,
                         weight = sample.weight / columns;
            const uint32_t count = wide / phases(map);
            for (uint32_t phase = 0; phase < phases(map); ++phase) {
                const RowSums::Window window{upper,
                                             lower,
                                             weight * (1 - (row - upper)),
                                             weight * (row - upper),
                                             left + (phase + 0.5) * map.width() / wide,
                                             columns};
                for (uint32_t channel = 0; channel < channels; ++channel)
                    map.add(sums_of(level, channel).subspan(size_t(phase) * count, count), channel, window);
            }
        }
        for (uint32_t x = 0; x < wide; ++x) {
            glm::dvec3 sum(0);
            for (size_t level = 0; level < maps.size(); ++level) {
                const uint32_t every = phases(maps[level]);
                for (uint32_t channel = 0; channel < 3; ++channel)
                    sum[static_cast<int>(channel)] +=
                        sums_of(level, std::min(channel, channels - 1))[x % every * (wide / every) + x / every];
            }
            out.pixels[size_t(y) * wide + x] = glm::vec3(sum);
        }
    });
    return out;
}

/// Between texels a picture is read along the chord of the curve that they lie on, which where it bends is off by h²
/// f'' / 12 in the mean. With the texels moved by that the other way the mean is right, and the error √6 times smaller.
void balance(Image& image) {
    const Image from = image;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::vec3 here = from.at(x, y);
            const glm::vec3 beside =
                from.at((x + 1) % image.width, y) + from.at((x + image.width - 1) % image.width, y);
            const glm::vec3 along = from.at(x, std::min(y + 1, image.height - 1)) + from.at(x, std::max(y, 1u) - 1);
            image.at(x, y) = glm::max(here - (beside + along - 4.0f * here) / 12.0f, 0.0f);
        }
}

/// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001; divided by π.
/// `turns`: of the environment, counter-clockwise seen from above.
void project(const Image& image, double turns, glm::vec3 (&out)[9]) {
    glm::dvec3 sums[9]{};
    for (uint32_t y = 0; y < image.height; ++y) {
        const double v = (y + 0.5) / image.height;
        const double area =
            2 * pi / image.width * (std::cos(double(y) / image.height * pi) - std::cos((y + 1.0) / image.height * pi));
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::dvec3 d = direction_of((x + 0.5) / image.width - turns, v);
            const double basis[9]{0.282095,
                                  0.488603 * d.y,
                                  0.488603 * d.z,
                                  0.488603 * d.x,
                                  1.092548 * d.x * d.y,
                                  1.092548 * d.y * d.z,
                                  0.315392 * (3 * d.z * d.z - 1),
                                  1.092548 * d.x * d.z,
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
        out.sky = out.images[0];
        return out;
    }
    check_environment(*environment);
    out.intensity = environment->intensity;
    out.turns = environment->rotation / (2 * pi) - std::floor(environment->rotation / (2 * pi));
    const Image& seen = environment->backdrop.pixels.empty() ? environment->image : environment->backdrop;
    out.sky = environment->background ? shrink(seen, widest_sky) : Image(1, 1);
    project(shrink(environment->image, 256), out.turns, out.irradiance);
    std::vector<Image> sources; // each half as wide as the one before
    const uint32_t widest = std::clamp(std::bit_ceil(environment->image.width), 4u, width);
    for (uint32_t size = widest; size >= 4; size /= 2)
        sources.push_back(resize(environment->image, size));
    const uint32_t channels = is_grey(environment->image) ? 1 : 3;
    for (uint32_t level = 0; level < mirror_levels; ++level) {
        const uint32_t wide = width >> level, made = std::min(wide, 2 * widest); // no finer than what it is made of
        std::vector<RowSums> maps;
        for (const Image& source : sources)
            maps.emplace_back(source, channels, std::max(source.width / made, 1u));
        const auto of_step = [&](uint32_t step) {
            if (step == 0)
                return resize(environment->image, wide);
            Image image = rough(maps, channels, roughness_of(step), std::min(64u << level, 512u), made);
            balance(image);
            return widen(image, wide);
        };
        Image both = of_step(2 * level);
        const Image lower = of_step(2 * level + 1);
        both.pixels.insert(both.pixels.end(), lower.pixels.begin(), lower.pixels.end());
        both.height = wide;
        out.images.push_back(std::move(both));
    }
    return out;
}

shared::EnvironmentConstants environment_constants(const EnvironmentLevels& levels, double exposure) {
    shared::EnvironmentConstants constants{};
    const auto factor = float(exposure * levels.intensity);
    for (int i = 0; i < 9; ++i)
        constants.irradiance[i] = glm::vec4(levels.irradiance[i] * factor, 0);
    constants.levels = glm::vec4(float(levels.images[0].height) / 2, factor, float(levels.turns), 0);
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
