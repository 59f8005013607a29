#pragma once
#include <scene/gltf/document.hpp>

namespace prelight::gltf {

/// Takes over what `save_glb` keeps in `extras.prelight` (schema in scene/write/parts.hpp): ambient
/// light, falloff and shininess of lights. After read_lights. Extras of other programs are skipped;
/// wrong values below `prelight` are errors.
void read_extras(const Document& document, Scene& scene);

} // namespace prelight::gltf
