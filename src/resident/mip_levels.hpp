#pragma once
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::resident {

/// The mip levels 1 … of a picture, down to 1×1, made on the host: each texel the mean of those of the level before
/// that it covers, an odd side's last one of three, in linear light where colours are `srgb`. Alpha is linear.
std::vector<TextureImage> mip_levels(const TextureImage& image, bool srgb);

} // namespace prelight::resident
