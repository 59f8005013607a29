#pragma once
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {

/// Fills `scene.meshes` from the file's; primitives that make no triangles are left out with a
/// warning. Adds a default material at the end of `scene.materials` when a primitive has none.
void read_meshes(Document& document, Buffers& buffers, Accessors& accessors, Scene& scene);

/// The `weights` of a mesh or of a node that shows it; empty when absent.
std::vector<float> read_weights(Document& document, const Item& item, const Mesh& mesh);

} // namespace prelight::gltf
