#pragma once
#include <prelight/material.hpp>

namespace prelight {

/// Whether decals lie on what is made of it: not on what is soft, which ends nowhere in particular.
inline bool takes_decals(const Material& material) {
    return material.receives_decals && !(material.alpha_mode == AlphaMode::blend && material.softness > 0);
}

} // namespace prelight
