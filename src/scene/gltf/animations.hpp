#pragma once
#include <scene/gltf/accessors.hpp>

namespace prelight::gltf {

/// Fills `scene.skins` (after nodes) and checks that each node's skin fits its mesh.
void read_skins(Document& document, Accessors& accessors, Scene& scene);
/// Fills `scene.animations` (after nodes). Channels that move nothing that is drawn are left out with
/// a warning.
void read_animations(Document& document, Accessors& accessors, Scene& scene);

} // namespace prelight::gltf
