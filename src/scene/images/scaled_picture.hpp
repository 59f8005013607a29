#pragma once
#include <cstdint>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::images {

/// What a picture's RGB mean, and so how several texels become one. Alpha is always averaged as it is.
enum class Texels {
    colour,  ///< sRGB: averaged in linear light
    normals, ///< directions, 0 … 255 for −1 … 1: averaged, then of unit length again
    values,  ///< averaged as they are
};

/// Sides of a picture that is halved `halvings` times; never below 1.
inline uint32_t halved(uint32_t side, uint32_t halvings) {
    return halvings < 32 && side >> halvings ? side >> halvings : 1;
}

/// Gathers a picture row by row, scaled down by a box filter of 2^halvings × 2^halvings texels, so that the whole is
/// never in memory. Where a side does not divide, the last texel takes what is left over.
class ScaledPicture {
public:
    /// `room`: memory for the result, if there is some.
    ScaledPicture(uint32_t width, uint32_t height, uint32_t halvings, Texels kind, std::vector<uint8_t> room = {});
    /// Where the next row goes, width × 4 bytes; then row_done().
    uint8_t* row();
    void row_done();
    /// After `height` rows.
    TextureImage take();

private:
    void add(const uint8_t* rgba);
    void finish_row();

    uint32_t width_, height_, halvings_;
    Texels kind_;
    TextureImage out_;
    uint32_t rows_ = 0; ///< that have come
    uint32_t rows_in_box_ = 0;
    std::vector<uint8_t> row_;
    std::vector<float> sums_; ///< of a row of `out_`
};

/// A whole picture, scaled down.
TextureImage scaled_down(const TextureImage& image, uint32_t halvings, Texels kind);

} // namespace prelight::images
