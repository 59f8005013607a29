#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// A puff of smoke, white, 64 texels a side: alpha fades from the middle to nothing at the edge, unevenly.
TextureImage smoke_puff();

} // namespace prelight
