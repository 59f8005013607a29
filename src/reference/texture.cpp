#include <algorithm>
#include <array>
#include <cmath>
#include <reference/texture.hpp>

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
    const uint8_t* bytes =
        &image.rgba[(static_cast<size_t>(y) * image.width + static_cast<size_t>(x)) * 4];
    glm::dvec4 value;
    for (int channel = 0; channel < 3; ++channel)
        value[channel] = encoding == Encoding::srgb ? linear_of_srgb(bytes[channel])
                                                    : static_cast<double>(bytes[channel]) / 255;
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

} // namespace

glm::dvec4 Textures::sample(const TextureRef& ref, glm::dvec2 uv, Encoding encoding) const {
    const TextureImage& image = scene_.images.at(ref.image);
    uv = glm::dmat2(ref.uv_linear) * uv + glm::dvec2(ref.uv_offset);
    const double x = to_texels(uv.x, image.width, ref.sampler.wrap_s);
    const double y = to_texels(uv.y, image.height, ref.sampler.wrap_t);
    const auto column = [&](double i) {
        return wrapped(static_cast<int64_t>(i), image.width, ref.sampler.wrap_s);
    };
    const auto row = [&](double i) {
        return wrapped(static_cast<int64_t>(i), image.height, ref.sampler.wrap_t);
    };
    if (!bilinear_ && ref.sampler.mag == Filter::nearest)
        return texel(image, column(std::floor(x)), row(std::floor(y)), encoding);

    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double s = x - 0.5 - left, t = y - 0.5 - top;
    const auto mixed_row = [&](int64_t line) {
        return (1 - s) * texel(image, column(left), line, encoding) +
               s * texel(image, column(left + 1), line, encoding);
    };
    return (1 - t) * mixed_row(row(top)) + t * mixed_row(row(top + 1));
}

} // namespace prelight::reference
