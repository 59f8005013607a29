#include "worlds.hpp"
#include <cstring>
#include <gtest/gtest.h>
#include <prelight/error.hpp>

namespace prelight {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ReferencePicture shown(const TestWorld& test, const PlacedCamera& camera, uint32_t width = 32, uint32_t height = 32,
                       const ReferenceForm& form = {}) {
    return render_reference(test.world, camera, width, height, 0, form);
}

TEST(Geometry, PositionDepthAndNormalOfEachPixel) {
    TestWorld test;
    test.add(square(100));
    const uint32_t width = 40, height = 20;
    const auto picture = shown(test, front_camera(5), width, height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const size_t i = size_t(y) * width + x;
            EXPECT_NEAR(glm::distance(picture.position[i], on_plane(5, 0.8, x, y, width, height)), 0, 1e-12);
            EXPECT_NEAR(picture.depth[i], 5, 1e-12);
            EXPECT_NEAR(glm::distance(picture.normal[i], {0, 0, 1}), 0, 1e-12);
            EXPECT_NEAR(glm::distance(picture.geometric_normal[i], {0, 0, 1}), 0, 1e-12);
        }
}

TEST(Geometry, OrthographicCamera) {
    TestWorld test;
    test.add(square(100));
    PlacedCamera camera = look_at({.kind = ProjectionKind::orthographic, .ymag = 3, .znear = 0}, {1, 2, 5}, {1, 2, 0});
    const auto picture = shown(test, camera, 8, 4);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 8; ++x) {
            const size_t i = size_t(y) * 8 + x;
            const glm::dvec3 want(1 + ((x + 0.5) / 4 - 1) * 6, 2 + (1 - (y + 0.5) / 2) * 3, 0);
            EXPECT_NEAR(glm::distance(picture.position[i], want), 0, 1e-12);
            EXPECT_NEAR(picture.depth[i], 5, 1e-12);
        }
    // The view vector is the axis for every pixel: a directional light along it gives a flat
    // picture with its highlight everywhere.
    test.add_light({.kind = LightKind::directional}, {0, 0, 0}, {0, 0, -1});
    const auto lit = shown(test, camera, 8, 4);
    EXPECT_GT(lit.linear.at(0, 0).r, 0.01f);
    for (const glm::vec3& pixel : lit.linear.pixels)
        EXPECT_NEAR(pixel.r, lit.linear.at(0, 0).r, 1e-6f);
}

TEST(Geometry, NearAndFarPlanesClipByDepth) {
    TestWorld test;
    test.add(square(100));
    const auto depth_with = [&](double near, double far) {
        PlacedCamera camera = front_camera(5, 2.0); // wide: corners are far, their depth is not
        camera.camera.znear = near;
        camera.camera.zfar = far;
        return shown(test, camera, 9, 9).depth;
    };
    for (const double depth : depth_with(4.99, 5.01))
        EXPECT_NEAR(depth, 5, 1e-9);
    for (const double depth : depth_with(5.01, infinity))
        EXPECT_EQ(depth, infinity);
    for (const double depth : depth_with(0.1, 4.99))
        EXPECT_EQ(depth, infinity);
}

TEST(Geometry, BackFacesAreThereOnlyWhenDoubleSided) {
    for (const bool mirrored : {false, true}) {
        TestWorld test;
        test.add_material({.metallic = 0});
        test.add(square(10), glm::scale(glm::dmat4(1), {mirrored ? -1 : 1, 1, 1}));
        test.add_light({.kind = LightKind::directional}, {0, 0, 0}, {0, 0, 1});
        const PlacedCamera front = front_camera(4);
        const PlacedCamera back = look_at(Camera{}, {0, 0, -4}, {0, 0, 0});
        EXPECT_EQ(shown(test, front).instance[0], 0u) << mirrored;
        EXPECT_EQ(shown(test, back).instance[0], 0xffffffffu) << mirrored;
        test.scene.materials[0].double_sided = true;
        EXPECT_NEAR(shown(test, front).normal[0].z, 1, 1e-12) << mirrored;
        const auto behind = shown(test, back);
        EXPECT_EQ(behind.instance[0], 0u);
        EXPECT_NEAR(behind.normal[0].z, -1, 1e-12) << mirrored;
        EXPECT_NEAR(behind.geometric_normal[0].z, -1, 1e-12);
        EXPECT_GT(behind.linear.pixels[0].r, 0.1f) << "the flipped normal faces the light";
        EXPECT_EQ(shown(test, front).linear.pixels[0].r, 0.0f) << "the light is behind";
    }
}

TEST(Geometry, NormalsOfNonUniformScale) {
    TestWorld test;
    test.add(sphere(), glm::scale(glm::dmat4(1), {3, 1, 0.5}));
    const auto picture = shown(test, front_camera(6), 65, 65);
    uint32_t hits = 0;
    for (size_t i = 0; i < picture.depth.size(); ++i) {
        if (picture.depth[i] == infinity)
            continue;
        ++hits;
        const glm::dvec3 p = picture.position[i];
        // Gradient of (x/3)² + y² + (z/0.5)².
        const glm::dvec3 want = glm::normalize(glm::dvec3(p.x / 9, p.y, p.z / 0.25));
        EXPECT_GT(glm::dot(picture.normal[i], want), 0.998);
    }
    EXPECT_GT(hits, 500u);
}

/// A lumpy normal map, so that handedness shows.
uint32_t add_bumps(TestWorld& test) {
    std::vector<uint8_t> rgba;
    for (uint32_t i = 0; i < 16; ++i) {
        const uint8_t texel[4] = {uint8_t(128 + (i * 37) % 90), uint8_t(128 - (i * 53) % 90), uint8_t(220), 255};
        rgba.insert(rgba.end(), texel, texel + 4);
    }
    return test.add_image(4, 4, rgba);
}

TEST(Geometry, MirroredInstanceIsTheMirroredPicture) {
    const auto world_with = [](double mirror) {
        auto test = std::make_unique<TestWorld>();
        Material material{.base_colour = {0.9f, 0.5f, 0.3f, 1}, .metallic = 0.2f, .roughness = 0.4f};
        material.normal_texture.image = add_bumps(*test);
        test->add_material(material);
        const glm::dmat4 place = glm::rotate(glm::scale(glm::dmat4(1), {mirror, 1, 1}), 0.7, glm::dvec3(1, 2, 3));
        test->add(sphere(), place);
        test->add_light({.intensity = 5}, {mirror * 1.5, 1, 2});
        return test;
    };
    const auto plain = world_with(1), mirrored = world_with(-1);
    const uint32_t size = 64;
    const auto a = shown(*plain, front_camera(3), size, size);
    const auto b = shown(*mirrored, front_camera(3), size, size);
    double largest = 0, difference = 0;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const float left = a.linear.at(x, y).r, right = b.linear.at(size - 1 - x, y).r;
            largest = std::max(largest, double(left));
            difference = std::max(difference, double(std::abs(left - right)));
        }
    EXPECT_GT(largest, 0.1);
    EXPECT_LT(difference, 1e-5 * largest);
}

TEST(Geometry, NormalMapBendsTheNormal) {
    TestWorld test;
    Material material;
    // Texel (1, 0, 0.5)·255 rounded: tx = +1, ty = −1, tz = 128/127.5 − 1.
    material.normal_texture.image = test.add_image(1, 1, {255, 0, 128, 255});
    material.normal_scale = 0.5f;
    test.add_material(material);
    test.add(square(10));
    const double tz = 2 * 128 / 255.0 - 1;
    const glm::dvec3 want = glm::normalize(glm::dvec3(0.5, -0.5, tz));
    EXPECT_NEAR(glm::distance(shown(test, front_camera(3)).normal[0], want), 0, 1e-9);
    // w = −1 turns the bitangent round; a rotation by 90° about z turns everything along.
    for (glm::vec4& tangent : test.scene.meshes[0].primitives[0].tangents)
        tangent.w = -1;
    test.world.instances[0].transform = glm::rotate(glm::dmat4(1), 1.5707963267948966, glm::dvec3(0, 0, 1));
    const glm::dvec3 turned = glm::normalize(glm::dvec3(-0.5, 0.5, tz));
    EXPECT_NEAR(glm::distance(shown(test, front_camera(3)).normal[0], turned), 0, 1e-9);
}

TEST(Geometry, AlphaMaskOpensHoles) {
    TestWorld test;
    test.add_material();
    test.add(square(10), glm::translate(glm::dmat4(1), {0, 0, -1}));
    Material masked{.alpha_mode = AlphaMode::mask, .alpha_cutoff = 0.5f};
    // Left column opaque, right column clear; nearest, so that the border is exact.
    masked.base_colour_texture.image = test.add_image(2, 1, {255, 255, 255, 255, 255, 255, 255, 0});
    masked.base_colour_texture.sampler.mag = Filter::nearest;
    test.add_material(masked);
    test.add(square(1));
    const ReferenceForm form{.bilinear_level0 = false};
    const PlacedCamera camera = front_camera(2);
    const auto at = [&](uint32_t x, uint32_t y) { return shown(test, camera, 32, 32, form).instance[y * 32 + x]; };
    EXPECT_EQ(at(10, 16), 1u);
    EXPECT_EQ(at(22, 16), 0u);
    // Factor and vertex colour count too: 0.8 · 1 · 0.7 = 0.56 ≥ 0.5, 0.8 · 0.6 = 0.48 is not.
    test.scene.materials[1].base_colour.a = 0.8f;
    test.scene.meshes[1].primitives[0].colours.assign(4, glm::vec4(1, 1, 1, 0.7f));
    EXPECT_EQ(at(10, 16), 1u);
    test.scene.meshes[1].primitives[0].colours.assign(4, glm::vec4(1, 1, 1, 0.6f));
    EXPECT_EQ(at(10, 16), 0u);
    // Blend is drawn opaque, whatever its alpha.
    test.scene.materials[1].alpha_mode = AlphaMode::blend;
    EXPECT_EQ(at(22, 16), 1u);
}

TEST(Geometry, TenKilometresFromTheOriginNothingIsLost) {
    const auto world_at = [](glm::dvec3 where) {
        auto test = std::make_unique<TestWorld>();
        Material material{.metallic = 0.5f, .roughness = 0.3f};
        material.normal_texture.image = add_bumps(*test);
        test->add_material(material);
        test->add(sphere(), glm::translate(glm::dmat4(1), where));
        test->add(square(20), glm::translate(glm::dmat4(1), where + glm::dvec3(0, 0, -1.03)));
        for (int i = 0; i < 20; ++i)
            test->add_light({.intensity = 2, .range = 4},
                            where + glm::dvec3(std::sin(i * 2.0) * 2, std::cos(i * 3.0) * 2, 1 + std::sin(i * 5.0)));
        return test;
    };
    const glm::dvec3 far(10000.123, -7000.77, 3000.5);
    const auto near_world = world_at({0, 0, 0}), far_world = world_at(far);
    const auto a = shown(*near_world, front_camera(4.1), 64, 64);
    PlacedCamera camera = front_camera(4.1);
    camera.position += far;
    const auto b = shown(*far_world, camera, 64, 64);
    EXPECT_EQ(a.instance, b.instance);
    for (size_t i = 0; i < a.depth.size(); ++i) {
        EXPECT_NEAR(a.depth[i], b.depth[i], 1e-8);
        EXPECT_NEAR(a.linear.pixels[i].r, b.linear.pixels[i].r, 1e-5f * a.linear.pixels[i].r);
    }
}

TEST(Geometry, FirstOfInstancesAndPrimitivesIsNamed) {
    TestWorld test;
    test.add(square(1));
    test.scene.meshes[0].primitives.push_back(square(1));
    for (glm::vec3& position : test.scene.meshes[0].primitives[1].positions)
        position.z = 0.25f;
    test.place(0, glm::translate(glm::dmat4(1), {0, 0, 1}));
    const auto picture = shown(test, front_camera(4));
    EXPECT_EQ(picture.instance[16 * 32 + 16], 1u);
    EXPECT_EQ(picture.primitive[16 * 32 + 16], 1u);
    EXPECT_EQ(picture.instance[0], 0xffffffffu);
    EXPECT_EQ(picture.linear.pixels[0], glm::vec3(0));
}

TEST(Geometry, TwoRunsGiveTheSameBytes) {
    TestWorld test;
    test.add(sphere(128));
    test.add(square(20), glm::translate(glm::dmat4(1), {0, 0, -1}));
    for (int i = 0; i < 300; ++i)
        test.add_light({.intensity = 1, .range = 2}, {std::sin(i * 1.0) * 3, std::cos(i * 1.7) * 3, std::sin(i * 0.3)});
    const auto a = shown(test, front_camera(4), 160, 90), b = shown(test, front_camera(4), 160, 90);
    EXPECT_EQ(std::memcmp(a.linear.pixels.data(), b.linear.pixels.data(), a.linear.pixels.size() * sizeof(glm::vec3)),
              0);
}

TEST(Geometry, RefusesWhatItCannotRender) {
    TestWorld test;
    test.add(square(1));
    EXPECT_THROW(shown(test, front_camera(2), 0, 5), Error);
    test.scene.meshes[0].primitives[0].indices[3] = 4;
    EXPECT_THROW(shown(test, front_camera(2)), Error);
    test.scene.meshes[0].primitives[0].indices[3] = 0;
    test.scene.materials[0].emissive_texture.image = 7;
    EXPECT_THROW(shown(test, front_camera(2)), Error);
}

} // namespace
} // namespace prelight
