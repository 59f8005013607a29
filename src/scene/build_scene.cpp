#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <prelight/error.hpp>
#include <prelight/scene_building.hpp>
#include <scene/finite.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

/// "SCENE: OBJECT: REASON".
class Faults {
public:
    Faults(const Scene& scene, std::string_view kind, std::string_view name)
        : about_(fmt::format("{}: {} {}", scene.name.empty() ? "scene" : scene.name, kind, name)) {}
    void refuse_if(bool wrong, std::string_view reason) const {
        if (wrong)
            throw Error(fmt::format("{}: {}", about_, reason));
    }

private:
    std::string about_;
};

template <class Vector>
bool all_finite(const std::vector<Vector>& list) {
    return std::ranges::all_of(list, [](const Vector& one) {
        for (int i = 0; i < Vector::length(); ++i)
            if (!std::isfinite(one[i]))
                return false;
        return true;
    });
}

template <class Vector>
bool all_of_unit_length(const std::vector<Vector>& list) {
    return std::ranges::all_of(list, [](const Vector& one) {
        const float length = std::hypot(one.x, one.y, one.z);
        return std::abs(length - 1) < 1e-3f; // false for what is not finite
    });
}

void check_vertices(const Faults& faults, const Primitive& primitive) {
    const size_t count = primitive.positions.size();
    const auto attribute = [&](const auto& list, const char* name) {
        faults.refuse_if(!list.empty() && list.size() != count,
                         fmt::format("{} {} for {} positions", list.size(), name, count));
        faults.refuse_if(!all_finite(list), fmt::format("{}: a number that is not finite", name));
    };
    faults.refuse_if(count == 0, "no positions");
    attribute(primitive.positions, "positions");
    attribute(primitive.normals, "normals");
    attribute(primitive.tangents, "tangents");
    attribute(primitive.texcoords[0], "texture coordinates");
    attribute(primitive.texcoords[1], "texture coordinates (second set)");
    attribute(primitive.colours, "colours");
    attribute(primitive.facing, "offsets towards the viewer's right and up");
    faults.refuse_if(!all_of_unit_length(primitive.normals), "a normal that is not of unit length");
    faults.refuse_if(!all_of_unit_length(primitive.tangents), "a tangent that is not of unit length");
    faults.refuse_if(!primitive.joint_sets.empty() || !primitive.morph_targets.empty(),
                     "joints and morph targets are for nodes that a program makes itself");
    for (const uint32_t index : primitive.indices)
        faults.refuse_if(index >= count, fmt::format("index {} of {} positions", index, count));
    faults.refuse_if(primitive.indices.size() % 3 != 0,
                     fmt::format("{} indices are no whole triangles", primitive.indices.size()));
}

/// Calls `visit(texture, what it is)`.
template <class Visit>
void each_texture(const Material& material, Visit visit) {
    visit(material.base_colour_texture, "the base colour");
    visit(material.metallic_roughness_texture, "metallic and roughness");
    visit(material.normal_texture, "the normal map");
    visit(material.occlusion_texture, "occlusion");
    visit(material.emissive_texture, "emission");
    for (const auto& [name, texture] : material.textures)
        visit(texture, name);
}

} // namespace

uint32_t add_image(Scene& scene, TextureImage image) {
    const Faults faults(scene, "image", image.name);
    faults.refuse_if(image.width == 0 || image.height == 0, "has no pixels");
    faults.refuse_if(image.rgba.size() != size_t(image.width) * image.height * 4,
                     fmt::format("{} bytes for {}x{} pixels of 4", image.rgba.size(), image.width, image.height));
    scene.images.push_back(std::move(image));
    return static_cast<uint32_t>(scene.images.size() - 1);
}

uint32_t add_material(Scene& scene, Material material) {
    const Faults faults(scene, "material", material.name);
    each_texture(material, [&](const TextureRef& texture, std::string_view kind) {
        faults.refuse_if(texture && texture.image >= scene.images.size(),
                         fmt::format("{}: image {} of {}", kind, texture.image, scene.images.size()));
        faults.refuse_if(texture.texcoord > 1, fmt::format("{}: texture coordinates {}", kind, texture.texcoord));
    });
    faults.refuse_if(!(material.softness >= 0) || !std::isfinite(material.softness),
                     fmt::format("softness {}: not metres ≥ 0", material.softness));
    scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

uint32_t add_object(Scene& scene, std::string name, Primitive primitive, uint32_t material,
                    const glm::dmat4& transform) {
    const Faults faults(scene, "object", name);
    faults.refuse_if(material >= scene.materials.size(),
                     fmt::format("material {} of {}", material, scene.materials.size()));
    const glm::dvec4 last(transform[0][3], transform[1][3], transform[2][3], transform[3][3]);
    faults.refuse_if(!is_finite(transform) || last != glm::dvec4(0, 0, 0, 1),
                     "its transform is none of objects (finite, last row 0 0 0 1)");
    faults.refuse_if(!scene.scenes.empty() && scene.default_scene >= scene.scenes.size(),
                     fmt::format("default tree {} of {}", scene.default_scene, scene.scenes.size()));
    if (primitive.indices.empty()) {
        primitive.indices.resize(primitive.positions.size());
        std::iota(primitive.indices.begin(), primitive.indices.end(), 0u);
    }
    check_vertices(faults, primitive);
    primitive.material = material;
    if (!primitive.facing.empty()) { // in the viewer's axes, where the triangles lie in a plane
        if (primitive.normals.empty())
            primitive.normals.assign(primitive.positions.size(), {0, 0, 1});
        if (primitive.tangents.empty())
            primitive.tangents.assign(primitive.positions.size(), {1, 0, 0, 1});
    }
    if (primitive.normals.empty())
        make_flat_normals(primitive);
    const Material& shown = scene.materials[material];
    each_texture(shown, [&](const TextureRef& texture, std::string_view kind) {
        faults.refuse_if(texture && primitive.texcoords[texture.texcoord].empty(),
                         fmt::format("no texture coordinates for {} of its material", kind));
    });
    const TextureRef& normals = shown.normal_texture;
    // A shader of its own may read any texture as a normal map.
    if (primitive.tangents.empty() && (normals || shown.shader) && !primitive.texcoords[normals.texcoord].empty())
        generate_tangents(primitive, normals);
    Node node;
    node.name = name;
    node.local = transform;
    node.mesh = static_cast<uint32_t>(scene.meshes.size());
    scene.meshes.push_back({std::move(name), {std::move(primitive)}});
    scene.nodes.push_back(std::move(node));
    if (scene.scenes.empty())
        scene.scenes.push_back({scene.name, {}});
    const auto number = static_cast<uint32_t>(scene.nodes.size() - 1);
    scene.scenes[scene.default_scene].nodes.push_back(number);
    return number;
}

} // namespace prelight
