#pragma once
#include <prelight/image.hpp>
#include <prelight/light_distribution.hpp>
#include <vector>

namespace prelight::resident {

/// One level of a map with a texel more on each side, which continues it: bilinear filtering at its edge finds there
/// what the map says lies there.
using EdgedLevel = Image;

/// Levels of a cookie, 0 first, those of each face of a cube together; in linear light. Level k has max(1, size >> k)
/// texels a side, each the mean of level 0 over what it covers. A spot's edge goes on as it is, a sphere's wraps
/// around, past the edge of a cube's face comes the next face.
std::vector<EdgedLevel> cookie_levels(const TextureImage& image, CookieKind kind);
/// Number of levels of a map of this size.
uint32_t level_count(uint32_t width, uint32_t height);

/// A profile in even steps, its largest value 1: columns around the axis from 0°, rows from its first to its last
/// angle. All its own angles are among them where one step can be found that has them all, at least a quarter of a
/// degree.
EdgedLevel profile_level(const LightProfile& profile);

} // namespace prelight::resident
