#include "scene_facts.hpp"

#include "argument.hpp"
#include "extension_uses.hpp"
#include "scene_files.hpp"
#include "scene_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <platform/program/standard_streams.hpp>
#include <prelight/light_distribution.hpp>
#include <prelight/material_shader.hpp>
#include <scene/gltf/extensions.hpp>
#include <set>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// JSON knows no infinity.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <typename T>
uint64_t bytes_of(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

uint64_t geometry_bytes(const Primitive& p) {
    uint64_t bytes = bytes_of(p.positions) + bytes_of(p.normals) + bytes_of(p.tangents) + bytes_of(p.texcoords[0]) +
                     bytes_of(p.texcoords[1]) + bytes_of(p.colours) + bytes_of(p.indices);
    for (const JointSet& set : p.joint_sets)
        bytes += bytes_of(set.joints) + bytes_of(set.weights);
    for (const MorphTarget& target : p.morph_targets)
        bytes += bytes_of(target.positions) + bytes_of(target.normals) + bytes_of(target.tangents);
    return bytes;
}

Json mesh_json(const Scene& scene, const Mesh& mesh) {
    uint64_t vertices = 0, triangles = 0;
    size_t targets = 0;
    bool skinned = false;
    std::set<std::string> materials;
    for (const Primitive& p : mesh.primitives) {
        vertices += p.positions.size();
        triangles += p.indices.size() / 3;
        targets = std::max(targets, p.morph_targets.size());
        skinned = skinned || !p.joint_sets.empty();
        materials.insert(scene.materials.at(p.material).name);
    }
    return {{"name", mesh.name},        {"primitives", mesh.primitives.size()},
            {"vertices", vertices},     {"triangles", triangles},
            {"morph_targets", targets}, {"skinned", skinned},
            {"materials", materials}};
}

Json material_json(const Material& m) {
    Json textures = Json::array();
    for (const auto& [name, texture] :
         {std::pair("base-colour", &m.base_colour_texture),
          std::pair("metallic-roughness", &m.metallic_roughness_texture), std::pair("normal", &m.normal_texture),
          std::pair("occlusion", &m.occlusion_texture), std::pair("emissive", &m.emissive_texture)})
        if (*texture)
            textures.push_back(name);
    for (const auto& [name, texture] : m.textures)
        if (texture)
            textures.push_back(name);
    return {{"name", m.name},
            {"shader", m.shader  ? m.shader->name
                       : m.unlit ? "unlit"
                                 : "metallic-roughness"},
            {"alpha", m.alpha_mode == AlphaMode::opaque ? "opaque"
                      : m.alpha_mode == AlphaMode::mask ? "mask"
                                                        : "blend"},
            {"double_sided", m.double_sided},
            {"emits", m.emissive != glm::vec3(0)},
            {"textures", textures}};
}

Json light_json(const Scene& scene, const Light& light, uint64_t placed) {
    const bool sun = light.kind == LightKind::directional;
    Json json = {{"name", light.name},
                 {"kind", sun                              ? "directional"
                          : light.kind == LightKind::point ? "point"
                                                           : "spot"},
                 {"intensity", light.intensity},
                 {"unit", sun                     ? "lx"
                          : light.profile_candela ? "x profile"
                                                  : "cd"},
                 {"colour", {light.colour.r, light.colour.g, light.colour.b}},
                 {"range_m", finite_or_null(light.range)},
                 {"placed", placed}};
    if (light.kind == LightKind::spot)
        json.update(
            {{"inner_cone_degrees", degrees(light.inner_cone)}, {"outer_cone_degrees", degrees(light.outer_cone)}});
    if (light.cookie != no_cookie)
        json["cookie"] = scene.images.at(light.cookie).name;
    if (light.profile)
        json["profile"] = light.profile->name;
    return json;
}

Json camera_json(const Camera& camera) {
    const bool perspective = camera.kind == ProjectionKind::perspective;
    Json json = {{"name", camera.name}, {"kind", perspective ? "perspective" : "orthographic"}};
    if (perspective)
        json["yfov_degrees"] = degrees(camera.yfov);
    else
        json["height_m"] = 2 * camera.ymag;
    json.update({{"near_m", camera.znear}, {"far_m", finite_or_null(camera.zfar)}});
    return json;
}

Json animation_json(const Animation& animation) {
    double seconds = 0;
    uint64_t keyframes = 0;
    for (const AnimationSampler& sampler : animation.samplers) {
        seconds = std::max(seconds, double(sampler.times.back()));
        keyframes += sampler.times.size();
    }
    return {{"name", animation.name},
            {"seconds", seconds},
            {"channels", animation.channels.size()},
            {"keyframes", keyframes}};
}

template <class Entries, class ToJson>
Json list_of(const Entries& entries, const ToJson& to_json) {
    Json list = Json::array();
    for (const auto& entry : entries)
        list.push_back(to_json(entry));
    return list;
}

Json extensions_json(const ExtensionUses& uses) {
    Json list = Json::array();
    for (const auto& [name, use] : uses.extensions) {
        const gltf::Extension extension = gltf::find_extension(name);
        list.push_back({{"name", name},
                        {"objects", use.objects},
                        {"required", use.required},
                        {"honoured", extension.honoured == gltf::Honoured::whole    ? "whole"
                                     : extension.honoured == gltf::Honoured::partly ? "partly"
                                                                                    : "not"},
                        {"how", extension.how}});
    }
    return list;
}

Json memory_json(const Scene& scene, uint64_t file_bytes) {
    uint64_t geometry = 0, pictures = 0, with_levels = 0;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            geometry += geometry_bytes(primitive);
    for (const TextureImage& image : scene.images) {
        pictures += image.rgba.size();
        for (uint64_t w = image.width, h = image.height; !image.rgba.empty();
             w = std::max<uint64_t>(w / 2, 1), h = std::max<uint64_t>(h / 2, 1)) {
            with_levels += w * h * 4;
            if (w == 1 && h == 1)
                break;
        }
    }
    return {{"files_bytes", file_bytes},
            {"geometry_bytes", geometry},
            {"pictures_bytes", pictures},
            {"pictures_with_levels_bytes", with_levels}};
}

} // namespace

nlohmann::ordered_json scene_facts(const InfoCommand& command, const Scene& scene, const World& world) {
    const bool file = names_file(command.scene);
    ExtensionUses uses;
    uint64_t file_bytes = 0;
    Json other_files = Json::array();
    if (file) {
        const std::filesystem::path scene_file =
            is_standard_stream(command.scene) ? standard_input_file() : std::filesystem::path(command.scene);
        uses = extension_uses(json_of(scene_file));
        std::vector<std::filesystem::path> files = files_named_in(command.scene);
        for (const std::filesystem::path& other : files)
            other_files.push_back(other.string());
        files.push_back(scene_file);
        std::error_code missing;
        for (const std::filesystem::path& one : files)
            if (const uint64_t size = std::filesystem::file_size(one, missing); !missing)
                file_bytes += size;
    }
    std::vector<uint64_t> placed(scene.lights.size(), 0);
    for (const Node& node : scene.nodes)
        if (node.light)
            ++placed.at(*node.light);
    Json lights = Json::array();
    for (size_t i = 0; i < scene.lights.size(); ++i)
        lights.push_back(light_json(scene, scene.lights[i], placed[i]));
    const auto point = [](const glm::dvec3& p) { return Json{p.x, p.y, p.z}; };
    const bool any = world.triangles > 0;
    return {
        {"prelight_info", 1},
        {"scene", command.scene},
        {"built_in", !file},
        {"generator", uses.generator},
        {"other_files", other_files},
        {"scenes", list_of(scene.scenes,
                           [](const SceneRoot& s) {
                               return Json{{"name", s.name}, {"roots", s.nodes.size()}};
                           })},
        {"shown", scene.default_scene},
        {"world",
         {{"instances", world.instances.size()},
          {"triangles", world.triangles},
          {"lights", is_lit(scene) ? world.lights.size() : 0}, // else resolve() lends one
          {"decals", world.decals.size()},
          {"bounds_m", any ? Json{{"min", point(world.bounds_min)}, {"max", point(world.bounds_max)}} : Json(nullptr)},
          {"camera", world.framed            ? "none: framed"
                     : world.cameras.empty() ? ""
                                             : world.cameras[0].camera.name}}},
        {"nodes", scene.nodes.size()},
        {"meshes", list_of(scene.meshes, [&](const Mesh& mesh) { return mesh_json(scene, mesh); })},
        {"materials", list_of(scene.materials, material_json)},
        {"pictures", list_of(scene.images,
                             [](const TextureImage& i) {
                                 return Json{{"name", i.name}, {"size", {i.width, i.height}}, {"bytes", i.rgba.size()}};
                             })},
        {"lights", lights},
        {"environment", scene.environment ? Json(scene.environment->name) : Json(nullptr)},
        {"cameras", list_of(scene.cameras, camera_json)},
        {"animations", list_of(scene.animations, animation_json)},
        {"skins", list_of(scene.skins,
                          [](const Skin& s) {
                              return Json{{"name", s.name}, {"joints", s.joints.size()}};
                          })},
        {"emitters", scene.emitters.size()},
        {"extensions", extensions_json(uses)},
        {"memory", memory_json(scene, file_bytes)},
        {"warnings", warnings_of(world)}};
}

} // namespace prelight::app
