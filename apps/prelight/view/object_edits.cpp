#include "object_edits.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <numbers>

namespace prelight::app::viewer {
namespace {

glm::dmat4 shifted(const glm::dmat4& transform, glm::dvec3 by) { return glm::translate(glm::dmat4(1), by) * transform; }

/// Whether a surface of the primitive can have the material: its maps need texture coordinates, a normal map tangents.
bool can_carry(const Primitive& primitive, const Material& material) {
    bool carries = !material.normal_texture || !primitive.tangents.empty();
    const auto look_at = [&](const TextureRef& map) {
        carries &= !map || !primitive.texcoords.at(std::min(map.texcoord, 1u)).empty();
    };
    for (const TextureRef* map : {&material.base_colour_texture, &material.metallic_roughness_texture,
                                  &material.normal_texture, &material.occlusion_texture, &material.emissive_texture})
        look_at(*map);
    for (const auto& [name, map] : material.textures)
        look_at(map);
    return carries && (!material.shader || !primitive.texcoords[0].empty());
}

} // namespace

InstanceBox box_of(const World& world, const Instance& instance) {
    constexpr double far = std::numeric_limits<double>::infinity();
    InstanceBox box{glm::dvec3(far), glm::dvec3(-far)};
    for (const Primitive& primitive : world.mesh_of(instance).primitives)
        for (const glm::vec3& position : primitive.positions) {
            const glm::dvec3 p(instance.transform * glm::dvec4(position, 1));
            box.low = glm::min(box.low, p);
            box.high = glm::max(box.high, p);
        }
    if (!(box.low.x <= box.high.x))
        box.low = box.high = glm::dvec3(instance.transform[3]);
    return box;
}

void ObjectEdits::turn(double radians) { turned_ = std::remainder(turned_ + radians, 2 * std::numbers::pi); }

void ObjectEdits::apply(World& world) const {
    if (empty())
        return;
    const glm::dvec3 size = world.bounds_max - world.bounds_min;
    const double widest = std::max({size.x, size.y, size.z}) / 2;
    for (Instance& instance : world.instances) {
        const InstanceBox box = box_of(world, instance);
        const glm::dvec3 own = box.high - box.low;
        glm::dmat4 edit(1);
        if (turned_ != 0 && std::max({own.x, own.y, own.z}) < widest) {
            const glm::dvec3 middle = (box.low + box.high) * 0.5;
            edit = shifted(glm::rotate(glm::dmat4(1), turned_, glm::dvec3(0, 1, 0)) * shifted(edit, -middle), middle);
        }
        if (const auto moved = moved_.find(instance.node); moved != moved_.end())
            edit = shifted(edit, moved->second);
        instance.transform = edit * instance.transform;
        if (instance.previous_transform) // it is no motion
            *instance.previous_transform = edit * *instance.previous_transform;
        const InstanceBox now = box_of(world, instance);
        world.bounds_min = glm::min(world.bounds_min, now.low);
        world.bounds_max = glm::max(world.bounds_max, now.high);
    }
}

bool take_next_material(Scene& scene, Mesh& mesh) {
    if (mesh.primitives.empty())
        return false;
    const auto count = static_cast<uint32_t>(scene.materials.size());
    const uint32_t first = mesh.primitives[0].material;
    for (uint32_t step = 1; step < count; ++step) {
        const uint32_t next = (first + step) % count;
        const Material& material = scene.materials[next];
        const bool fits =
            std::ranges::all_of(mesh.primitives, [&](const Primitive& p) { return can_carry(p, material); });
        if (!fits)
            continue;
        for (Primitive& primitive : mesh.primitives)
            primitive.material = next;
        return true;
    }
    return false;
}

} // namespace prelight::app::viewer
