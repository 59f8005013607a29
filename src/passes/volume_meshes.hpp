#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace prelight::passes {

/// Points and triangles as light_volume.vert reads them; front faces outward, counter-clockwise.
struct VolumeMesh {
    std::vector<glm::vec3> points;
    std::vector<uint32_t> indices;
};

/// An icosphere of 80 triangles, scaled until its faces touch the unit sphere from outside.
VolumeMesh sphere_volume();
/// A cone with a capped end on `sides` sides: x, y on a polygon around the unit circle, z the ring:
/// 0 apex, 1 rim, 2 cap, 3 the cap's centre.
VolumeMesh cone_volume(uint32_t sides);
/// A box around a spot's cone: x and y are −1 or 1, z is 0 at the light and 1 at its range.
VolumeMesh box_volume();

} // namespace prelight::passes
