#pragma once
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {

/// Fills `scene.cameras` and `scene.lights`, one for each of the file's.
void read_cameras(const Document& document, Scene& scene);
void read_lights(const Document& document, Scene& scene);

/// Fills `scene.nodes` (after meshes, cameras and lights), proven to be a forest.
void read_nodes(Document& document, Accessors& accessors, Scene& scene);
/// Fills `scene.scenes` and the default one; a file without scenes gets one of all root nodes.
void read_scenes(Document& document, Scene& scene);

} // namespace prelight::gltf
