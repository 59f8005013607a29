#pragma once
#include <reference/trace.hpp>
#include <string_view>

namespace prelight::reference {

/// Draws a buffer so that a person can read it, display-encoded 0 … 1:
/// `depth`: white at the nearest visible point, dark grey at the farthest, black background;
/// `normal`: world-space shading normal, −1 … 1 → 0 … 1; `albedo`: base colour, sRGB;
/// `diffuse-light`, `specular-light`: the light sums, times `exposure_factor`, through the tone
/// curve; `light-count`: lights with attenuation and N·L above zero: black 0, then blue, green,
/// yellow, red from 1 to 64 and more, by the logarithm.
Image draw_view(std::string_view view, const ReferencePicture& picture,
                const ReferenceBuffers& buffers, double exposure_factor, Tonemap curve);

} // namespace prelight::reference
