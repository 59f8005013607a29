#pragma once
#include <cstdint>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::resident {

/// The smooth group of each vertex: what triangles join is one group, and so are vertices with the same place and the
/// same normal, whatever their texture coordinates. A box has six, a ball one. A group's number is that of its first
/// vertex.
std::vector<uint32_t> smooth_groups(const Primitive& primitive);

} // namespace prelight::resident
