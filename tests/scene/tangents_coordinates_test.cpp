// Tangent frames follow the coordinates that the normal map really reads. The oracle is the same transform baked into
// the coordinates themselves.
#include "gltf_builder.hpp"
#include <cmath>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/vary.hpp>

namespace prelight {
namespace {

using namespace test;

struct Transform {
    const char* name;
    float offset[2], rotation, scale[2];
};
constexpr Transform transforms[]{
    {"none", {0, 0}, 0, {1, 1}},          {"offset", {0.3f, -2}, 0, {1, 1}},    {"rot30", {0, 0}, 0.5236f, {1, 1}},
    {"rot90", {0, 1}, 1.5708f, {1, 1}},   {"rot180", {0, 0}, 3.14159f, {1, 1}}, {"back", {0, 0}, -0.7f, {1, 1}},
    {"mirror u", {1, 0}, 0, {-1, 1}},     {"mirror v", {0, 1}, 0, {1, -1}},     {"wide", {0, 0}, 0, {4, 0.5f}},
    {"skew", {0.2f, 0.4f}, 0.9f, {3, 1}}, {"all", {-1, 3}, 2.2f, {-2, 0.7f}},   {"tiny", {0, 0}, 1, {0.01f, 0.01f}}};

/// As the reader has it: counter-clockwise in a picture whose v points down.
std::vector<float> baked(const std::vector<float>& uvs, const Transform& t) {
    const float c = std::cos(t.rotation), s = std::sin(t.rotation);
    std::vector<float> out;
    for (size_t i = 0; i < uvs.size(); i += 2) {
        out.push_back(c * t.scale[0] * uvs[i] + s * t.scale[1] * uvs[i + 1] + t.offset[0]);
        out.push_back(-s * t.scale[0] * uvs[i] + c * t.scale[1] * uvs[i + 1] + t.offset[1]);
    }
    return out;
}

/// A bumpy patch of 5 × 5 vertices with a normal map on coordinates that are not square to it.
struct Patch {
    GltfBuilder builder;
    std::vector<float> uvs;
    Patch() {
        std::vector<float> positions, normals;
        std::vector<uint16_t> indices;
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) {
                const float u = static_cast<float>(x) / 4, v = static_cast<float>(y) / 4;
                positions.insert(positions.end(), {u, -v, 0.2f * std::sin(3 * u) * std::cos(2 * v)});
                const glm::vec3 n = glm::normalize(
                    glm::vec3(-0.6f * std::cos(3 * u) * std::cos(2 * v), -0.4f * std::sin(3 * u) * std::sin(2 * v), 1));
                normals.insert(normals.end(), {n.x, n.y, n.z});
                uvs.insert(uvs.end(), {u + 0.3f * v, v});
                if (x < 4 && y < 4) {
                    const uint16_t a = static_cast<uint16_t>(5 * y + x), b = static_cast<uint16_t>(a + 5);
                    for (const int i : {int(a), int(b), b + 1, int(a), b + 1, a + 1})
                        indices.push_back(static_cast<uint16_t>(i));
                }
            }
        builder.primitive()["attributes"] = {{"POSITION", builder.add_floats(positions, "VEC3")},
                                             {"NORMAL", builder.add_floats(normals, "VEC3")}};
        builder.primitive()["indices"] = builder.add_values(indices, 5123, "SCALAR");
        builder.primitive()["material"] = 0;
        builder.add_image(png(1, 1, solid(1, 1, {128, 128, 255, 255})));
        builder.json["textures"] = Json::array({{{"source", 0}}});
        builder.json["materials"] = Json::array({{{"normalTexture", {{"index", 0}}}}});
    }
    Json& normal_texture() { return builder.json["materials"][0]["normalTexture"]; }
    void set_uvs(const char* set, const std::vector<float>& values) {
        builder.attributes()[set] = builder.add_floats(values, "VEC2");
    }
    void set_transform(const Transform& t) {
        normal_texture()["extensions"]["KHR_texture_transform"] = {
            {"offset", {t.offset[0], t.offset[1]}}, {"rotation", t.rotation}, {"scale", {t.scale[0], t.scale[1]}}};
    }
    Primitive load() const { return builder.load().meshes.at(0).primitives.at(0); }
};

void expect_same_tangents(const Primitive& a, const Primitive& b) {
    ASSERT_EQ(a.indices.size(), b.indices.size());
    for (size_t i = 0; i < a.indices.size(); ++i) {
        const glm::vec4 t = a.tangents.at(a.indices[i]), u = b.tangents.at(b.indices[i]);
        EXPECT_EQ(t.w, u.w) << i;
        EXPECT_LT(glm::distance(glm::vec3(t), glm::vec3(u)), 2e-3f) << i;
    }
}

TEST(TangentCoordinates, FollowATextureTransform) {
    for (const Transform& t : transforms) {
        SCOPED_TRACE(t.name);
        Patch right, given;
        right.set_uvs("TEXCOORD_0", baked(right.uvs, t));
        given.set_uvs("TEXCOORD_0", given.uvs);
        given.set_transform(t);
        expect_same_tangents(given.load(), right.load());
    }
}

TEST(TangentCoordinates, FollowASetThatTheTransformNames) {
    for (const Transform& t : transforms) {
        SCOPED_TRACE(t.name);
        Patch right, given;
        right.set_uvs("TEXCOORD_0", baked(right.uvs, t));
        given.set_uvs("TEXCOORD_0", given.uvs);
        given.set_uvs("TEXCOORD_1", baked(given.uvs, t));
        given.normal_texture()["extensions"]["KHR_texture_transform"] = {{"texCoord", 1}};
        expect_same_tangents(given.load(), right.load());
        given.normal_texture() = {{"index", 0}, {"texCoord", 1}};
        expect_same_tangents(given.load(), right.load());
    }
}

TEST(TangentCoordinates, OfOneMeshAreEachMaterialsOwn) {
    Patch both;
    both.set_uvs("TEXCOORD_0", both.uvs);
    Json second = both.builder.primitive();
    second["material"] = 1;
    both.builder.json["meshes"][0]["primitives"].push_back(second);
    both.set_transform(transforms[3]);
    both.builder.json["materials"].push_back(both.builder.json["materials"][0]);
    both.set_transform(transforms[6]);
    const Scene scene = both.builder.load();
    for (const int m : {0, 1}) {
        Patch right;
        right.set_uvs("TEXCOORD_0", baked(right.uvs, transforms[m == 0 ? 6 : 3]));
        expect_same_tangents(scene.meshes.at(0).primitives.at(size_t(m)), right.load());
    }
}

TEST(TangentCoordinates, GivenTangentsStayAsTheyAre) {
    Patch given;
    given.set_uvs("TEXCOORD_0", given.uvs);
    std::vector<float> tangents;
    for (int v = 0; v < 25; ++v)
        tangents.insert(tangents.end(), {0, 1, 0, -1});
    given.builder.attributes()["TANGENT"] = given.builder.add_floats(tangents, "VEC4");
    given.set_transform(transforms[3]);
    for (const glm::vec4& t : given.load().tangents)
        EXPECT_EQ(t, glm::vec4(0, 1, 0, -1));
}

TEST(TangentCoordinates, FollowAMaterialThatIsExchanged) {
    Patch plain;
    plain.set_uvs("TEXCOORD_0", plain.uvs);
    plain.builder.json["materials"].push_back(plain.builder.json["materials"][0]);
    plain.builder.json["materials"][1]["normalTexture"]["extensions"]["KHR_texture_transform"] = {
        {"rotation", 1.5708f}};
    Scene scene = plain.builder.load();
    cycle_materials(scene);
    Patch right;
    right.set_uvs("TEXCOORD_0", baked(right.uvs, {"", {0, 0}, 1.5708f, {1, 1}}));
    expect_same_tangents(scene.meshes.at(0).primitives.at(0), right.load());
}

} // namespace
} // namespace prelight
