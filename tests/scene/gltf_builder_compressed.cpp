#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wcast-qual"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#pragma GCC diagnostic pop

#include "gltf_builder.hpp"
#include <cmath>
#include <meshoptimizer.h>
#include <stdexcept>

namespace prelight::test {
namespace {
constexpr uint32_t cells = 4; ///< a grid of 4 × 4 quads in the plane z = 0, from 0 to 4

GltfBuilder grid_node() {
    GltfBuilder b;
    b.json["nodes"] = {{{"mesh", 0}}};
    b.json["scenes"] = {{{"nodes", {0}}}};
    return b;
}

/// Nodes 1 and 2 as joints of the skin of node 0, the second 8 m up.
void add_skin(GltfBuilder& b) {
    b.json["nodes"][0]["skin"] = 0;
    b.json["nodes"].push_back(Json::object());
    b.json["nodes"].push_back({{"translation", {0, 0, 8}}});
    b.json["skins"] = {{{"joints", {1, 2}}}};
}
} // namespace

GltfBuilder draco_grid(bool edgebreaker, Bytes* draco, bool with_joints) {
    draco::TriangleSoupMeshBuilder soup;
    soup.Start(int(cells * cells * 2));
    const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int normal = soup.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    const int joint = with_joints ? soup.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT16) : -1;
    const int weight = with_joints ? soup.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_FLOAT32) : -1;
    uint32_t face = 0;
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x)
            for (const bool upper : {false, true}) {
                const auto fx = float(x), fy = float(y);
                float corners[3][3] = {{fx, fy, 0}, {fx + 1, fy, 0}, {fx + 1, fy + 1, 0}};
                if (upper) {
                    corners[1][0] = fx + 1, corners[1][1] = fy + 1;
                    corners[2][0] = fx, corners[2][1] = fy + 1;
                }
                const float up[3] = {0, 0, 1};
                soup.SetAttributeValuesForFace(position, draco::FaceIndex(face), corners[0], corners[1], corners[2]);
                soup.SetAttributeValuesForFace(normal, draco::FaceIndex(face), up, up, up);
                if (with_joints) {
                    const uint16_t joints[4] = {0, 1, 0, 0};
                    float w[3][4] = {};
                    for (int c = 0; c < 3; ++c) {
                        w[c][1] = corners[c][0] / 4;
                        w[c][0] = 1 - w[c][1];
                    }
                    soup.SetAttributeValuesForFace(joint, draco::FaceIndex(face), joints, joints, joints);
                    soup.SetAttributeValuesForFace(weight, draco::FaceIndex(face), w[0], w[1], w[2]);
                }
                ++face;
            }
    const std::unique_ptr<draco::Mesh> mesh = soup.Finalize();
    draco::ExpertEncoder encoder(*mesh);
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
    if (!edgebreaker) // indices as they are, so that a test can reach them
        encoder.options().SetGlobalBool("compress_connectivity", false);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeToBuffer(&buffer).ok())
        throw std::runtime_error("draco encoder");
    const Bytes bytes(buffer.data(), buffer.data() + buffer.size());
    if (draco)
        *draco = bytes;
    GltfBuilder b = grid_node();
    b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const Json vec3 = {{"componentType", 5126}, {"type", "VEC3"}, {"count", encoder.num_encoded_points()}};
    const size_t positions = b.add_accessor(vec3), normals = b.add_accessor(vec3);
    const size_t indices = b.add_accessor({{"componentType", 5125}, {"type", "SCALAR"}, {"count", cells * cells * 6}});
    const Json extension = {
        {"bufferView", b.add_view(bytes)},
        {"attributes",
         {{"POSITION", mesh->attribute(position)->unique_id()}, {"NORMAL", mesh->attribute(normal)->unique_id()}}}};
    b.json["meshes"] = {{{"primitives",
                          {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                            {"indices", indices},
                            {"extensions", {{"KHR_draco_mesh_compression", extension}}}}}}}};
    if (with_joints) {
        const Json vec4 = {{"type", "VEC4"}, {"count", encoder.num_encoded_points()}};
        Json joints = vec4, weights = vec4;
        joints["componentType"] = 5123;
        weights["componentType"] = 5126;
        b.attributes()["JOINTS_0"] = b.add_accessor(joints);
        b.attributes()["WEIGHTS_0"] = b.add_accessor(weights);
        Json& packed = b.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"];
        packed["JOINTS_0"] = mesh->attribute(joint)->unique_id();
        packed["WEIGHTS_0"] = mesh->attribute(weight)->unique_id();
        add_skin(b);
    }
    return b;
}

GltfBuilder meshopt_grid(bool with_joints) {
    std::vector<float> positions;
    std::vector<uint32_t> indices;
    for (uint32_t y = 0; y <= cells; ++y)
        for (uint32_t x = 0; x <= cells; ++x)
            positions.insert(positions.end(), {float(x), float(y), 0});
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x) {
            const uint32_t i = y * (cells + 1) + x, above = i + cells + 1;
            indices.insert(indices.end(), {i, i + 1, above + 1, i, above + 1, above});
        }
    const size_t vertices = positions.size() / 3;
    Bytes packed(meshopt_encodeVertexBufferBound(vertices, 12));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), positions.data(), vertices, 12));
    Bytes packed_indices(meshopt_encodeIndexBufferBound(indices.size(), vertices));
    packed_indices.resize(
        meshopt_encodeIndexBuffer(packed_indices.data(), packed_indices.size(), indices.data(), indices.size()));
    // Normals through the octahedral filter: two components of 8 bits in 4 bytes.
    std::vector<float> normals;
    for (size_t i = 0; i < vertices; ++i)
        normals.insert(normals.end(), {0, 0, 1, 0});
    Bytes filtered(vertices * 4);
    meshopt_encodeFilterOct(filtered.data(), vertices, 4, 8, normals.data());
    Bytes packed_normals(meshopt_encodeVertexBufferBound(vertices, 4));
    packed_normals.resize(
        meshopt_encodeVertexBuffer(packed_normals.data(), packed_normals.size(), filtered.data(), vertices, 4));
    GltfBuilder b = grid_node();
    b.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    const auto compressed = [&b](const Bytes& bytes, size_t count, size_t stride, const char* mode,
                                 const char* filter) {
        Json extension = b.json["bufferViews"][b.add_view(bytes)];
        b.json["bufferViews"].erase(b.json["bufferViews"].size() - 1);
        extension["count"] = count;
        extension["byteStride"] = stride;
        extension["mode"] = mode;
        extension["filter"] = filter;
        // The view itself lies in the fallback buffer, which has no data.
        b.json["bufferViews"].push_back(
            {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{"EXT_meshopt_compression", extension}}}});
        return b.json["bufferViews"].size() - 1;
    };
    const size_t p = compressed(packed, vertices, 12, "ATTRIBUTES", "NONE");
    const size_t n = compressed(packed_normals, vertices, 4, "ATTRIBUTES", "OCTAHEDRAL");
    const size_t i = compressed(packed_indices, indices.size(), 4, "TRIANGLES", "NONE");
    b.json["buffers"].push_back(
        {{"byteLength", 4096}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    b.add_accessor({{"bufferView", p}, {"componentType", 5126}, {"type", "VEC3"}, {"count", vertices}});
    b.add_accessor(
        {{"bufferView", n}, {"componentType", 5120}, {"normalized", true}, {"type", "VEC3"}, {"count", vertices}});
    b.add_accessor({{"bufferView", i}, {"componentType", 5125}, {"type", "SCALAR"}, {"count", indices.size()}});
    b.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}}}}}};
    if (with_joints) {
        Bytes joints, weights; // four bytes each: weights normalised
        for (size_t v = 0; v < vertices; ++v) {
            const auto share = uint8_t(std::lround(positions[3 * v] * 255 / 4));
            joints.insert(joints.end(), {0, 1, 0, 0});
            weights.insert(weights.end(), {uint8_t(255 - share), share, 0, 0});
        }
        for (const auto& [name, values] : {std::pair("JOINTS_0", joints), {"WEIGHTS_0", weights}}) {
            Bytes bytes(meshopt_encodeVertexBufferBound(vertices, 4));
            bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values.data(), vertices, 4));
            b.attributes()[name] = b.add_accessor({{"bufferView", compressed(bytes, vertices, 4, "ATTRIBUTES", "NONE")},
                                                   {"componentType", 5121},
                                                   {"normalized", name[0] == 'W'},
                                                   {"type", "VEC4"},
                                                   {"count", vertices}});
        }
        add_skin(b);
    }
    return b;
}

} // namespace prelight::test
