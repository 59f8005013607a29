#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Blended surfaces (alphaMode BLEND) before a brick wall, on a dark smooth floor: panes that cross, a long pane with
/// bottles before and behind it, bottles on a table, a glass ball around a knot, a lamp in its shade, a lantern in
/// smoke. Sorting objects by the middle of their bounds is wrong for the objects named "crossing pane", "long pane" and
/// "bottle beside the long pane", and right for all others from the camera "front".
Scene make_glass_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
