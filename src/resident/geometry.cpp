#include "decals.hpp"
#include "deformation.hpp"
#include "gpu_scene.hpp"
#include "objects.hpp"
#include "scene.hpp"
#include "smooth_groups.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <scene/mesh_facts.hpp>
#include <scene/takes_decals.hpp>
#include <set>
#include <shared/bindings.h>
#include <tuple>

namespace prelight::resident {
namespace {

struct Placement {
    uint32_t first_index = 0;
    int32_t vertex_offset = 0;
    glm::vec3 low{0}, high{0};
};

uint16_t unorm16(float v) { return static_cast<uint16_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 65535)); }

VertexAttributes attributes_at(const Primitive& primitive, size_t v) {
    VertexAttributes a{};
    a.normal = primitive.facing.empty() ? primitive.normals[v] : glm::vec3(primitive.facing[v], 0);
    a.tangent = primitive.tangents.empty() ? glm::vec4(1, 0, 0, 1) : primitive.tangents[v];
    if (!primitive.texcoords[0].empty())
        a.texcoord_0 = primitive.texcoords[0][v];
    if (!primitive.texcoords[1].empty())
        a.texcoord_1 = primitive.texcoords[1][v];
    const glm::vec4 colour = primitive.colours.empty() ? glm::vec4(1) : primitive.colours[v];
    for (int i = 0; i < 4; ++i)
        a.colour[i] = unorm16(colour[i]);
    return a;
}

void append_attributes(const Primitive& primitive, std::vector<VertexAttributes>& all) {
    const size_t before = all.size(), count = primitive.positions.size();
    all.resize(before + count);
    for (size_t v = 0; v < count; ++v)
        all[before + v] = attributes_at(primitive, v);
}

template <class T>
std::span<const std::byte> bytes(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

/// The world's vertices on the host.
class Vertices {
public:
    Vertices(bool motion, bool groups) : motion_(motion), grouped_(groups) {}

    /// Room for what add() will bring, so that large scenes are not copied again and again.
    void reserve(size_t vertex_count, size_t index_count) {
        positions.reserve(vertex_count);
        attributes.reserve(vertex_count);
        indices.reserve(index_count);
    }

    std::vector<Placement> add(const Mesh& mesh) {
        std::vector<Placement> places;
        for (const Primitive& primitive : mesh.primitives)
            places.push_back(add(primitive));
        return places;
    }

    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> previous; ///< as long as positions, or empty: nothing has moved
    std::vector<VertexAttributes> attributes;
    std::vector<uint32_t> indices;
    std::vector<uint32_t> groups; ///< as long as positions, or empty: nobody asked for them

private:
    Placement add(const Primitive& primitive) {
        Placement place;
        place.first_index = static_cast<uint32_t>(indices.size());
        place.vertex_offset = static_cast<int32_t>(positions.size());
        std::tie(place.low, place.high) = box_of(primitive.positions);
        if (motion_ && !primitive.previous_positions.empty() && !moved_) {
            previous = positions;
            moved_ = true;
        }
        if (moved_) {
            const auto& source =
                primitive.previous_positions.empty() ? primitive.positions : primitive.previous_positions;
            previous.insert(previous.end(), source.begin(), source.end());
        }
        positions.insert(positions.end(), primitive.positions.begin(), primitive.positions.end());
        append_attributes(primitive, attributes);
        indices.insert(indices.end(), primitive.indices.begin(), primitive.indices.end());
        if (grouped_) {
            const std::vector<uint32_t> smooth = smooth_groups(primitive);
            groups.insert(groups.end(), smooth.begin(), smooth.end());
        }
        return place;
    }

    bool motion_, grouped_;
    bool moved_ = false; ///< a primitive was elsewhere before
};

void reserve_for(const World& world, Vertices& vertices) {
    std::set<std::pair<const Mesh*, std::optional<uint32_t>>> shown;
    size_t vertex_count = 0, index_count = 0;
    for (const Instance& instance : world.instances) {
        const Mesh& mesh = drawn_mesh(world, instance);
        if (!shown.insert({&mesh, instance.deformed}).second)
            continue;
        for (const Primitive& primitive : mesh.primitives) {
            vertex_count += primitive.positions.size();
            index_count += primitive.indices.size();
        }
    }
    vertices.reserve(vertex_count, index_count);
}

bool device_deforms(const World& world) {
    for (const Instance& instance : world.instances)
        if (instance.deformed && deforms_on_device(world, *instance.deformed))
            return true;
    return false;
}

/// The first three indices.
std::vector<uint32_t> first_triangle(const Primitive& primitive) {
    return {primitive.indices.begin(),
            primitive.indices.begin() + std::min<ptrdiff_t>(3, std::ssize(primitive.indices))};
}

} // namespace

bool VertexRange::fits(const Primitive& primitive) const {
    return primitive.positions.size() == vertices && primitive.indices.size() == indices &&
           resident::first_triangle(primitive) == first_triangle;
}

std::vector<VertexAttributes> attributes_of(const Primitive& primitive) {
    std::vector<VertexAttributes> all;
    append_attributes(primitive, all);
    return all;
}

std::pair<glm::vec3, glm::vec3> box_of(std::span<const glm::vec3> points) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {low, high};
}

void Draw::bound(const glm::dmat4& transform) {
    const glm::dvec3 middle = 0.5 * (glm::dvec3(own_low) + glm::dvec3(own_high));
    const glm::dvec3 half = glm::dvec3(own_high) - middle;
    const glm::dvec3 centre(transform * glm::dvec4(middle, 1));
    glm::dvec3 reach(0);
    for (int axis = 0; axis < 3; ++axis)
        reach += glm::abs(glm::dvec3(transform[axis])) * half[axis];
    reach += static_cast<double>(facing_reach);
    low = centre - reach;
    high = centre + reach;
}

void Draw::place(const Instance& instance) {
    bound(instance.transform);
    normal_row = normal_rows(instance);
    visible = instance.visible;
}

Geometry upload_geometry(const gpu::Context& context, const World& world, const GpuSceneSettings& settings,
                         const MaterialShaders& shaders, std::span<const DecalBox> decals) {
    Vertices vertices(settings.motion, settings.surface_ids);
    reserve_for(world, vertices);
    // Of the meshes that are shown; the device writes vertices of its own for each deformed one.
    std::map<std::pair<const Mesh*, std::optional<uint32_t>>, std::vector<Placement>> placements;
    const bool on_device = device_deforms(world);
    Geometry geometry;
    geometry.deformed.resize(world.deformed.size());
    for (uint32_t i = 0; i < world.instances.size(); ++i) {
        const Instance& instance = world.instances[i];
        const Mesh& mesh = drawn_mesh(world, instance);
        const bool shaped = instance.deformed && deforms_on_device(world, *instance.deformed);
        const bool turned = shaped && world.deformations[*instance.deformed].turned;
        const auto [places, is_new] = placements.try_emplace({&mesh, instance.deformed});
        if (is_new) {
            places->second = vertices.add(mesh);
            if (instance.deformed)
                for (size_t p = 0; p < mesh.primitives.size(); ++p)
                    geometry.deformed[*instance.deformed].push_back(
                        {static_cast<uint32_t>(places->second[p].vertex_offset),
                         static_cast<uint32_t>(mesh.primitives[p].positions.size()), first_triangle(mesh.primitives[p]),
                         mesh.primitives[p].indices.size()});
        }
        for (size_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            const Material& material = world.scene->materials[primitive.material];
            if (primitive.indices.empty())
                continue;
            const Placement& place = places->second[p];
            Draw& draw = geometry.draws.emplace_back(
                Draw{place.first_index, static_cast<uint32_t>(primitive.indices.size()), place.vertex_offset, i,
                     primitive.material, features_of(*world.scene, material), shaders.index_of(material),
                     primitive.facing.empty() && instance.mirrored != turned, material.double_sided,
                     static_cast<uint32_t>(p), shaped ? nullptr : &primitive});
            draw.own_low = shaped ? world.deformations[*instance.deformed].low : place.low;
            draw.own_high = shaped ? world.deformations[*instance.deformed].high : place.high;
            draw.facing_reach = facing_reach(primitive);
            draw.place(instance);
            if (!primitive.facing.empty())
                draw.features |= FEATURE_FACING;
            if (instance.receives_decals && takes_decals(material) && reaches_any(decals, draw.low, draw.high))
                draw.features |= FEATURE_DECALS;
            if (settings.blends && material.alpha_mode == AlphaMode::blend)
                draw.features |= FEATURE_BLENDED;
            if (settings.transmits && transmits(material))
                draw.features |= FEATURE_TRANSMISSIVE;
            else if (draw.blended() && material.softness > 0)
                draw.features |= FEATURE_SOFT;
        }
    }
    if (vertices.positions.size() > 0x7fffffffu || vertices.indices.size() > 0xffffffffu)
        throw Error(fmt::format("{}: {} vertices and {} indices are more than one buffer addresses", world.scene->name,
                                vertices.positions.size(), vertices.indices.size()));
    std::stable_sort(geometry.draws.begin(), geometry.draws.end(), [](const Draw& a, const Draw& b) {
        return std::tie(a.shader, a.features, a.material, a.mirrored, a.first_index) <
               std::tie(b.shader, b.features, b.material, b.mirrored, b.first_index);
    });
    geometry.draws_of.resize(world.instances.size());
    for (uint32_t d = 0; d < geometry.draws.size(); ++d)
        geometry.draws_of[geometry.draws[d].object].push_back(d);
    constexpr VkBufferUsageFlags vertex = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
    const VkBufferUsageFlags storage = settings.trimmed ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : 0,
                             deforms = on_device ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : 0;
    geometry.positions =
        gpu::make_device_buffer(context, "positions", bytes(vertices.positions), vertex | storage | deforms);
    geometry.attributes =
        gpu::make_device_buffer(context, "vertex attributes", bytes(vertices.attributes), vertex | deforms);
    if (settings.motion && on_device && vertices.previous.empty())
        vertices.previous = vertices.positions; // the device fills in what moves
    if (!vertices.previous.empty())
        geometry.previous_positions =
            gpu::make_device_buffer(context, "previous positions", bytes(vertices.previous), vertex | deforms);
    if (settings.surface_ids)
        geometry.groups = gpu::make_device_buffer(context, "smooth groups", bytes(vertices.groups), vertex);
    geometry.indices = gpu::make_device_buffer(context, "indices", bytes(vertices.indices),
                                               VK_BUFFER_USAGE_INDEX_BUFFER_BIT | storage);
    return geometry;
}

} // namespace prelight::resident
