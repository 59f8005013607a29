#include <chrono>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <scene/procedural/shapes.hpp>
#include <scene/tangents.hpp>

namespace prelight {
namespace {

/// A 2 × 1 strip in the xy plane that faces +z; u runs to the right up to the middle, then back; v
/// runs down as glTF has it.
Primitive mirrored_strip() {
    Primitive strip;
    strip.positions = {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    strip.normals.assign(6, {0, 0, 1});
    strip.texcoords[0] = {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 1}, {0, 1}};
    strip.colours.assign(6, {0.5f, 0.25f, 1, 1});
    strip.indices = {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2};
    return strip;
}

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Tangents, BitangentPointsUpInThePicture) {
    Primitive strip = mirrored_strip();
    generate_tangents(strip, 0);
    for (size_t i = 0; i < strip.indices.size(); ++i) {
        const glm::vec4 tangent = strip.tangents[strip.indices[i]];
        const bool left = i < 6;
        EXPECT_EQ(glm::vec3(tangent), glm::vec3(left ? 1 : -1, 0, 0)) << i;
        // The picture's up is +y on both halves: w · (N × T) = +y.
        EXPECT_EQ(tangent.w * glm::cross(glm::vec3(0, 0, 1), glm::vec3(tangent)), glm::vec3(0, 1, 0));
    }
}

TEST(Tangents, SplitsOnlyTheMirrorLine) {
    Primitive strip = mirrored_strip();
    generate_tangents(strip, 0);
    EXPECT_EQ(strip.positions.size(), 8u); // the two vertices of the middle line twice
    EXPECT_EQ(strip.normals.size(), 8u);
    EXPECT_EQ(strip.tangents.size(), 8u);
    EXPECT_EQ(strip.texcoords[0].size(), 8u);
    EXPECT_TRUE(strip.texcoords[1].empty());
    EXPECT_EQ(strip.colours.size(), 8u);
    const Primitive once = strip;
    generate_tangents(strip, 0);
    EXPECT_EQ(strip.indices, once.indices); // a second run changes nothing
    EXPECT_EQ(strip.tangents, once.tangents);
}

TEST(Tangents, SecondSetIsUsedWhenAsked) {
    Primitive strip = mirrored_strip();
    strip.texcoords[1] = strip.texcoords[0];
    for (auto& uv : strip.texcoords[1])
        uv = {uv.y, uv.x};
    generate_tangents(strip, 1);
    for (const uint32_t index : strip.indices)
        EXPECT_EQ(glm::vec3(strip.tangents[index]), glm::vec3(0, -1, 0));
}

TEST(Tangents, StayUnitWhateverTheInput) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {0.0f, 1e-38f, 3e38f, inf, nan}) {
        Primitive strip = mirrored_strip();
        for (auto& uv : strip.texcoords[0])
            uv *= bad;
        strip.normals[2] = glm::vec3(bad);
        strip.positions[5] *= bad;
        generate_tangents(strip, 0);
        for (const uint32_t index : strip.indices) {
            EXPECT_NEAR(glm::length(glm::dvec3(strip.tangents[index])), 1, 1e-5) << bad;
            EXPECT_EQ(std::abs(strip.tangents[index].w), 1);
        }
    }
}

// Shapes where a careless search would take the square of the number of triangles.
TEST(Tangents, HostileMeshesTakeNoSquareTime) {
    constexpr uint32_t count = 100000;
    Primitive hub;  // every triangle shares vertex 0 and has its own direction of u
    Primitive edge; // every triangle shares the edge 0 1
    hub.positions = edge.positions = {{0, 0, 0}, {0, 0, 1}};
    hub.texcoords[0] = edge.texcoords[0] = {{0, 0}, {1, 0}};
    for (uint32_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        for (Primitive* mesh : {&hub, &edge}) {
            mesh->positions.emplace_back(1, x, 0);
            mesh->positions.emplace_back(x, 1, 2);
            mesh->texcoords[0].emplace_back(x, 1);
            mesh->texcoords[0].emplace_back(1, -x);
        }
        hub.indices.insert(hub.indices.end(), {0, 2 * i + 2, 2 * i + 3});
        edge.indices.insert(edge.indices.end(), {0, 1, 2 * i + 2});
    }
    Primitive fan = make_sphere(1, count, 2); // all directions of u around its poles
    for (glm::vec2& uv : fan.texcoords[0])
        uv = {uv.y - 0.5f, uv.x * 0.001f};
    for (size_t i = 0; i <= count; ++i) { // one vertex for the pole, so that it is one group
        fan.positions[i] = {0, 1, 0};
        fan.texcoords[0][i] = {-0.5f, 0};
    }
    for (Primitive* mesh : {&hub, &edge, &fan}) {
        mesh->normals.resize(mesh->positions.size(), {0, 1, 0});
        EXPECT_LT(seconds([&] { generate_tangents(*mesh, 0); }), 5) << "triangles: " << count;
    }
}

TEST(FlatNormals, EveryCornerGetsItsFace) {
    Primitive box = make_box({0, 0, 0}, {1, 2, 3});
    const Primitive before = box;
    box.normals.clear();
    box.tangents.assign(box.positions.size(), {1, 0, 0, 1});
    make_flat_normals(box);
    EXPECT_TRUE(box.tangents.empty());
    ASSERT_EQ(box.positions.size(), 36u);
    ASSERT_EQ(box.normals.size(), 36u);
    ASSERT_EQ(box.texcoords[0].size(), 36u);
    EXPECT_TRUE(box.texcoords[1].empty());
    for (uint32_t i = 0; i < 36; ++i) {
        EXPECT_EQ(box.indices[i], i);
        EXPECT_EQ(box.normals[i], before.normals[before.indices[i]]);
        EXPECT_EQ(box.positions[i], before.positions[before.indices[i]]);
        EXPECT_EQ(box.texcoords[0][i], before.texcoords[0][before.indices[i]]);
    }
}

TEST(FlatNormals, TriangleWithoutAreaGetsAUnitNormal) {
    Primitive line;
    line.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    line.indices = {0, 1, 2};
    make_flat_normals(line);
    ASSERT_EQ(line.normals.size(), 3u);
    EXPECT_EQ(glm::length(line.normals[0]), 1);
}

TEST(FlatNormals, SmallTriangleFarAwayKeepsItsDirection) {
    Primitive tiny;
    tiny.positions = {{10000, 0, 0}, {10000.01f, 0, 0}, {10000, 0, -0.01f}};
    tiny.indices = {0, 1, 2};
    make_flat_normals(tiny);
    EXPECT_EQ(tiny.normals[0], glm::vec3(0, 1, 0));
}

} // namespace
} // namespace prelight
