#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <mutex>
#include <reference/texture.hpp>
#include <vector>

namespace prelight::reference {
namespace {

/// One entry a byte.
const std::array<double, 256>& srgb_table() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (size_t i = 0; i < values.size(); ++i) {
            const double e = static_cast<double>(i) / 255;
            values[i] = e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
        }
        return values;
    }();
    return table;
}

} // namespace

double linear_of_srgb(uint8_t code) { return srgb_table()[code]; }

namespace {

glm::dvec4 texel(const TextureImage& image, int64_t x, int64_t y, Encoding encoding) {
    const uint8_t* bytes = &image.rgba[(static_cast<size_t>(y) * image.width + static_cast<size_t>(x)) * 4];
    glm::dvec4 value{0};
    for (int channel = 0; channel < 3; ++channel)
        value[channel] =
            encoding == Encoding::srgb ? linear_of_srgb(bytes[channel]) : static_cast<double>(bytes[channel]) / 255;
    value.a = static_cast<double>(bytes[3]) / 255;
    return value;
}

/// Texture coordinate → texel coordinate, brought near 0 … size first so that huge coordinates
/// neither lose digits nor overflow.
double to_texels(double u, uint32_t size, Wrap wrap) {
    if (!std::isfinite(u))
        u = 0;
    if (wrap == Wrap::repeat)
        u -= std::floor(u);
    else if (wrap == Wrap::mirrored_repeat)
        u -= 2 * std::floor(u / 2);
    else
        u = std::clamp(u, -1.0, 2.0);
    return u * size;
}

int64_t wrapped(int64_t i, int64_t size, Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge)
        return std::clamp<int64_t>(i, 0, size - 1);
    const int64_t period = wrap == Wrap::repeat ? size : 2 * size;
    i = ((i % period) + period) % period;
    return i < size ? i : period - 1 - i;
}

/// One sample of a picture whose texels `at` gives, at texture coordinates `uv`.
template <class At>
glm::dvec4 filtered(const At& at, uint32_t width, uint32_t height, const Sampler& sampler, Filter filter,
                    glm::dvec2 uv) {
    const double x = to_texels(uv.x, width, sampler.wrap_s), y = to_texels(uv.y, height, sampler.wrap_t);
    const auto column = [&](double i) { return wrapped(static_cast<int64_t>(i), width, sampler.wrap_s); };
    const auto row = [&](double i) { return wrapped(static_cast<int64_t>(i), height, sampler.wrap_t); };
    if (filter == Filter::nearest)
        return at(column(std::floor(x)), row(std::floor(y)));
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double s = x - 0.5 - left, t = y - 0.5 - top;
    const auto mixed_row = [&](int64_t line) {
        return (1 - s) * at(column(left), line) + s * at(column(left + 1), line);
    };
    return (1 - t) * mixed_row(row(top)) + t * mixed_row(row(top + 1));
}

} // namespace

struct Textures::Level {
    uint32_t width = 0, height = 0;
    std::vector<glm::dvec4> texels{};
};

struct Textures::Levels {
    std::once_flag once{};
    std::vector<Level> all{}; ///< from level 1 on
};

Textures::Textures(const Scene& scene, bool bilinear)
    : scene_(scene), bilinear_(bilinear), levels_(bilinear ? nullptr : new Levels[2 * scene.images.size()]) {}

Textures::~Textures() = default;

const Textures::Levels& Textures::levels(uint32_t image, Encoding encoding) const {
    Levels& levels = levels_[2 * image + (encoding == Encoding::srgb ? 1 : 0)];
    std::call_once(levels.once, [&] {
        const TextureImage& source = scene_.images[image];
        Level fine{source.width, source.height};
        for (uint32_t y = 0; y < source.height; ++y)
            for (uint32_t x = 0; x < source.width; ++x)
                fine.texels.push_back(texel(source, x, y, encoding));
        while (fine.width > 1 || fine.height > 1) {
            Level coarse{std::max(fine.width / 2, 1u), std::max(fine.height / 2, 1u)};
            // The last texel of an odd side covers three.
            const auto end = [](uint32_t i, uint32_t count, uint32_t all) { return i + 1 == count ? all : 2 * i + 2; };
            for (uint32_t y = 0; y < coarse.height; ++y)
                for (uint32_t x = 0; x < coarse.width; ++x) {
                    glm::dvec4 sum(0);
                    const uint32_t bottom = end(y, coarse.height, fine.height),
                                   right = end(x, coarse.width, fine.width);
                    for (uint32_t v = 2 * y; v < bottom; ++v)
                        for (uint32_t u = 2 * x; u < right; ++u)
                            sum += fine.texels[size_t(v) * fine.width + u];
                    coarse.texels.push_back(sum / double((bottom - 2 * y) * (right - 2 * x)));
                }
            levels.all.push_back(coarse);
            fine = std::move(coarse);
        }
    });
    return levels;
}

glm::dvec4 Textures::sample(const TextureRef& ref, glm::dvec2 uv, Encoding encoding, const Footprint& footprint) const {
    const TextureImage& image = scene_.images.at(ref.image);
    const glm::dmat2 linear(ref.uv_linear);
    uv = linear * uv + glm::dvec2(ref.uv_offset);
    const Sampler& sampler = ref.sampler;
    const auto finest = [&](Filter filter) {
        return filtered([&](int64_t x, int64_t y) { return texel(image, x, y, encoding); }, image.width, image.height,
                        sampler, filter, uv);
    };
    if (bilinear_)
        return finest(Filter::linear);
    const glm::dvec2 size(image.width, image.height);
    const double lambda =
        std::log2(std::max(glm::length(linear * footprint.across * size), glm::length(linear * footprint.down * size)));
    if (!(lambda > 0))
        return finest(sampler.mag);
    if (sampler.mip == MipFilter::none)
        return finest(sampler.min);
    const std::vector<Level>& coarser = levels(ref.image, encoding).all;
    const auto from = [&](double number) {
        const auto level = static_cast<size_t>(std::min(number, static_cast<double>(coarser.size())));
        if (level == 0)
            return finest(sampler.min);
        const Level& one = coarser[level - 1];
        return filtered(
            [&](int64_t x, int64_t y) {
                return one.texels[static_cast<size_t>(y) * one.width + static_cast<size_t>(x)];
            },
            one.width, one.height, sampler, sampler.min, uv);
    };
    if (sampler.mip == MipFilter::nearest)
        return from(std::ceil(lambda + 0.5) - 1);
    const double share = lambda - std::floor(lambda);
    return (1 - share) * from(std::floor(lambda)) + share * from(std::floor(lambda) + 1);
}

} // namespace prelight::reference
