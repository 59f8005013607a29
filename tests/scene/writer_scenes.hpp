#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// A small scene with one of everything that the writer knows: each light kind and falloff, each
/// sampler, both texture-coordinate sets, transforms (mirrored, non-uniform, 10 km away, flat),
/// instances, both projections, two scenes, and meshes and primitives without triangles.
Scene scene_with_everything();

} // namespace prelight
