#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Throws Error "NAME: REASON": not twice as wide as high or too wide, a value that is no radiance, an intensity below
/// 0.
void check_environment(const Environment& environment);

} // namespace prelight
