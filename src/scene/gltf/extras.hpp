#pragma once
#include <scene/gltf/nodes.hpp>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {

/// Takes over what `save_glb` keeps in `extras.prelight` (schema in scene/write/parts.hpp): ambient
/// light, environment, falloff, shininess, cookies and profiles of lights. After read_lights, which gives
/// `lights`. Extras of other programs are skipped.
void read_extras(Document& document, Buffers& buffers, Textures& textures, const Places& lights, Scene& scene);

/// The `extras.prelight` object of `item`, if there is one. Extras may be any JSON value; only an object can
/// hold ours.
std::optional<Item> own_extras(const Item& item);

} // namespace prelight::gltf
