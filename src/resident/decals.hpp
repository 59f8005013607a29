#pragma once
#include <glm/mat4x4.hpp>
#include <prelight/scene.hpp>
#include <shared/decal.h>
#include <span>
#include <vector>

namespace prelight::resident {

/// A decal as it is drawn.
struct DecalBox {
    Decal decal;
    uint32_t features = 0; ///< FEATURE_… bits of its material's textures
    bool mirrored = false; ///< front faces are clockwise
    glm::dmat4 world_from_box{1}, box_from_world{1};
    glm::dvec3 low{0}, high{0}; ///< a box around it, world space
};

/// In the world's order. Throws Error: a material that is not there or has a shader of its own.
std::vector<DecalBox> decal_boxes(const World& world);

/// Whether one of them may hold something of what lies between `low` and `high`, world space.
bool reaches_any(std::span<const DecalBox> decals, const glm::dvec3& low, const glm::dvec3& high);

/// How the camera sees a decal's box.
enum class DecalView { unseen, from_outside, from_inside };

/// `eye`, `clip_from_world`: View::eye(), View::clip_from_world(). From inside as soon as the near plane may cut
/// the box.
DecalView view_of(const DecalBox& box, const glm::dvec3& eye, const glm::mat4& clip_from_world);

shared::DecalConstants decal_constants(const DecalBox& box, const glm::dvec3& eye, bool from_inside);

} // namespace prelight::resident
