#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace prelight;
using namespace prelight::test;
using testing::HasSubstr;

namespace {

/// The grid of 4 × 4 unit quads in the plane z = 0, whatever order its vertices have.
void expect_grid(const Scene& scene, float tolerance) {
    const Primitive& p = scene.meshes.at(0).primitives.at(0);
    ASSERT_EQ(p.indices.size(), 4u * 4 * 2 * 3);
    double area = 0;
    for (size_t i = 0; i < p.indices.size(); i += 3) {
        const glm::vec3 a = p.positions.at(p.indices[i]), b = p.positions.at(p.indices[i + 1]),
                        c = p.positions.at(p.indices[i + 2]);
        area += 0.5 * double((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    }
    EXPECT_NEAR(area, 16, 0.01);
    for (const glm::vec3& n : p.normals)
        ASSERT_NEAR(n.z, 1, 1e-3);
    for (const glm::vec3& v : p.positions) {
        ASSERT_NEAR(v.x, std::round(v.x), tolerance);
        ASSERT_NEAR(v.y, std::round(v.y), tolerance);
        ASSERT_EQ(v.z, 0);
    }
    const World world = resolve(scene);
    EXPECT_NEAR(world.bounds_max.x, 4, tolerance);
    EXPECT_NEAR(world.bounds_max.y, 4, tolerance);
}

TEST(GltfCompression, DracoEdgebreaker) { expect_grid(draco_grid(true).load(), 1e-6f); }
TEST(GltfCompression, DracoSequential) { expect_grid(draco_grid(false).load(), 1e-6f); }
TEST(GltfCompression, MeshoptWithFallbackBuffer) { expect_grid(meshopt_grid().load(), 0); }

/// Each vertex is lifted by 2 · x.
void expect_bent_grid(const Scene& scene, double tolerance) {
    ASSERT_EQ(scene.meshes.at(0).primitives.at(0).joint_sets.size(), 1u);
    const World world = resolve(scene);
    const Instance& instance = world.instances.at(0);
    ASSERT_TRUE(instance.deformed);
    for (const glm::vec3& p : world.mesh_of(instance).primitives.at(0).positions) {
        const glm::dvec4 v = instance.transform * glm::dvec4(p, 1);
        ASSERT_NEAR(v.z, 2 * v.x, tolerance);
    }
    EXPECT_NEAR(world.bounds_max.z, 8, tolerance);
}

TEST(GltfCompression, JointsInDracoAndMeshopt) {
    expect_bent_grid(draco_grid(true, nullptr, true).load(), 1e-5);
    expect_bent_grid(draco_grid(false, nullptr, true).load(), 1e-5);
    expect_bent_grid(meshopt_grid(true).load(), 0.02); // weights are 1/255 coarse
}

/// Every byte of the compressed data changed in turn, and the data cut at every length: an error or
/// a mesh, never anything else. Under the address sanitizer this sees reads out of bounds too.
void damage_each_byte(GltfBuilder builder, size_t view) {
    Json& json = builder.json["bufferViews"][view];
    const Json& range = json.contains("extensions") ? json["extensions"]["EXT_meshopt_compression"] : json;
    const size_t begin = range["byteOffset"], length = range["byteLength"];
    size_t errors = 0;
    for (size_t i = 0; i < length; ++i)
        for (const uint8_t flip : {0xff, 0x01, 0x80}) {
            GltfBuilder damaged = builder;
            damaged.binary[begin + i] ^= flip;
            errors += !error_of(damaged).empty();
        }
    EXPECT_GT(errors, 0u);
    for (size_t cut = 0; cut < length; ++cut) {
        GltfBuilder damaged = builder;
        Json& view_json = damaged.json["bufferViews"][view];
        (view_json.contains("extensions") ? view_json["extensions"]["EXT_meshopt_compression"]
                                          : view_json)["byteLength"] = cut;
        EXPECT_NE(error_of(damaged), "") << cut;
    }
}

TEST(GltfCompression, DamagedDracoEdgebreaker) { damage_each_byte(draco_grid(true), 0); }
TEST(GltfCompression, DamagedDracoSequential) { damage_each_byte(draco_grid(false), 0); }
TEST(GltfCompression, DamagedMeshopt) {
    for (size_t view = 0; view < 3; ++view)
        damage_each_byte(meshopt_grid(), view);
}

TEST(GltfCompression, DracoIndexBeyondItsVertices) {
    Bytes draco;
    GltfBuilder b = draco_grid(false, &draco);
    // Header 11 bytes, faces, points, method, then a byte for each index while there are < 256.
    ASSERT_EQ(b.binary[11], 32);
    ASSERT_EQ(b.binary[12], 25);
    ASSERT_EQ(b.binary[13], 1);
    b.binary[14] = 200;
    EXPECT_THAT(error_of(b), HasSubstr("test.glb: mesh 0 primitive 0 KHR_draco_mesh_compression: "));
}

TEST(GltfCompression, DracoCountsThatLieAreRefusedBeforeTheyAllocate) {
    for (const bool edgebreaker : {true, false}) {
        GltfBuilder b = draco_grid(edgebreaker);
        // A varint of 2^31 for the vertices (sequential) or their encoded number (edgebreaker).
        const std::ptrdiff_t at = 12;
        b.binary.erase(b.binary.begin() + at);
        const Bytes huge = {0x80, 0x80, 0x80, 0x80, 0x08};
        b.binary.insert(b.binary.begin() + at, huge.begin(), huge.end());
        b.json["bufferViews"][0]["byteLength"] = b.binary.size();
        b.json["buffers"][0]["byteLength"] = b.binary.size();
        const size_t taken = memory_growth([&] { EXPECT_THAT(error_of(b), HasSubstr("more memory")) << edgebreaker; });
        if (!sanitized) {
            EXPECT_LT(taken, size_t(8) << 20) << edgebreaker;
        }
    }
}

TEST(GltfCompression, DracoAttributeThatIsNotThere) {
    GltfBuilder b = draco_grid(true);
    b.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 77;
    EXPECT_THAT(error_of(b), HasSubstr("no attribute 77"));
}

TEST(GltfCompression, MeshoptValuesOutOfRange) {
    const auto error_with = [](const char* key, const Json& value) {
        GltfBuilder b = meshopt_grid();
        b.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        return error_of(b);
    };
    EXPECT_THAT(error_with("byteStride", 13), HasSubstr("byteStride 13"));
    EXPECT_THAT(error_with("byteStride", 0), HasSubstr("byteStride 0"));
    EXPECT_THAT(error_with("mode", "MAGIC"), HasSubstr("mode \"MAGIC\""));
    EXPECT_THAT(error_with("filter", "MAGIC"), HasSubstr("filter \"MAGIC\""));
    EXPECT_THAT(error_with("filter", "QUATERNION"), HasSubstr("does not fit"));
    EXPECT_THAT(error_with("count", uint64_t(1) << 62), HasSubstr("more memory"));
    EXPECT_THAT(error_with("count", 4000), HasSubstr("does not decode"));
    EXPECT_THAT(error_with("byteLength", 1 << 20), HasSubstr("lie beyond buffer 0"));
}

} // namespace
