#include <algorithm>
#include <scene/images/codecs.hpp>
#include <webp/decode.h>

namespace prelight::images {

Cost inspect_webp(std::span<const uint8_t> bytes) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK)
        throw DecodeError("does not decode (damaged WebP header)");
    if (features.has_animation)
        throw DecodeError("is an animated WebP");
    Cost cost;
    cost.width = uint32_t(features.width);
    cost.height = uint32_t(features.height);
    check_picture_size(cost.width, cost.height);
    const uint64_t pixels = uint64_t(cost.width) * cost.height;
    // Lossless WebP may name a group of prefix codes for every 4 × 4 block; a group's tables take
    // 9.4 kB, its code at least 5 bits for each of 5 trees, and there are at most 2^16 of them.
    constexpr uint64_t group_bytes = 9472, group_bits = 25;
    const uint64_t groups =
        std::min<uint64_t>({pixels / 16 + 1, uint64_t(1) << 16, uint64_t(bytes.size()) * 8 / group_bits + 1});
    // Lossy pictures are decoded a few rows of blocks at a time.
    constexpr uint64_t row_bytes = 1024; // a pixel of width
    cost.working = row_bytes * cost.width + (1u << 20);
    // 2: not known to be lossy (an alpha plane is lossless too). Argb, transforms and alpha: 16 a
    // pixel.
    if (features.format != 1 || features.has_alpha)
        cost.working += pixels * 16 + groups * group_bytes;
    cost.working_scaled = pixels * 4;
    return cost;
}

TextureImage decode_webp(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room) {
    const Cost cost = inspect_webp(bytes);
    TextureImage image{{}, cost.width, cost.height, std::move(room)};
    image.rgba.resize(size_t(cost.width) * cost.height * 4);
    if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(), int(cost.width) * 4))
        throw DecodeError("does not decode (damaged WebP)");
    return halvings == 0 ? image : scaled_down(image, halvings, kind);
}

} // namespace prelight::images
