#pragma once
#include <scene/gltf/document.hpp>

namespace prelight::gltf {

/// The images that the file's materials show, as far as the reader reads such textures, each once, in the order of
/// materials. A guess by the names of keys: nothing is checked, warned of or refused.
std::vector<uint32_t> shown_images(const Document& document);

} // namespace prelight::gltf
