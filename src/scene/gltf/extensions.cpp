#include "extensions.hpp"

#include <algorithm>
#include <array>

namespace prelight::gltf {
namespace {

constexpr std::array extensions{
    Extension{"KHR_lights_punctual", Honoured::whole, "point, spot and directional lights"},
    Extension{"KHR_materials_unlit", Honoured::whole, "base colour, without light"},
    Extension{"KHR_materials_emissive_strength", Honoured::whole, "a factor on emission"},
    Extension{"KHR_materials_ior", Honoured::whole, "reflectance at normal incidence"},
    Extension{"KHR_materials_specular", Honoured::whole,
              "factor, colour, both textures, with the lights' mean Fresnel term"},
    Extension{"KHR_materials_clearcoat", Honoured::partly,
              "one specular sum serves coat and base; the coat's own normal map is not read"},
    Extension{"KHR_materials_sheen", Honoured::partly, "no lobe for each light: sheen of the light as a whole"},
    Extension{"KHR_materials_transmission", Honoured::partly,
              "the opaque picture behind; no other transmissive surface, not the back of the body"},
    Extension{"KHR_materials_volume", Honoured::partly, "refraction and absorption along the body's thickness texture"},
    Extension{"KHR_texture_transform", Honoured::whole, "with its texCoord"},
    Extension{"KHR_mesh_quantization", Honoured::whole, "integer attributes"},
    Extension{"KHR_draco_mesh_compression", Honoured::whole, "bitstream 2.2"},
    Extension{"EXT_meshopt_compression", Honoured::whole, "all modes and filters"},
    Extension{"EXT_texture_webp", Honoured::whole, "still pictures"},
    Extension{"EXT_mesh_gpu_instancing", Honoured::partly, "instances of a mesh with a skin are drawn once"},
    Extension{"KHR_materials_pbrSpecularGlossiness", Honoured::partly,
              "whole in forward shading and the light pre-pass; deferred shading takes the closest metallic-roughness"},
    Extension{"KHR_node_visibility", Honoured::whole, "as the file has it; it does not change with time"},
};

} // namespace

std::span<const Extension> known_extensions() { return extensions; }

Extension find_extension(std::string_view name) {
    const auto found = std::ranges::find(extensions, name, &Extension::name);
    return found != extensions.end() ? *found
                                     : Extension{name, Honoured::not_at_all, "not known: what it says is left out"};
}

} // namespace prelight::gltf
