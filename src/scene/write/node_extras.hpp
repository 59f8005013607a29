#pragma once
#include <scene/write/parts.hpp>

namespace prelight::write {

/// A node's decal, emitter and whether decals lie on it, as `extras.prelight` of its entry. Throws Error beginning
/// with `object`.
void set_node_extras(Json& entry, const Scene& scene, const Node& node, const std::string& object,
                     const Document& document);

} // namespace prelight::write
