#pragma once
#include <glm/vec3.hpp>
#include <span>

namespace prelight::resident {

struct Draw;

/// A box around all that casts or receives shadows, world space. Its centre is the origin of what casters and
/// tiles are relative to: it stays when the camera moves.
struct WorldBox {
    glm::dvec3 low{0}, high{0};
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    glm::dvec3 reach() const { return 0.5 * (high - low); }
};

WorldBox box_around(std::span<const Draw> draws);
/// Around those that are drawn over the opaque picture: blended and transmissive ones.
WorldBox box_around_layers(std::span<const Draw> draws);

} // namespace prelight::resident
