#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {
namespace {

/// Factors that the specification keeps within 0 … 1.
float unit(const Item& item, std::string_view key, float absent) {
    return std::clamp(item.real(key, absent), 0.f, 1.f);
}

void read_metallic_roughness(const Item& item, Textures& textures, Material& material) {
    const auto base = item.numbers<4>("baseColorFactor", {1, 1, 1, 1});
    for (int c = 0; c < 4; ++c)
        material.base_colour[c] = float(std::clamp(base[size_t(c)], 0.0, 1.0));
    material.metallic = unit(item, "metallicFactor", 1);
    material.roughness = unit(item, "roughnessFactor", 1);
    material.base_colour_texture = textures.read(item, "baseColorTexture");
    material.metallic_roughness_texture = textures.read(item, "metallicRoughnessTexture");
}

void read_emissive(const Item& item, Textures& textures, Material& material) {
    const auto factor = item.numbers<3>("emissiveFactor", {0, 0, 0});
    double strength = 1;
    if (const auto extension = item.extension("KHR_materials_emissive_strength"))
        strength = extension->number("emissiveStrength", 1);
    for (int c = 0; c < 3; ++c) {
        material.emissive[c] = float(std::max(factor[size_t(c)], 0.0) * strength);
        if (!std::isfinite(material.emissive[c]) || material.emissive[c] < 0)
            item.fail("its emissive light is not finite and positive");
    }
    material.emissive_texture = textures.read(item, "emissiveTexture");
}

void read_alpha(Document& document, const Item& item, Material& material) {
    const std::string mode = item.text("alphaMode");
    if (mode == "MASK")
        material.alpha_mode = AlphaMode::mask;
    else if (mode == "BLEND")
        material.alpha_mode = AlphaMode::blend;
    else if (!mode.empty() && mode != "OPAQUE")
        item.fail(fmt::format("alphaMode \"{}\" is not known", printable(mode)));
    if (material.alpha_mode == AlphaMode::blend)
        document.warn("alphaMode BLEND is drawn opaque for now", item.label());
    material.alpha_cutoff = item.real("alphaCutoff", 0.5f);
}

Material read_material(Document& document, Textures& textures, const Item& item) {
    Material material;
    material.name = item.text("name");
    if (const auto inner = item.object("pbrMetallicRoughness"))
        read_metallic_roughness(*inner, textures, material);
    read_emissive(item, textures, material);
    read_alpha(document, item, material);
    material.normal_texture = textures.read(item, "normalTexture");
    if (const auto normal = item.object("normalTexture"))
        material.normal_scale = normal->real("scale", 1);
    material.occlusion_texture = textures.read(item, "occlusionTexture");
    if (const auto occlusion = item.object("occlusionTexture"))
        material.occlusion_strength = unit(*occlusion, "strength", 1);
    material.double_sided = item.flag("doubleSided");
    material.unlit = item.extension("KHR_materials_unlit").has_value();
    read_material_extras(textures, item, material);
    read_material_layers(document, textures, item, material);
    return material;
}

} // namespace

void read_materials(Document& document, Textures& textures, Scene& scene) {
    const size_t count = document.count(Table::materials);
    document.charge("materials", count, sizeof(Material));
    scene.materials.reserve(count + 1); // one more for primitives without a material
    for (size_t i = 0; i < count; ++i)
        scene.materials.push_back(
            read_material(document, textures, document.item(Table::materials, i)));
}

} // namespace prelight::gltf
