#pragma once
#include <scene/images/decode.hpp>

// One file each, called by decode.cpp after the format is known.
namespace prelight::images {

Cost inspect_stb(std::span<const uint8_t> bytes, Format format);
TextureImage decode_stb(std::span<const uint8_t> bytes, const Cost& cost);
/// Throws DecodeError for what stb_image would not survive or not notice: Huffman tables that are too
/// long, very many scans, a missing end.
void check_jpeg(std::span<const uint8_t> bytes);
Cost inspect_webp(std::span<const uint8_t> bytes);
TextureImage decode_webp(std::span<const uint8_t> bytes, const Cost& cost);

} // namespace prelight::images
