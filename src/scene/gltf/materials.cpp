#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {
namespace {

/// Factors that the specification keeps within 0 … 1.
float unit(const Item& item, std::string_view key, float absent) { return item.real_within(key, absent, 0, 1); }

glm::vec4 colour(const Item& item, std::string_view key) {
    const auto factor = item.numbers_within<4>(key, {1, 1, 1, 1}, 0, 1);
    return {factor[0], factor[1], factor[2], factor[3]};
}

void read_metallic_roughness(const Item& item, Textures& textures, Material& material) {
    material.base_colour = colour(item, "baseColorFactor");
    material.metallic = unit(item, "metallicFactor", 1);
    material.roughness = unit(item, "roughnessFactor", 1);
    material.base_colour_texture = textures.read(item, "baseColorTexture");
    material.metallic_roughness_texture = textures.read(item, "metallicRoughnessTexture");
}

void read_emissive(const Item& item, Textures& textures, Material& material) {
    constexpr double largest = std::numeric_limits<float>::max();
    // Beyond 1 other programs have written strengths before there was an extension for them.
    const auto factor = item.numbers_within<3>("emissiveFactor", {0, 0, 0}, 0, largest);
    double strength = 1;
    if (const auto extension = item.extension("KHR_materials_emissive_strength"))
        strength = extension->real_within("emissiveStrength", 1, 0, float(largest));
    for (int c = 0; c < 3; ++c)
        material.emissive[c] = float(std::min(factor[size_t(c)] * strength, largest));
    material.emissive_texture = textures.read(item, "emissiveTexture");
}

void read_alpha(const Item& item, Material& material) {
    const std::string mode = item.text("alphaMode");
    if (mode == "MASK")
        material.alpha_mode = AlphaMode::mask;
    else if (mode == "BLEND")
        material.alpha_mode = AlphaMode::blend;
    else if (!mode.empty() && mode != "OPAQUE")
        item.warn("alphaMode \"{}\" is not known; OPAQUE is used", printable(mode));
    material.alpha_cutoff = item.real_within("alphaCutoff", 0.5f, 0, std::numeric_limits<float>::max());
}

Material read_material(Document& document, Textures& textures, const Item& item) {
    Material material;
    material.name = item.text("name");
    material.unlit = item.extension("KHR_materials_unlit").has_value();
    read_alpha(item, material);
    if (const auto extension = item.extension("KHR_materials_pbrSpecularGlossiness"))
        read_specular_glossiness(textures, *extension, material);
    else if (const auto inner = item.object("pbrMetallicRoughness"))
        read_metallic_roughness(*inner, textures, material);
    read_emissive(item, textures, material);
    material.normal_texture = textures.read(item, "normalTexture");
    if (const auto normal = item.object("normalTexture"))
        material.normal_scale = normal->real("scale", 1);
    material.occlusion_texture = textures.read(item, "occlusionTexture");
    if (const auto occlusion = item.object("occlusionTexture"))
        material.occlusion_strength = unit(*occlusion, "strength", 1);
    material.double_sided = item.flag("doubleSided");
    read_material_extras(textures, item, material);
    read_material_layers(document, textures, item, material);
    return material;
}

} // namespace

void read_materials(Document& document, Textures& textures, Scene& scene) {
    const size_t count = document.count(Table::materials);
    document.charge("materials", count, sizeof(Material));
    textures.decode_ahead();
    scene.materials.reserve(count + 1); // one more for primitives without a material
    for (size_t i = 0; i < count; ++i)
        scene.materials.push_back(read_material(document, textures, document.item(Table::materials, i)));
    textures.drop_early();
}

} // namespace prelight::gltf
