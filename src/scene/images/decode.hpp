#pragma once
#include <cstdint>
#include <image/png_reader.hpp>
#include <prelight/scene.hpp>
#include <scene/images/scaled_picture.hpp>
#include <span>

namespace prelight::images {

using prelight::DecodeError;

enum class Format { png, jpeg, webp, unknown };
/// Told by the first bytes: names and MIME types of files are often wrong.
Format format_of(std::span<const uint8_t> bytes);

/// What decoding is going to take, from the picture's header alone.
struct Cost {
    uint32_t width = 0;
    uint32_t height = 0;
    uint64_t working = 0; ///< bytes while decoding, beside the result
    /// Bytes more when the result is scaled down: of pictures that are there whole before.
    uint64_t working_scaled = 0;
};
/// Throws DecodeError when the header is damaged, when the picture is beyond the limits of png_reader.hpp, or when the
/// file is too short for it.
Cost inspect(std::span<const uint8_t> bytes);

/// Decodes PNG, JPEG or WebP to 8-bit RGBA, halved as often as said; takes no more memory than `inspect` says. Colour
/// profiles, gamma and orientation are not applied, as glTF says. `room`: memory for the result, if there is some.
/// Throws DecodeError.
TextureImage decode(std::span<const uint8_t> bytes, uint32_t halvings = 0, Texels kind = Texels::values,
                    std::vector<uint8_t> room = {});

} // namespace prelight::images
