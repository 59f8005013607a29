#include "mask_levels.hpp"
#include "image_levels.hpp"
#include <array>
#include <cmath>
#include <glm/vec4.hpp>
#include <image/srgb_codes.hpp>
#include <numeric>
#include <prelight/image.hpp>

namespace prelight::resident {
namespace {

/// A level holds the coverage when it is off by less than this share of it, or of the whole picture; half-way to the
/// finer one it may be off by twice as much.
constexpr double slack = 0.1, least_slack = 0.002;

using MaskLevel = ImageLevel<glm::vec4>; ///< linear

MaskLevel linear_texels(const TextureImage& image) {
    const std::array<float, 256>& linear = srgb_linear();
    MaskLevel level{image.width, image.height, std::vector<glm::vec4>(size_t(image.width) * image.height)};
    parallel_rows(image.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * image.width, end = i + image.width; i < end; ++i)
            for (int c = 0; c < 4; ++c)
                level.texels[i][c] =
                    c < 3 ? linear[image.rgba[4 * i + c]] : static_cast<float>(image.rgba[4 * i + 3]) / 255.0f;
    });
    return level;
}

TextureImage with_colours_of(const MaskLevel& level, const std::string& name) {
    TextureImage image{name, level.width, level.height, std::vector<uint8_t>(level.texels.size() * 4)};
    parallel_rows(level.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * level.width, end = i + level.width; i < end; ++i)
            for (int c = 0; c < 3; ++c)
                image.rgba[4 * i + c] = unorm_byte(srgb_encode(level.texels[i][c]));
    });
    return image;
}

void scale_alpha(TextureImage& image, const MaskLevel& level, float factor) {
    for (size_t i = 0; i < level.texels.size(); ++i)
        image.rgba[4 * i + 3] = unorm_byte(level.texels[i].a * factor);
}

/// Where a texture is read at one place: between four texels, from their alpha's bytes.
struct Footprint {
    std::array<size_t, 4> alpha; ///< left and right above, left and right below
    float s, t;                  ///< of the way to the right, and down
};

/// At a place 0 … 1.
Footprint footprint(uint32_t image_width, uint32_t image_height, const Sampler& sampler, double u, double v) {
    const auto width = static_cast<int>(image_width), height = static_cast<int>(image_height);
    const auto inside = [](int i, int size, Wrap wrap) {
        return wrap == Wrap::repeat ? (i + size) % size : std::clamp(i, 0, size - 1);
    };
    const auto alpha = [&](int x, int y) {
        return 4 * (size_t(inside(y, height, sampler.wrap_t)) * image_width +
                    size_t(inside(x, width, sampler.wrap_s))) +
               3;
    };
    const auto x = static_cast<float>(u * width), y = static_cast<float>(v * height);
    if (sampler.min == Filter::nearest) {
        const size_t nearest = alpha(static_cast<int>(x), static_cast<int>(y));
        return {{nearest, nearest, nearest, nearest}, 0, 0};
    }
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const auto column = static_cast<int>(left), row = static_cast<int>(top);
    return {{alpha(column, row), alpha(column + 1, row), alpha(column, row + 1), alpha(column + 1, row + 1)},
            x - 0.5f - left,
            y - 0.5f - top};
}

/// At points that are spread evenly (M. Roberts' R2 sequence).
std::vector<Footprint> footprints(const TextureImage& image, const Sampler& sampler) {
    std::vector<Footprint> points(8192);
    for (size_t i = 0; i < points.size(); ++i) {
        const double number = static_cast<double>(i + 1), u = number * 0.7548776662466927,
                     v = number * 0.5698402909980532;
        points[i] = footprint(image.width, image.height, sampler, u - std::floor(u), v - std::floor(v));
    }
    return points;
}

/// Alpha in codes.
float alpha_at(const TextureImage& image, const Footprint& point) {
    const auto alpha = [&](size_t i) { return static_cast<float>(image.rgba[point.alpha[i]]); };
    const auto row = [&](size_t i) { return (1 - point.s) * alpha(i) + point.s * alpha(i + 1); };
    return (1 - point.t) * row(0) + point.t * row(2);
}

std::vector<float> alpha_at_points(const TextureImage& image, const Sampler& sampler) {
    std::vector<float> alpha;
    for (const Footprint& point : footprints(image, sampler))
        alpha.push_back(alpha_at(image, point));
    return alpha;
}

/// Coverage half-way between two levels; `fine`: at the points.
double coverage_between(const std::vector<float>& fine, const TextureImage& coarse,
                        const std::vector<Footprint>& points, float cutoff) {
    uint32_t passed = 0;
    for (size_t i = 0; i < fine.size(); ++i)
        passed += fine[i] + alpha_at(coarse, points[i]) >= 2 * cutoff * 255.0f ? 1 : 0;
    return static_cast<double>(passed) / static_cast<double>(fine.size());
}

/// Scales the image's alpha, which `level` holds, until the coverage is what it is to be; false where that cannot be.
/// Where levels are mixed, less passes between two than in either, for a mean of both varies less. So the factor is
/// that for which it is half as much too large in this one as it is too small half-way to the finer one.
bool keep_coverage(TextureImage& image, const MaskLevel& level, const TextureImage& finer, double wanted, float cutoff,
                   const Sampler& sampler) {
    float best = 1;
    double off = 2;
    bool good = false;
    const bool mixed = sampler.mip == MipFilter::linear;
    const std::vector<float> fine = mixed ? alpha_at_points(finer, sampler) : std::vector<float>();
    const std::vector<Footprint> points = mixed ? footprints(image, sampler) : std::vector<Footprint>();
    const auto coverage = [&](float factor) {
        scale_alpha(image, level, factor);
        const double here = mask_coverage(image, cutoff, sampler, sampler.min);
        const double between = mixed ? coverage_between(fine, image, points, cutoff) : here;
        const double mean = (2 * here + between) / 3;
        if (std::abs(mean - wanted) < off) {
            off = std::abs(mean - wanted);
            best = factor;
            const double most = std::max(slack * wanted, least_slack);
            good = std::abs(here - wanted) <= most && std::abs(between - wanted) <= 2 * most;
        }
        return mean;
    };
    float low = 1.0f / 64, high = 64;
    float factor = 1;
    for (int step = 0; step < 14 && off > least_slack / 4; ++step) {
        (coverage(factor) < wanted ? low : high) = factor;
        factor = std::sqrt(low * high);
    }
    scale_alpha(image, level, best);
    return good;
}

} // namespace

double mask_coverage(const TextureImage& image, float cutoff, const Sampler& sampler, Filter filter) {
    const uint32_t width = image.width, height = image.height;
    const float least = cutoff * 255.0f;
    const auto alpha = [&](uint32_t x, uint32_t y) {
        return static_cast<float>(image.rgba[4 * (size_t(y) * width + x) + 3]);
    };
    // Between texel centres: in each cell of four a grid of samples, finer where there are few cells.
    const size_t cells = size_t(width) * height;
    const int side = filter == Filter::nearest ? 1 : cells > 512 * 512 ? 2 : cells > 64 * 64 ? 4 : 16;
    const auto next = [](uint32_t i, uint32_t size, Wrap wrap) {
        return i + 1 < size ? i + 1 : wrap == Wrap::repeat ? 0 : i;
    };
    std::vector<uint64_t> passed(height, 0);
    const auto count_row = [&](uint32_t y) {
        const uint32_t below = next(y, height, sampler.wrap_t);
        for (uint32_t x = 0; x < width; ++x) {
            const float a = alpha(x, y);
            if (side == 1) {
                passed[y] += a >= least ? 1 : 0;
                continue;
            }
            const uint32_t right = next(x, width, sampler.wrap_s);
            const float b = alpha(right, y), c = alpha(x, below), d = alpha(right, below);
            if (std::max({a, b, c, d}) < least)
                continue;
            if (std::min({a, b, c, d}) >= least) {
                passed[y] += static_cast<uint64_t>(side * side);
                continue;
            }
            for (int v = 0; v < side; ++v) {
                const float t = (static_cast<float>(v) + 0.5f) / static_cast<float>(side);
                const float from = a + t * (c - a), to = b + t * (d - b);
                for (int u = 0; u < side; ++u)
                    passed[y] +=
                        from + (static_cast<float>(u) + 0.5f) / static_cast<float>(side) * (to - from) >= least ? 1 : 0;
            }
        }
    };
    parallel_rows(height, count_row);
    return static_cast<double>(std::accumulate(passed.begin(), passed.end(), uint64_t(0))) /
           (static_cast<double>(cells) * side * side);
}

std::vector<TextureImage> mask_levels(const TextureImage& image, float cutoff, const Sampler& sampler) {
    std::vector<TextureImage> levels{image};
    const double wanted = mask_coverage(image, cutoff, sampler, sampler.mag);
    MaskLevel level = linear_texels(image);
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        TextureImage next = with_colours_of(level, image.name);
        if (!keep_coverage(next, level, levels.back(), wanted, cutoff, sampler))
            break;
        levels.push_back(std::move(next));
    }
    return levels;
}

} // namespace prelight::resident
