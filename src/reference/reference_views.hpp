#pragma once
#include <reference/trace.hpp>
#include <string_view>

namespace prelight::reference {

/// Draws a buffer so that a person can read it, display-encoded 0 … 1:
/// as the views of the same names that renderers on a device give, so that they can be compared.
/// `depth`: white at the camera, halved at each doubling of 1 + distance / 10 m, black background;
/// `normal`: world-space shading normal, −1 … 1 → 0 … 1; `albedo`: base colour, sRGB;
/// `diffuse-light`, `specular-light`: the light sums times `exposure_factor` / π, tone-mapped;
/// `light-count`: lights with attenuation and N·L above zero, black, blue, cyan, green, yellow, red,
/// white at 0, 1, 4, 16, 64, 256, 1,024; `layers`: blended surfaces in front, in the same colours; `layer=N`: the Nth
/// of them by its alpha over black, tone-mapped; `sample=N`, `depth-sample=N`, `normal-sample=N`: one sample of the
/// picture, tone-mapped, and of those two. All others show what is opaque.
Image draw_view(std::string_view view, const ReferencePicture& picture, const ReferenceBuffers& buffers,
                double exposure_factor);

} // namespace prelight::reference
