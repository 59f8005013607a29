#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

namespace prelight::write {

/// A transform as glTF's nodes have it: scale, then rotation, then translation.
struct Placement {
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0}; ///< unit
    glm::dvec3 scale{1};
};

/// A mirrored matrix gets a negative x scale; a scale of zero is allowed. Absent: the matrix is not
/// finite, has shear, or a last row other than 0 0 0 1.
std::optional<Placement> decompose(const glm::dmat4& matrix);

} // namespace prelight::write
