#include <algorithm>
#include <fmt/format.h>
#include <prelight/material_shader.hpp>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {
namespace {

class Layers {
public:
    Layers(Textures& textures, Material& material)
        : textures_(textures), material_(material), shader_(find_material_shader("layered")) {}

    void number(const Item& extension, const char* key, const char* parameter, float absent) {
        set(extension, parameter, glm::vec4(extension.real(key, absent)));
    }
    void colour(const Item& extension, const char* key, const char* parameter, double absent) {
        const auto value = extension.numbers<3>(key, {absent, absent, absent});
        set(extension, parameter, glm::vec4(value[0], value[1], value[2], 0));
    }
    void map(const Item& extension, const char* key, const char* texture) {
        if (const TextureRef ref = textures_.read(extension, key)) {
            material_.textures[texture] = ref;
            material_.shader = shader_;
        }
    }

private:
    void set(const Item& extension, const char* name, glm::vec4 value) {
        const MaterialParameter& parameter = *shader_->find_parameter(name);
        bool differs = false;
        for (int c = 0; c < int(parameter.components); ++c) {
            if (const float v = value[c]; !(v >= parameter.low && v <= parameter.high)) {
                value[c] = std::clamp(v, parameter.low, parameter.high);
                extension.warn("{} {} is outside {} … {}; {} is used", name, v, parameter.low, parameter.high,
                               value[c]);
            }
            differs = differs || value[c] != parameter.default_value[c];
        }
        if (!differs)
            return;
        material_.parameters[name] = value;
        material_.shader = shader_;
    }
    Textures& textures_;
    Material& material_;
    std::shared_ptr<const MaterialShader> shader_;
};

/// What light comes through; a volume matters only there.
void read_transmission(Layers& layers, const Item& item) {
    const auto transmission = item.extension("KHR_materials_transmission");
    if (!transmission || !(transmission->real("transmissionFactor", 0) > 0))
        return;
    layers.number(*transmission, "transmissionFactor", "transmission", 0);
    layers.map(*transmission, "transmissionTexture", "transmission_map");
    const auto volume = item.extension("KHR_materials_volume");
    if (!volume)
        return;
    layers.number(*volume, "thicknessFactor", "thickness", 0);
    layers.map(*volume, "thicknessTexture", "thickness_map");
    layers.colour(*volume, "attenuationColor", "attenuation_colour", 1);
    if (const float distance = volume->real("attenuationDistance", 1); !(distance > 0))
        volume->warn("attenuationDistance {} is not above 0; nothing is absorbed", distance);
    else if (volume->has("attenuationDistance"))
        layers.number(*volume, "attenuationDistance", "attenuation_distance", 1);
}

} // namespace

void read_material_layers(Document& document, Textures& textures, const Item& item, Material& material) {
    if (material.unlit || material.shader)
        return;
    Layers layers(textures, material);
    if (const auto ior = item.extension("KHR_materials_ior")) {
        // 0 is glTF's word for a reflectance of 1 everywhere.
        const float value = ior->real("ior", 1.5f);
        if (value == 0)
            layers.number(*ior, "", "ior", 1000);
        else
            layers.number(*ior, "ior", "ior", 1.5f);
    }
    if (const auto specular = item.extension("KHR_materials_specular")) {
        layers.number(*specular, "specularFactor", "specular", 1);
        layers.colour(*specular, "specularColorFactor", "specular_colour", 1);
        layers.map(*specular, "specularTexture", "specular_map");
        layers.map(*specular, "specularColorTexture", "specular_colour_map");
    }
    if (const auto coat = item.extension("KHR_materials_clearcoat"); coat && coat->real("clearcoatFactor", 0) > 0) {
        layers.number(*coat, "clearcoatFactor", "clearcoat", 0);
        layers.number(*coat, "clearcoatRoughnessFactor", "clearcoat_roughness", 0);
        layers.map(*coat, "clearcoatTexture", "clearcoat_map");
        layers.map(*coat, "clearcoatRoughnessTexture", "clearcoat_roughness_map");
        if (coat->has("clearcoatNormalTexture"))
            document.warn("a clear coat takes the normals of what it covers", coat->label());
    }
    if (const auto sheen = item.extension("KHR_materials_sheen")) {
        layers.colour(*sheen, "sheenColorFactor", "sheen_colour", 0);
        layers.number(*sheen, "sheenRoughnessFactor", "sheen_roughness", 0);
        layers.map(*sheen, "sheenColorTexture", "sheen_colour_map");
        layers.map(*sheen, "sheenRoughnessTexture", "sheen_roughness_map");
    }
    read_transmission(layers, item);
}

} // namespace prelight::gltf
