#pragma once
#include <cstdint>
#include <functional>
#include <prelight/device.hpp>
#include <prelight/export.hpp>
#include <string>
#include <vector>

namespace prelight {

/// Errors of one light sum over all pixels (and channels), as fractions of the reference's mean.
struct LightSumError {
    double rms = 0;  ///< root of the mean square
    double max = 0;  ///< largest, without its sign
    double bias = 0; ///< mean of the signed errors: below 0 is too dark
};

/// Figures of one light buffer or one way to a material's own shininess, with one number of
/// lights on every pixel.
struct LightBufferFigures {
    std::string name;         ///< "RGBA8 packed, luminance"
    std::string light_buffer; ///< value of the setting `light-buffer`
    std::string specular_way; ///< of `specular`
    std::string writes;       ///< of `light-writes`
    double scale = 1;         ///< `light-scale` of the fixed-point buffers; the brightest sum is 0.95
    uint32_t bytes = 0;       ///< a pixel, all targets
    uint32_t overlap = 0;     ///< lights on every pixel
    LightSumError diffuse;    ///< of Σ N·L·R in RGB
    LightSumError specular;   ///< luminance, of what is asked for: Σ N·L·R·(N·H)^(n·mn)
    LightSumError rounding;   ///< the same against the way's own formula: what storage alone costs
};

/// How bench_light_buffers() measures.
struct LightBufferBench {
    std::vector<uint32_t> overlaps{1, 4, 16, 64}; ///< numbers of lights on every pixel, one after the other
    uint32_t width = 160;                         ///< of the picture, pixels
    uint32_t height = 90;                         ///< likewise
    /// Called after each buffer with its figures, one for each overlap; may be empty.
    std::function<void(const std::vector<LightBufferFigures>&)> done;
};

/// Renders a wall of three roughnesses (exponents 4.3, 11.1 and 30) under coloured lights that all
/// reach all of it, [phong], with each light buffer, and compares the sums that its materials receive
/// with the reference's. Total light is the same for each overlap. The result depends on the device
/// only. Throws Error.
PRELIGHT_API std::vector<LightBufferFigures> bench_light_buffers(Device& device, const LightBufferBench& options);

} // namespace prelight
