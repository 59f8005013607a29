#pragma once
#include <cstdint>
#include <prelight/scene.hpp>
#include <span>
#include <stdexcept>

namespace prelight::images {

/// Why a picture could not be decoded, as one short reason.
struct DecodeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Longest side of a picture in pixels, and most pixels of one picture.
inline constexpr uint32_t max_side = 16384;
inline constexpr uint64_t max_pixels = uint64_t(1) << 26;

enum class Format { png, jpeg, webp, unknown };
/// Told by the first bytes: names and MIME types of files are often wrong.
Format format_of(std::span<const uint8_t> bytes);

/// What decoding is going to take, from the picture's header alone.
struct Cost {
    uint32_t width = 0;
    uint32_t height = 0;
    uint64_t working = 0; ///< bytes while decoding, beside the result's width × height × 4
};
/// Throws DecodeError when the header is damaged, or when the picture is beyond the limits above.
Cost inspect(std::span<const uint8_t> bytes);

/// Decodes PNG, JPEG or WebP to 8-bit RGBA; takes no more memory than `inspect` says. Throws
/// DecodeError.
TextureImage decode(std::span<const uint8_t> bytes);

} // namespace prelight::images
