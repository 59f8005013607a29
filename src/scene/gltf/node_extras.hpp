#pragma once
#include <scene/gltf/document.hpp>

namespace prelight::gltf {

/// Takes over a node's `extras.prelight` (schema in scene/write/parts.hpp): decals and emitters, appended to the
/// scene's lists, and whether decals lie on it. After materials.
void read_node_extras(Document& document, const Item& item, Node& node, Scene& scene);

} // namespace prelight::gltf
