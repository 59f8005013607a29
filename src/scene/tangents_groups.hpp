#pragma once
#include <scene/tangents_faces.hpp>

namespace prelight::tangents {

/// Faces around one vertex that are connected by edges there and agree in orientation: their
/// corners at the vertex share a tangent space.
struct Group {
    uint32_t vertex = 0; ///< representative vertex
    bool preserving = false;
    std::vector<uint32_t> faces; ///< ascending
};

struct Groups {
    std::vector<Group> groups;
    std::vector<std::array<uint32_t, 3>> of_corner; ///< per face and corner, or `none`
};

/// Grows groups over the faces' neighbours. May set `preserving` of faces without texture area: the
/// first group that reaches such a face decides.
Groups build_groups(std::vector<Face>& faces);

/// Which corner of the face is the representative vertex; the face must have it.
uint32_t corner_at(const Face& face, uint32_t vertex);

} // namespace prelight::tangents
