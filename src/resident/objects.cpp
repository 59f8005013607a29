#include "objects.hpp"
#include <algorithm>
#include <glm/geometric.hpp>

namespace prelight::resident {

shared::ObjectData object_data(const Instance& instance, glm::dvec3 camera) {
    glm::dmat4 m = instance.transform;
    m[3] -= glm::dvec4(camera, 0);
    glm::dmat4 previous = instance.previous_transform.value_or(instance.transform);
    previous[3] -= glm::dvec4(camera, 0);
    // The cofactors are the inverse transpose times the determinant: right for flattened objects too.
    const glm::dmat3 normal =
        glm::dmat3(glm::cross(glm::dvec3(m[1]), glm::dvec3(m[2])), glm::cross(glm::dvec3(m[2]), glm::dvec3(m[0])),
                   glm::cross(glm::dvec3(m[0]), glm::dvec3(m[1]))) *
        (instance.mirrored ? -1.0 : 1.0);
    // Only the direction counts: scaled so that float holds it.
    const double scale = 1 / std::max({glm::length(normal[0]), glm::length(normal[1]), glm::length(normal[2])});
    shared::ObjectData data{};
    for (int r = 0; r < 3; ++r) {
        data.world_row[r] = glm::vec4(m[0][r], m[1][r], m[2][r], m[3][r]);
        data.normal_row[r] = glm::vec4(glm::dvec3(normal[0][r], normal[1][r], normal[2][r]) * scale, 0);
        data.previous_world_row[r] = glm::vec4(previous[0][r], previous[1][r], previous[2][r], previous[3][r]);
    }
    data.normal_row[0].w = instance.mirrored ? -1 : 1;
    return data;
}

} // namespace prelight::resident
