#include <glm/geometric.hpp>
#include <prelight/camera.hpp>

namespace prelight {

PlacedCamera look_at(const Camera& camera, glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up) {
    const glm::dvec3 back = glm::normalize(eye - target);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return {camera, eye, glm::dmat3(right, glm::cross(back, right), back)};
}

} // namespace prelight
