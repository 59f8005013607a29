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
    double rms = 0;
    double max = 0;
    double bias = 0; ///< mean of the signed errors: below 0 is too dark
};

/// Figures of one light buffer or one way to a material's own shininess, with one number of
/// lights on every pixel.
struct LightBufferFigures {
    std::string name;                               ///< "RGBA8 packed, luminance"
    std::string light_buffer, specular_way, writes; ///< values of the settings
    double scale = 1;       ///< `light-scale` of the fixed-point buffers; the brightest sum is 0.95
    uint32_t bytes = 0;     ///< a pixel, all targets
    uint32_t overlap = 0;   ///< lights on every pixel
    LightSumError diffuse;  ///< of Σ N·L·R in RGB
    LightSumError specular; ///< luminance, of what is asked for: Σ N·L·R·(N·H)^(n·mn)
    LightSumError rounding; ///< the same against the way's own formula: what storage alone costs
};

struct LightBufferBench {
    std::vector<uint32_t> overlaps{1, 4, 16, 64};
    uint32_t width = 160, height = 90;
    /// Called after each buffer with its figures, one for each overlap; may be empty.
    std::function<void(const std::vector<LightBufferFigures>&)> done;
};

/// Renders a wall of three roughnesses (exponents 4.3, 11.1 and 30) under coloured lights that all
/// reach all of it, [phong], with each light buffer, and compares the sums that its materials receive
/// with the reference's. Total light is the same for each overlap. The result depends on the device
/// only. Throws Error.
PRELIGHT_API std::vector<LightBufferFigures> bench_light_buffers(Device& device, const LightBufferBench& options);

} // namespace prelight
