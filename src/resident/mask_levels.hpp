#pragma once
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::resident {

/// A base-colour picture whose alpha is tested against `cutoff`, and its mip maps: RGB the mean of what a texel covers,
/// in linear light, and alpha scaled so that as much of each level passes the test, filtered as `sampler` filters it,
/// as of level 0 (I. Castaño, "Computing Alpha Mipmaps", 2010). Levels end where no factor does that: of a regular
/// pattern's mean there is all or nothing. What is farther away reads the last one, coarser than its pixels.
/// `cutoff` above 0: of the picture's own alpha, whatever it is multiplied by.
std::vector<TextureImage> mask_levels(const TextureImage& image, float cutoff, const Sampler& sampler);

/// Share of a picture that passes the test, 0 … 1.
double mask_coverage(const TextureImage& image, float cutoff, const Sampler& sampler, Filter filter);

} // namespace prelight::resident
