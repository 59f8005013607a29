#pragma once
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {

/// By the file's index: the scene's; nothing where the file's is left out.
using Places = std::vector<std::optional<uint32_t>>;

/// Fills `scene.cameras` and `scene.lights`.
Places read_cameras(const Document& document, Scene& scene);
Places read_lights(const Document& document, Scene& scene);

/// Fills `scene.nodes` (after meshes, cameras and lights), proven to be a forest.
void read_nodes(Document& document, Accessors& accessors, const Places& cameras, const Places& lights, Scene& scene);
/// Fills `scene.scenes` and the default one; a file without scenes gets one of all root nodes.
void read_scenes(Document& document, Scene& scene);

} // namespace prelight::gltf
