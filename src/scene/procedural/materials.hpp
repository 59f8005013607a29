#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Every built-in material on the same sphere, two rows of six, under coloured lights that go round (loop of
/// 8 s) and an environment of a sky, a window and a lamp.
Scene make_materials_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
