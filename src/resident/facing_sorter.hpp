#pragma once
#include <glm/vec3.hpp>
#include <prelight/scene.hpp>
#include <shared/frame.h>
#include <utility>
#include <vector>

namespace prelight::resident {

/// Puts triangles that face the viewer (Primitive::facing) into the order in which they are blended. All of them are
/// parallel to the picture, so that those of one primitive do not cross, and the order is that of their fragments.
class FacingSorter {
public:
    /// `forward`: unit, the camera's axis.
    explicit FacingSorter(const glm::dvec3& forward) : forward_(forward) {}
    /// Writes the primitive's indices to `out`, the farthest triangles first, at one depth in the primitive's order.
    /// Returns how many.
    size_t sort(const Primitive& primitive, const shared::ObjectData& object, uint32_t* out);

private:
    glm::dvec3 forward_;
    std::vector<std::pair<double, uint32_t>> order_; ///< depth and number of each triangle
};

} // namespace prelight::resident
