#pragma once
#include <array>
#include <prelight/scene.hpp>
#include <shared/frame.h>

namespace prelight::resident {

/// ObjectData::normal_row: it changes with the object, and not with the camera.
std::array<glm::vec4, 3> normal_rows(const Instance& instance);

/// The device's record of an object, now and at the previous state, relative to a camera that stands
/// at `camera` now.
shared::ObjectData object_data(const Instance& instance, const std::array<glm::vec4, 3>& normal_row,
                               const glm::dvec3& camera);

} // namespace prelight::resident
