#pragma once
#include "boxes.hpp"

namespace prelight::python {

/// Arrays of one primitive, as Scene.add_mesh() takes them.
struct GivenMesh {
    ArrayLike positions, indices;
    std::optional<ArrayLike> normals, texcoords, colours, tangents;
};
/// Checked; normals are of unit length, and where there are none each triangle's own. Throws UsageError.
Primitive make_primitive(const GivenMesh& given);

} // namespace prelight::python
