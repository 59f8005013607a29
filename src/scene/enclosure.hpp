#pragma once
#include <optional>
#include <prelight/scene.hpp>

namespace prelight {

/// A camera named "inside" for a world that is a room, a courtyard or a street: one where nearly
/// every ray from the middle of the bounds, up to 27° above the horizon, meets the front of a surface, and that
/// is at least 3 m wide, deep and high, and of whose primitives at least half are then in the picture. It stands at eye
/// height at one end of the longest free line through the middle and looks along it. Nothing for a world that is seen
/// from outside, or one of more triangles than a moment's search allows.
std::optional<PlacedCamera> camera_inside(const World& world);

} // namespace prelight
