#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <scene/write/transform.hpp>

namespace prelight::write {
namespace {

constexpr double shear_limit = 1e-6; // cosine between two axes

bool finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

glm::dvec3 any_perpendicular(const glm::dvec3& v) {
    const glm::dvec3 axis = std::abs(v.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(v, axis));
}

/// Unit axes from columns of which some may be zero; right-handed unless all three are given.
glm::dmat3 axes_of(const glm::dmat3& linear, const glm::dvec3& scale) {
    glm::dmat3 axes(1);
    int known = -1, count = 0;
    for (int i = 0; i < 3; ++i)
        if (scale[i] > 0) {
            axes[i] = linear[i] / scale[i];
            known = i;
            ++count;
        }
    if (count == 0 || count == 3)
        return axes;
    if (count == 1)
        axes[(known + 1) % 3] = any_perpendicular(axes[known]);
    for (int i = 0; i < 3; ++i)
        if (count == 1 ? i == (known + 2) % 3 : scale[i] == 0)
            axes[i] = glm::cross(axes[(i + 1) % 3], axes[(i + 2) % 3]);
    return axes;
}

} // namespace

std::optional<Placement> decompose(const glm::dmat4& matrix) {
    if (!finite(matrix) || glm::row(matrix, 3) != glm::dvec4(0, 0, 0, 1))
        return {};
    const glm::dmat3 linear(matrix);
    Placement placement{.translation = glm::dvec3(matrix[3])};
    for (int i = 0; i < 3; ++i)
        placement.scale[i] = glm::length(linear[i]);
    glm::dmat3 axes = axes_of(linear, placement.scale);
    for (int i = 0; i < 3; ++i)
        if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > shear_limit)
            return {};
    if (glm::determinant(axes) < 0) {
        axes[0] = -axes[0];
        placement.scale.x = -placement.scale.x;
    }
    placement.rotation = glm::normalize(glm::quat_cast(axes));
    return placement;
}

} // namespace prelight::write
