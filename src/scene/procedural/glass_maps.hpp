#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// A puff of smoke, white, 64 texels a side: alpha fades from the middle to nothing at the edge, unevenly.
TextureImage smoke_puff();
/// Normals of a ball's half, which is as wide as the puff.
TextureImage puff_slopes();

} // namespace prelight
