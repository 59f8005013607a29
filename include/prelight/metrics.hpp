#pragma once
#include <cstdint>
#include <prelight/export.hpp>
#include <prelight/image.hpp>
#include <span>

namespace prelight {

/// Figures of a picture against a reference, both scene-linear, as `docs/measuring.md` defines them.
/// Both are first exposed by the same factor, so that the reference's 99th percentile (over all
/// channel values of pixels that are not left out) becomes 1; then clamped to 0 … 1.
struct Comparison {
    double psnr = 0;           ///< dB, linear RGB; infinity when equal
    double flip = 0;           ///< mean FLIP (Andersson and others 2020), 67 pixels per degree
    double off_share = 0;      ///< share of pixels with a channel off by more than 2/255 in sRGB
    double block = 0;          ///< largest difference of the means of any 16×16 block, sRGB, in 1/255
    uint32_t block_x = 0;      ///< where that block begins, in pixels from the left
    uint32_t block_y = 0;      ///< and from the top
    double left_out_share = 0; ///< share of pixels that `left_out` excludes
};

/// `left_out`: empty, or one byte per pixel, nonzero where a pixel does not count (see
/// `ReferencePicture::left_out`). FLIP is always taken over the whole picture; a block's mean is over
/// the pixels that count, blocks with less than a quarter of them are skipped.
/// Where `map` is given it receives the FLIP map whose mean `flip` is (see `flip_map`).
/// Throws Error when the sizes differ or a picture holds NaN.
PRELIGHT_API Comparison compare(const Image& picture, const Image& reference, std::span<const uint8_t> left_out = {},
                                Image* map = nullptr);

/// FLIP error map, 0 … 1 per pixel (same value in the three channels), of two display-encoded
/// pictures in 0 … 1.
PRELIGHT_API Image flip_map(const Image& picture_srgb, const Image& reference_srgb, double pixels_per_degree = 67.0);

} // namespace prelight
