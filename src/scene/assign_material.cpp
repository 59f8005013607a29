#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <prelight/scene.hpp>
#include <scene/tangents.hpp>

namespace prelight {

void assign_material_shader(Scene& scene, std::string_view name, std::shared_ptr<const MaterialShader> shader) {
    std::vector<bool> changed(scene.materials.size());
    std::vector<std::string_view> names;
    bool found = false;
    for (size_t m = 0; m < scene.materials.size(); ++m) {
        Material& material = scene.materials[m];
        if (names.size() < 20)
            names.push_back(material.name);
        if (material.name != name)
            continue;
        found = changed[m] = true;
        material.shader = shader;
        check_material(material, fmt::format("{}: material {} ({})", scene.name, m, name));
    }
    if (!found)
        throw UsageError(
            fmt::format("--material {}: {} has no such material ({})", name, scene.name, fmt::join(names, ", ")));
    for (Mesh& mesh : scene.meshes)
        for (Primitive& primitive : mesh.primitives) {
            const TextureRef& normals = scene.materials.at(primitive.material).normal_texture;
            if (changed[primitive.material] && primitive.tangents.empty() &&
                !primitive.texcoords[normals.texcoord & 1].empty())
                generate_tangents(primitive, normals);
        }
}

} // namespace prelight
