#include "scene.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <tuple>

namespace prelight::resident {
namespace {

struct Placement {
    uint32_t first_index = 0;
    int32_t vertex_offset = 0;
};

uint16_t unorm16(float v) { return static_cast<uint16_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 65535)); }

VertexAttributes attributes_of(const Primitive& primitive, size_t v) {
    VertexAttributes a{};
    a.normal = primitive.normals[v];
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

template <class T>
std::span<const std::byte> bytes(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

} // namespace

Geometry upload_geometry(const gpu::Context& context, const World& world) {
    std::vector<glm::vec3> positions;
    std::vector<VertexAttributes> attributes;
    std::vector<uint32_t> indices;
    std::vector<std::vector<Placement>> placements;
    for (const Mesh& mesh : world.scene->meshes) {
        std::vector<Placement>& places = placements.emplace_back();
        for (const Primitive& primitive : mesh.primitives) {
            places.push_back({static_cast<uint32_t>(indices.size()), static_cast<int32_t>(positions.size())});
            positions.insert(positions.end(), primitive.positions.begin(), primitive.positions.end());
            for (size_t v = 0; v < primitive.positions.size(); ++v)
                attributes.push_back(attributes_of(primitive, v));
            indices.insert(indices.end(), primitive.indices.begin(), primitive.indices.end());
        }
    }
    if (positions.size() > 0x7fffffffu || indices.size() > 0xffffffffu)
        throw Error(fmt::format("{}: {} vertices and {} indices are more than one buffer addresses",
                                world.scene->name, positions.size(), indices.size()));

    Geometry geometry;
    for (uint32_t i = 0; i < world.instances.size(); ++i) {
        const Instance& instance = world.instances[i];
        const Mesh& mesh = world.scene->meshes[instance.mesh];
        for (size_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            const Material& material = world.scene->materials[primitive.material];
            if (primitive.indices.empty())
                continue;
            geometry.draws.push_back({placements[instance.mesh][p].first_index,
                                      static_cast<uint32_t>(primitive.indices.size()),
                                      placements[instance.mesh][p].vertex_offset, i, primitive.material,
                                      features_of(material), instance.mirrored, material.double_sided});
        }
    }
    std::stable_sort(geometry.draws.begin(), geometry.draws.end(), [](const Draw& a, const Draw& b) {
        return std::tie(a.features, a.material, a.first_index) < std::tie(b.features, b.material, b.first_index);
    });
    geometry.positions =
        gpu::make_device_buffer(context, "positions", bytes(positions), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    geometry.attributes =
        gpu::make_device_buffer(context, "vertex attributes", bytes(attributes), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    geometry.indices =
        gpu::make_device_buffer(context, "indices", bytes(indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    return geometry;
}

} // namespace prelight::resident
