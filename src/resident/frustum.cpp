#include "frustum.hpp"
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

namespace prelight::resident {

Frustum::Frustum(const glm::mat4& clip_from_relative) {
    glm::dvec4 row[4]{};
    for (int r = 0; r < 4; ++r)
        row[r] = glm::row(clip_from_relative, r);
    const glm::dvec4 planes[] = {row[3] + row[0], row[3] - row[0], row[3] + row[1],
                                 row[3] - row[1], row[3] - row[2], row[2]};
    for (size_t p = 0; p < planes_.size(); ++p)
        planes_[p] = {glm::dvec3(planes[p]), glm::abs(glm::dvec3(planes[p])), planes[p].w};
}

bool Frustum::may_show(const Draw& draw, const glm::dvec3& origin) const {
    const glm::dvec3 middle = 0.5 * (draw.low + draw.high) - origin, half = 0.5 * (draw.high - draw.low);
    const glm::dvec3 reach = glm::abs(middle) + half;
    for (const Plane& plane : planes_) {
        const double most = glm::dot(plane.normal, middle) + glm::dot(plane.size, half) + plane.offset;
        const double rounding = 1e-5 * (glm::dot(plane.size, reach) + std::abs(plane.offset));
        if (most < -rounding)
            return false;
    }
    return true;
}

} // namespace prelight::resident
