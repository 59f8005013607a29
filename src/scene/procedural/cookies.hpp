#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// A room whose lights throw pictures: a window, a lantern of pierced metal that turns, a dice, wall lamps with a
/// measured profile, a spot with both. `lights`: the first of them, then smaller ones of the same kinds at random
/// places.
Scene make_cookies_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
