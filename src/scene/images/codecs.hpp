#pragma once
#include <scene/images/decode.hpp>

// One file each, called by decode.cpp after the format is known.
namespace prelight::images {

Cost inspect_png(std::span<const uint8_t> bytes);
TextureImage decode_png(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room);
Cost inspect_jpeg(std::span<const uint8_t> bytes);
TextureImage decode_jpeg(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room);
Cost inspect_webp(std::span<const uint8_t> bytes);
TextureImage decode_webp(std::span<const uint8_t> bytes, uint32_t halvings, Texels kind, std::vector<uint8_t> room);

} // namespace prelight::images
