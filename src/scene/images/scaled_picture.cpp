#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <image/srgb_codes.hpp>
#include <scene/images/scaled_picture.hpp>

namespace prelight::images {
namespace {

/// Linear light from which on the next code is nearer.
std::array<float, 255> make_bounds() {
    std::array<float, 255> bounds;
    for (size_t code = 0; code < bounds.size(); ++code)
        bounds[code] = srgb_decode((static_cast<float>(code) + 0.5f) / 255);
    return bounds;
}
const std::array<float, 255> bounds = make_bounds();

uint8_t to_srgb(float value) {
    return static_cast<uint8_t>(std::upper_bound(bounds.begin(), bounds.end(), value) - bounds.begin());
}
uint8_t to_byte(float value) { return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f))); }

} // namespace

ScaledPicture::ScaledPicture(uint32_t width, uint32_t height, uint32_t halvings, Texels kind, std::vector<uint8_t> room)
    : width_(width), height_(height), halvings_(halvings),
      kind_(kind), out_{{}, halved(width, halvings), halved(height, halvings), std::move(room)} {
    out_.rgba.resize(size_t(out_.width) * out_.height * 4);
    if (halvings_ == 0)
        return;
    row_.resize(size_t(width) * 4);
    sums_.resize(size_t(out_.width) * 4);
}

uint8_t* ScaledPicture::row() { return halvings_ == 0 ? &out_.rgba[size_t(rows_) * width_ * 4] : row_.data(); }

void ScaledPicture::row_done() {
    ++rows_;
    if (halvings_ == 0)
        return;
    add(row_.data());
    const uint32_t box = 1u << halvings_, done = rows_ >> halvings_;
    if ((rows_ % box == 0 && done < out_.height) || rows_ == height_)
        finish_row();
}

void ScaledPicture::add(const uint8_t* rgba) {
    const std::array<float, 256>& linear = srgb_linear();
    ++rows_in_box_;
    for (uint32_t x = 0; x < width_; ++x, rgba += 4) {
        float* sum = &sums_[size_t(std::min(x >> halvings_, out_.width - 1)) * 4];
        if (kind_ == Texels::colour) {
            for (size_t c = 0; c < 3; ++c)
                sum[c] += linear[rgba[c]];
        } else if (kind_ == Texels::normals) {
            const glm::vec3 n = glm::vec3(rgba[0], rgba[1], rgba[2]) / 127.5f - 1.0f;
            const float length = glm::length(n);
            for (int c = 0; c < 3 && length > 0; ++c)
                sum[c] += n[c] / length;
        } else {
            for (size_t c = 0; c < 3; ++c)
                sum[c] += rgba[c];
        }
        sum[3] += rgba[3];
    }
}

void ScaledPicture::finish_row() {
    // All rows before have come in whole boxes, the last one of the picture takes what is left over.
    const uint32_t y = std::min((rows_ - 1) >> halvings_, out_.height - 1);
    uint8_t* texel = &out_.rgba[size_t(y) * out_.width * 4];
    for (uint32_t x = 0; x < out_.width; ++x, texel += 4) {
        const uint32_t columns = (x + 1 == out_.width ? width_ : (x + 1) << halvings_) - (x << halvings_);
        const float weight = 1.0f / (static_cast<float>(columns) * static_cast<float>(rows_in_box_));
        const float* sum = &sums_[size_t(x) * 4];
        const glm::vec3 rgb(sum[0], sum[1], sum[2]);
        const float length = glm::length(rgb);
        for (int c = 0; c < 3; ++c)
            texel[c] = kind_ == Texels::colour ? to_srgb(rgb[c] * weight)
                       : kind_ == Texels::values
                           ? to_byte(rgb[c] * weight)
                           : to_byte(((length > 0 ? rgb[c] / length : float(c == 2)) + 1) * 127.5f);
        texel[3] = to_byte(sum[3] * weight);
    }
    std::fill(sums_.begin(), sums_.end(), 0.0f);
    rows_in_box_ = 0;
}

TextureImage ScaledPicture::take() { return std::move(out_); }

TextureImage scaled_down(const TextureImage& image, uint32_t halvings, Texels kind) {
    ScaledPicture scaled(image.width, image.height, halvings, kind);
    const size_t row_bytes = size_t(image.width) * 4;
    for (uint32_t y = 0; y < image.height; ++y) {
        std::copy_n(&image.rgba[y * row_bytes], row_bytes, scaled.row());
        scaled.row_done();
    }
    TextureImage out = scaled.take();
    out.name = image.name;
    return out;
}

} // namespace prelight::images
