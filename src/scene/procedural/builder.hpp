#pragma once
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <prelight/scene.hpp>
#include <scene/procedural/shapes.hpp>
#include <string>
#include <utility>

namespace prelight {

/// Appends, and returns the new element's index.
template <typename T>
uint32_t append(std::vector<T>& list, T value) {
    list.push_back(std::move(value));
    return static_cast<uint32_t>(list.size() - 1);
}

/// Adds a mesh of one primitive with one material.
inline uint32_t add_mesh(Scene& scene, std::string name, Primitive primitive, uint32_t material) {
    primitive.material = material;
    Mesh mesh{.name = std::move(name), .primitives = {}};
    mesh.primitives.push_back(std::move(primitive));
    return append(scene.meshes, std::move(mesh));
}

/// A sheet that is blended. Both sides show, for it has no inside.
inline Material sheet_material(std::string name, glm::vec3 colour, float alpha, float roughness = 0.1f) {
    return {.name = std::move(name),
            .base_colour = glm::vec4(colour, alpha),
            .metallic = 0,
            .roughness = roughness,
            .alpha_mode = AlphaMode::blend,
            .double_sided = true};
}

/// Adds a node to scene.nodes and to the roots of scene.scenes.back().
inline Node& add_root(Scene& scene, std::string name, const glm::dmat4& local) {
    scene.scenes.back().nodes.push_back(static_cast<uint32_t>(scene.nodes.size()));
    scene.nodes.push_back({.name = std::move(name), .local = local});
    return scene.nodes.back();
}

inline glm::dmat4 translation(const glm::dvec3& offset) { return glm::translate(glm::dmat4(1), offset); }

/// Makes of a ground (make_ground()) an upright rectangle that faces the +z of `place`.
inline glm::dmat4 upright(const glm::dmat4& place) { return glm::rotate(place, full_turn / 4, glm::dvec3(1, 0, 0)); }

/// A node with a light at `position`.
inline Node& add_light(Scene& scene, Light light, const glm::dvec3& position) {
    Node& node = add_root(scene, {}, translation(position));
    node.light = append(scene.lights, std::move(light));
    return node;
}

/// A node with a light at `from` that shines towards `to`.
inline Node& add_light_towards(Scene& scene, Light light, const glm::dvec3& from, const glm::dvec3& to,
                               const glm::dvec3& up = {0, 1, 0}) {
    const PlacedCamera placed = look_at({}, from, to, up);
    Node& node = add_light(scene, std::move(light), from);
    node.local = glm::dmat4(placed.axes);
    node.local[3] = {from, 1};
    return node;
}

/// A node with a camera at `eye` looking at `target`, +Y up.
inline Node& add_camera(Scene& scene, const Camera& camera, const glm::dvec3& eye, const glm::dvec3& target) {
    const PlacedCamera placed = look_at(camera, eye, target);
    glm::dmat4 local(placed.axes);
    local[3] = {eye, 1};
    Node& node = add_root(scene, camera.name, local);
    node.camera = append(scene.cameras, camera);
    return node;
}

} // namespace prelight
