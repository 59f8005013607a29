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
#include <parallel/parallel_for.hpp>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <scene/mesh_facts.hpp>
#include <scene/takes_decals.hpp>
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

void write_attributes(const Primitive& primitive, VertexAttributes* to) {
    for (size_t v = 0; v < primitive.positions.size(); ++v)
        to[v] = attributes_at(primitive, v);
}

/// The primitives that are shown, one behind the other in each buffer of vertices or indices. A buffer is written where
/// it is to stay: a second copy on the host would cost as much time as all the rest, for its fresh pages.
class Parts {
public:
    std::vector<Placement> add(const Mesh& mesh) {
        std::vector<Placement> places;
        for (const Primitive& primitive : mesh.primitives)
            places.push_back(add(primitive));
        return places;
    }

    size_t vertices() const { return vertices_; }
    size_t indices() const { return indices_; }
    bool moved() const { return moved_; } ///< a primitive was elsewhere before

    /// `write(primitive, to)`: one T for each of the primitive's vertices.
    template <class T, class Write>
    gpu::Buffer of_vertices(const gpu::Context& context, std::string_view name, VkBufferUsageFlags usage,
                            const Write& write) const {
        return make<T>(context, name, usage, vertices_,
                       [&](const Part& part, T* all) { write(*part.primitive, all + part.first_vertex); });
    }
    gpu::Buffer of_indices(const gpu::Context& context, std::string_view name, VkBufferUsageFlags usage) const {
        return make<uint32_t>(context, name, usage, indices_, [](const Part& part, uint32_t* all) {
            std::copy(part.primitive->indices.begin(), part.primitive->indices.end(), all + part.first_index);
        });
    }

private:
    struct Part {
        const Primitive* primitive;
        size_t first_vertex, first_index;
    };

    Placement add(const Primitive& primitive) {
        Placement place{static_cast<uint32_t>(indices_), static_cast<int32_t>(vertices_)};
        std::tie(place.low, place.high) = box_of(primitive.positions);
        parts_.push_back({&primitive, vertices_, indices_});
        vertices_ += primitive.positions.size();
        indices_ += primitive.indices.size();
        moved_ = moved_ || !primitive.previous_positions.empty();
        return place;
    }

    template <class T, class Write>
    gpu::Buffer make(const gpu::Context& context, std::string_view name, VkBufferUsageFlags usage, size_t count,
                     const Write& write) const {
        return gpu::make_device_buffer(context, name, count * sizeof(T), usage, [&](std::byte* bytes) {
            auto* all = reinterpret_cast<T*>(bytes);
            parallel_for(static_cast<uint32_t>(parts_.size()), [&](uint32_t i) { write(parts_[i], all); });
        });
    }

    std::vector<Part> parts_;
    size_t vertices_ = 0, indices_ = 0;
    bool moved_ = false;
};

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
    std::vector<VertexAttributes> all(primitive.positions.size());
    write_attributes(primitive, all.data());
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
    Parts parts;
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
            places->second = parts.add(mesh);
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
    if (parts.vertices() > 0x7fffffffu || parts.indices() > 0xffffffffu)
        throw Error(fmt::format("{}: {} vertices and {} indices are more than one buffer addresses", world.scene->name,
                                parts.vertices(), parts.indices()));
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
    const auto write_positions = [](const Primitive& primitive, glm::vec3* to) {
        std::copy(primitive.positions.begin(), primitive.positions.end(), to);
    };
    geometry.positions =
        parts.of_vertices<glm::vec3>(context, "positions", vertex | storage | deforms, write_positions);
    geometry.attributes =
        parts.of_vertices<VertexAttributes>(context, "vertex attributes", vertex | deforms, write_attributes);
    if (settings.motion && (on_device || parts.moved())) // the device fills in what it moves
        geometry.previous_positions = parts.of_vertices<glm::vec3>(
            context, "previous positions", vertex | deforms, [&](const Primitive& primitive, glm::vec3* to) {
                const auto& before = primitive.previous_positions;
                if (before.empty())
                    write_positions(primitive, to);
                else
                    std::copy(before.begin(), before.end(), to);
            });
    if (settings.surface_ids)
        geometry.groups =
            parts.of_vertices<uint32_t>(context, "smooth groups", vertex, [](const Primitive& primitive, uint32_t* to) {
                const std::vector<uint32_t> smooth = smooth_groups(primitive);
                std::copy(smooth.begin(), smooth.end(), to);
            });
    geometry.indices = parts.of_indices(context, "indices", VK_BUFFER_USAGE_INDEX_BUFFER_BIT | storage);
    return geometry;
}

} // namespace prelight::resident
