#pragma once
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::resident {

/// A tangent-space normal map and its mip maps, down to one texel: RGB the mean of the unit normals under a texel (its
/// length is below 1 where they differ), alpha the root of the variance of slopes that the mean has lost, (1 − |n|) /
/// |n| along either axis (Toksvig, "Mipmapping Normal Maps", 2004), 0 … 1; level 0 has lost nothing.
std::vector<TextureImage> normal_map_levels(const TextureImage& image);

} // namespace prelight::resident
