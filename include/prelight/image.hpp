#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <prelight/export.hpp>
#include <prelight/glm_defaults.hpp>
#include <vector>

namespace prelight {

/// A picture of 32-bit float RGB, row by row from the top left. What the numbers mean (scene-linear,
/// display-encoded, a buffer's content) is said where the picture is made.
struct Image {
    uint32_t width = 0;            ///< pixels
    uint32_t height = 0;           ///< pixels
    std::vector<glm::vec3> pixels; ///< width × height values

    Image() = default;
    /// A black one.
    Image(uint32_t w, uint32_t h) : width(w), height(h), pixels(size_t(w) * h, glm::vec3(0)) {}
    /// The pixel in column `x` from the left and row `y` from the top; neither is checked.
    glm::vec3& at(uint32_t x, uint32_t y) { return pixels[size_t(y) * width + x]; }
    /// Likewise.
    const glm::vec3& at(uint32_t x, uint32_t y) const { return pixels[size_t(y) * width + x]; }
};

/// Writes 8-bit PNG. `display` holds display-encoded values in 0 … 1 (clamped, rounded to nearest).
/// The file appears under a temporary name beside `path` and is renamed when whole.
/// Throws Error naming `path` when it cannot be written.
PRELIGHT_API void save_png(const Image& display, const std::filesystem::path& path);

/// Writes half-float OpenEXR of scene-linear values, with the same rename; values beyond half range
/// are clamped to ±65,504. Throws Error.
PRELIGHT_API void save_exr(const Image& linear, const std::filesystem::path& path);

/// Reads an 8-bit PNG into 0 … 1 values as stored (display-encoded). Throws Error.
PRELIGHT_API Image load_png(const std::filesystem::path& path);
/// Reads the RGB channels of an OpenEXR file. Throws Error.
PRELIGHT_API Image load_exr(const std::filesystem::path& path);
/// Reads a Radiance picture (RGBE, flat or run-length encoded, rows from the top); what its header says of exposure is
/// divided out. Throws Error.
PRELIGHT_API Image load_hdr(const std::filesystem::path& path);

/// sRGB transfer function (IEC 61966-2-1), linear 0 … 1 → encoded 0 … 1; inputs are clamped.
PRELIGHT_API float srgb_encode(float linear);
/// Inverse of `srgb_encode`.
PRELIGHT_API float srgb_decode(float encoded);

/// How scene-linear values become those of a display.
enum class Tonemap {
    pbr_neutral, ///< Khronos PBR Neutral tone mapper
    aces,        ///< ACES filmic fit (Narkowicz 2015)
    none,        ///< clamp to 0 … 1
};
/// Scene-linear → the display's linear light, 0 … 1: what `tonemap` encodes.
PRELIGHT_API glm::vec3 display_light(glm::vec3 linear, Tonemap curve);
/// Scene-linear → display-encoded sRGB, on the CPU (the GPU pass is checked against it).
PRELIGHT_API Image tonemap(const Image& linear, Tonemap curve);

} // namespace prelight
