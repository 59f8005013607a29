#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <prelight/material_shader.hpp>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {

// In the extension a surface has a diffuse colour d, a reflectance F0 at normal incidence, and the diffuse lobe
// d (1 − max F0). Metallic-roughness with base colour c and metalness m has c (1 − m) and 0.04 (1 − m) + c m.
void read_specular_glossiness(Textures& textures, const Item& extension, Material& material) {
    const auto diffuse = extension.numbers_within<4>("diffuseFactor", {1, 1, 1, 1}, 0, 1);
    const auto specular = extension.numbers_within<3>("specularFactor", {1, 1, 1}, 0, 1);
    const float glossiness = extension.real_within("glossinessFactor", 1, 0, 1);
    material.base_colour = {diffuse[0], diffuse[1], diffuse[2], diffuse[3]};
    material.base_colour_texture = textures.read(extension, "diffuseTexture");
    material.metallic = 0;
    material.roughness = 1 - glossiness;
    const TextureRef map = textures.read(extension, "specularGlossinessTexture");
    if (material.unlit)
        return;
    constexpr double dielectric = 0.04, rounding = 1e-4;
    const glm::dvec3 f0(specular[0], specular[1], specular[2]);
    if (!map && glm::all(glm::lessThan(glm::abs(f0 - dielectric), glm::dvec3(rounding)))) {
        const double largest = std::max({f0.r, f0.g, f0.b});
        for (int c = 0; c < 3; ++c)
            material.base_colour[c] = float(diffuse[size_t(c)] * (1 - largest));
        return;
    }
    if (!map && diffuse[0] + diffuse[1] + diffuse[2] == 0 && material.alpha_mode == AlphaMode::opaque) {
        material.base_colour = glm::vec4(glm::vec3(f0), diffuse[3]);
        material.base_colour_texture = {};
        material.metallic = 1;
        return;
    }
    material.shader = find_material_shader("specular-glossiness");
    material.parameters["specular"] = glm::vec4(glm::vec3(f0), 0);
    material.parameters["glossiness"] = glm::vec4(glossiness, 0, 0, 0);
    if (map)
        material.textures["specular_glossiness_map"] = map;
}

} // namespace prelight::gltf
