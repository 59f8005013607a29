#pragma once
#include <prelight/scene.hpp>
#include <shared/frame.h>

namespace prelight::resident {

/// The device's record of an object, now and at the previous state, relative to a camera that stands
/// at `camera` now.
shared::ObjectData object_data(const Instance& instance, glm::dvec3 camera);

} // namespace prelight::resident
