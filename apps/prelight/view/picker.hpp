#pragma once
#include "camera_rig.hpp"
#include "light_edits.hpp"

namespace prelight::app::viewer {

/// What a ray meets first.
struct Hit {
    uint32_t instance = 0; ///< index into World::instances
    double distance = 0;   ///< metres
    glm::dvec3 position{0};
};
/// Triangle by triangle, on the host. What alpha masks cut out counts as being there.
std::optional<Hit> hit_by(const World& world, const Ray& ray);

/// Lights by how near they show to a point of the picture, those that do not show at all last.
std::vector<uint32_t> lights_near(const std::vector<LightEdits::Listed>& lights, const PlacedCamera& camera,
                                  const PicturePoint& point);

} // namespace prelight::app::viewer
