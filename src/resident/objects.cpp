#include "objects.hpp"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace prelight::resident {
namespace {

void set_rows(glm::vec4 (&rows)[3], const glm::dmat4& m, const glm::dvec3& camera) {
    for (int r = 0; r < 3; ++r)
        rows[r] = glm::vec4(m[0][r], m[1][r], m[2][r], m[3][r] - camera[r]);
}

} // namespace

std::array<glm::vec4, 3> normal_rows(const Instance& instance) {
    const glm::dmat4& m = instance.transform;
    // The cofactors are the inverse transpose times the determinant: right for flattened objects too.
    const glm::dmat3 normal =
        glm::dmat3(glm::cross(glm::dvec3(m[1]), glm::dvec3(m[2])), glm::cross(glm::dvec3(m[2]), glm::dvec3(m[0])),
                   glm::cross(glm::dvec3(m[0]), glm::dvec3(m[1]))) *
        (instance.mirrored ? -1.0 : 1.0);
    // Only the direction counts: scaled so that float holds it.
    const double scale = 1 / std::max({glm::length(normal[0]), glm::length(normal[1]), glm::length(normal[2])});
    std::array<glm::vec4, 3> rows{};
    for (int r = 0; r < 3; ++r)
        rows[static_cast<size_t>(r)] = glm::vec4(glm::dvec3(normal[0][r], normal[1][r], normal[2][r]) * scale, 0);
    rows[0].w = instance.mirrored ? -1 : 1;
    rows[2].w = static_cast<float>(std::cbrt(std::abs(glm::determinant(glm::dmat3(m)))));
    return rows;
}

shared::ObjectData object_data(const Instance& instance, const std::array<glm::vec4, 3>& normal_row,
                               const glm::dvec3& camera) {
    shared::ObjectData data{};
    set_rows(data.world_row, instance.transform, camera);
    std::copy(normal_row.begin(), normal_row.end(), data.normal_row);
    set_rows(data.previous_world_row, instance.previous_transform ? *instance.previous_transform : instance.transform,
             camera);
    return data;
}

} // namespace prelight::resident
