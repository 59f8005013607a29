#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <image/compare_pixels.hpp>
#include <limits>
#include <prelight/error.hpp>
#include <prelight/metrics.hpp>

namespace prelight {
namespace {

constexpr double off_bound = 2.0 / 255;
constexpr uint32_t block_size = 16;

void check(const Image& picture, const Image& reference, std::span<const uint8_t> left_out) {
    if (picture.width != reference.width || picture.height != reference.height)
        throw Error(fmt::format("compare: picture: {}x{} pixels, the reference has {}x{}", picture.width,
                                picture.height, reference.width, reference.height));
    if (picture.pixels.empty())
        throw Error("compare: picture: it has no pixels");
    if (!left_out.empty() && left_out.size() != picture.pixels.size())
        throw Error(
            fmt::format("compare: left-out mask: {} values for {} pixels", left_out.size(), picture.pixels.size()));
    for (const auto& [image, name] : {std::pair(&picture, "picture"), {&reference, "reference"}})
        for (size_t i = 0; i < image->pixels.size(); ++i)
            for (int channel = 0; channel < 3; ++channel)
                if (std::isnan(image->pixels[i][channel]))
                    throw Error(
                        fmt::format("compare: {}: pixel ({}, {}): NaN", name, i % image->width, i / image->width));
}

/// 1 ÷ the 99th percentile (nearest rank) of all channel values that count. A picture that is dark
/// nearly everywhere has percentile 0: its largest value then takes the place, and 1 if that is 0.
double exposure_factor(const Image& reference, std::span<const uint8_t> left_out) {
    std::vector<float> values;
    values.reserve(reference.pixels.size() * 3);
    for (size_t i = 0; i < reference.pixels.size(); ++i)
        if (left_out.empty() || !left_out[i])
            for (int channel = 0; channel < 3; ++channel)
                values.push_back(reference.pixels[i][channel]);
    if (values.empty())
        return 1;
    const size_t rank = (values.size() * 99 + 99) / 100; // ⌈0.99 n⌉, counted from 1
    const auto place = values.begin() + static_cast<ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), place, values.end());
    float white = *place;
    if (white <= 0)
        white = *std::max_element(values.begin(), values.end());
    if (std::isinf(white))
        throw Error("compare: reference: its 99th percentile is infinite");
    return white > 0 ? 1 / static_cast<double>(white) : 1;
}

glm::vec3 exposed(glm::vec3 linear, double factor) {
    for (int channel = 0; channel < 3; ++channel)
        linear[channel] = static_cast<float>(std::clamp(static_cast<double>(linear[channel]) * factor, 0.0, 1.0));
    return linear;
}

Image encoded(const Image& linear) {
    Image display(linear.width, linear.height);
    for (size_t i = 0; i < linear.pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            display.pixels[i][channel] = srgb_encode(linear.pixels[i][channel]);
    return display;
}

/// Largest difference of the means of a block, in 1/255; −1 where too few pixels count.
double block_difference(const Image& picture, const Image& reference, std::span<const uint8_t> left_out, uint32_t left,
                        uint32_t top) {
    const uint32_t right = std::min(left + block_size, picture.width);
    const uint32_t bottom = std::min(top + block_size, picture.height);
    glm::dvec3 sum(0);
    size_t counted = 0;
    for (uint32_t y = top; y < bottom; ++y)
        for (uint32_t x = left; x < right; ++x) {
            if (!left_out.empty() && left_out[size_t(y) * picture.width + x])
                continue;
            sum += glm::dvec3(picture.at(x, y)) - glm::dvec3(reference.at(x, y));
            ++counted;
        }
    if (counted == 0 || counted * 4 < size_t(right - left) * (bottom - top))
        return -1;
    double largest = 0;
    for (int channel = 0; channel < 3; ++channel)
        largest = std::max(largest, std::abs(sum[channel]) / static_cast<double>(counted) * 255);
    return largest;
}

} // namespace

Comparison compare_pixels(const Image& picture, const Image& reference, std::span<const uint8_t> left_out,
                          DisplayedPair* displayed) {
    check(picture, reference, left_out);
    const double factor = exposure_factor(reference, left_out);
    Image shown = picture, wanted = reference;
    for (Image* image : {&shown, &wanted})
        for (glm::vec3& pixel : image->pixels)
            pixel = exposed(pixel, factor);
    Image shown_srgb = encoded(shown), wanted_srgb = encoded(wanted);

    Comparison result;
    double squares = 0;
    size_t counted = 0, off = 0;
    for (size_t i = 0; i < shown.pixels.size(); ++i) {
        if (!left_out.empty() && left_out[i])
            continue;
        ++counted;
        const glm::dvec3 error = glm::dvec3(shown.pixels[i]) - glm::dvec3(wanted.pixels[i]);
        squares += error.r * error.r + error.g * error.g + error.b * error.b;
        bool is_off = false;
        for (int channel = 0; channel < 3; ++channel)
            is_off = is_off || std::abs(double(shown_srgb.pixels[i][channel]) -
                                        double(wanted_srgb.pixels[i][channel])) > off_bound;
        off += is_off;
    }
    const auto pixels = static_cast<double>(shown.pixels.size());
    result.left_out_share = 1 - static_cast<double>(counted) / pixels;
    if (counted > 0) { // otherwise the figures say "all wrong": nothing was compared
        const double mean = squares / static_cast<double>(counted * 3);
        result.psnr = mean > 0 ? -10 * std::log10(mean) : std::numeric_limits<double>::infinity();
        result.off_share = static_cast<double>(off) / static_cast<double>(counted);
    } else {
        result.off_share = 1;
    }

    for (uint32_t y = 0; y < shown.height; y += block_size)
        for (uint32_t x = 0; x < shown.width; x += block_size) {
            const double difference = block_difference(shown_srgb, wanted_srgb, left_out, x, y);
            if (difference > result.block) {
                result.block = difference;
                result.block_x = x;
                result.block_y = y;
            }
        }

    if (displayed)
        *displayed = {std::move(shown_srgb), std::move(wanted_srgb)};
    return result;
}

Comparison compare(const Image& picture, const Image& reference, std::span<const uint8_t> left_out, Image* map) {
    DisplayedPair displayed;
    Comparison result = compare_pixels(picture, reference, left_out, &displayed);
    Image errors = flip_map(displayed.picture, displayed.reference);
    double flip = 0;
    for (const glm::vec3& pixel : errors.pixels)
        flip += static_cast<double>(pixel.r);
    result.flip = flip / static_cast<double>(errors.pixels.size());
    if (map)
        *map = std::move(errors);
    return result;
}

} // namespace prelight
