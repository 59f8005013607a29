#pragma once
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {

/// Takes over what `save_glb` keeps in `extras.prelight` (schema in scene/write/parts.hpp): ambient
/// light, environment, falloff, shininess, cookies and profiles of lights. After read_lights. Extras of other programs are
/// skipped; wrong values below `prelight` are errors.
void read_extras(Document& document, Buffers& buffers, Textures& textures, Scene& scene);

/// The `extras.prelight` object of `item`, if there is one. Extras may be any JSON value; only an object can
/// hold ours.
std::optional<Item> own_extras(const Item& item);

} // namespace prelight::gltf
