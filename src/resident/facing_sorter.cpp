#include "facing_sorter.hpp"
#include <algorithm>
#include <glm/geometric.hpp>

namespace prelight::resident {

size_t FacingSorter::sort(const Primitive& primitive, const shared::ObjectData& object, uint32_t* out) {
    // Depth is a linear function of a position, and what all have in common makes no difference.
    glm::dvec3 gradient(0);
    for (int row = 0; row < 3; ++row)
        gradient += forward_[row] * glm::dvec3(object.world_row[row]);
    order_.clear();
    for (uint32_t t = 0; t < primitive.indices.size() / 3; ++t)
        order_.emplace_back(glm::dot(gradient, glm::dvec3(primitive.positions[primitive.indices[3 * size_t(t)]])), t);
    std::sort(order_.begin(), order_.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    for (const auto& [depth, triangle] : order_)
        out = std::copy_n(&primitive.indices[3 * size_t(triangle)], 3, out);
    return primitive.indices.size();
}

} // namespace prelight::resident
