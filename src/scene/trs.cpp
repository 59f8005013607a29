#include <cmath>
#include <prelight/animation.hpp>

namespace prelight {

glm::dmat4 Trs::matrix() const {
    glm::dmat4 m(1);
    // Not quite unit in real files.
    const double length = std::sqrt(glm::dot(rotation, rotation));
    if (length > 1e-12 && std::isfinite(length))
        m = glm::mat4_cast(rotation / length);
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= scale[axis];
    m[3] = glm::dvec4(translation, 1);
    return m;
}

} // namespace prelight
