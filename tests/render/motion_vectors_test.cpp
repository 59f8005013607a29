// Motion vectors of the G-buffer against the reference, which follows each hit point back to
// where it was.
#include "filled_gbuffer.hpp"
#include "garden.hpp"
#include <glm/gtc/packing.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

/// Pixels right and down of the picture's middle, in double precision; the previous camera has the same
/// lens.
glm::dvec2 on_picture(const Shot& shot, const CameraPose& pose, glm::dvec3 point) {
    const Camera& lens = shot.camera.camera;
    const glm::dvec3 seen = glm::transpose(pose.axes) * (point - pose.position);
    const bool perspective = lens.kind == ProjectionKind::perspective;
    const double half = perspective ? std::tan(lens.yfov / 2) * -seen.z : lens.ymag;
    return glm::dvec2(seen.x, -seen.y) / half * (0.5 * shot.height);
}

struct Vectors {
    std::vector<glm::dvec2> expected; ///< of pixels that count
    std::vector<glm::dvec2> stored;
    std::vector<double> change; ///< of the expected vector to the pixel's neighbours, largest component
};

/// The G-buffer's vectors, decoded here: half floats, or bytes by the documentation's formula.
Vectors vectors_of(const Shot& shot, const passes::GBufferFormat& format) {
    const FilledGBuffer filled(shot, format);
    const auto texels = filled.graph.read_back(filled.buffer.motion);
    const bool bytes = format.layout == passes::GBufferLayout::killzone2;
    const ReferencePicture reference = render_reference(*shot.world, shot.camera, shot.width, shot.height, 0, {});
    const std::vector<uint8_t> out = reference.left_out();
    const CameraPose now{shot.camera.position, shot.camera.axes};
    const CameraPose before = shot.camera.previous.value_or(now);
    const auto expected = [&](size_t i) {
        return on_picture(shot, now, reference.position[i]) - on_picture(shot, before, reference.previous_position[i]);
    };
    Vectors vectors;
    for (size_t i = shot.width; i + shot.width < out.size(); ++i) {
        if (out[i] || std::isinf(reference.depth[i]))
            continue;
        vectors.expected.push_back(expected(i));
        double& change = vectors.change.emplace_back(0);
        for (const size_t beside : {i - 1, i + 1, i - shot.width, i + shot.width})
            if (!std::isinf(reference.depth[beside]))
                for (int c = 0; c < 2; ++c)
                    change = std::max(change, std::abs(expected(beside)[c] - expected(i)[c]));
        glm::dvec2& stored = vectors.stored.emplace_back();
        for (int c = 0; c < 2; ++c) {
            if (bytes) {
                const double s = (std::to_integer<int>(texels[4 * i + size_t(c)]) - 128) / 127.0;
                stored[c] = std::copysign(s * s * 64, s);
            } else {
                stored[c] = glm::unpackHalf1x16(reinterpret_cast<const uint16_t*>(texels.data())[2 * i + size_t(c)]);
            }
        }
    }
    return vectors;
}

/// Each vector within its format's precision. `least`: pixels that the longest one has at least, so
/// that the scene shows what it is for.
void expect_motion(const Shot& shot, double least) {
    for (const passes::GBufferFormat& format : {passes::GBufferFormat{}, killzone2}) {
        const bool bytes = format.layout == passes::GBufferLayout::killzone2;
        const Vectors vectors = vectors_of(shot, format);
        double longest = 0, worst = 0, mean = 0;
        size_t beyond = 0, wrong = 0;
        for (size_t i = 0; i < vectors.expected.size(); ++i) {
            const glm::dvec2 want = vectors.expected[i];
            longest = std::max(longest, glm::length(want));
            for (int c = 0; c < 2; ++c) {
                const double size = std::abs(want[c]), error = std::abs(vectors.stored[i][c] - want[c]);
                // Half floats: 11 bits, cut off or rounded. Bytes: half a step of the root, (2·√x + ½ step) · ½ step.
                const double half_step = 0.5 / 127;
                const double precision = bytes ? 64 * half_step * (2 * std::sqrt(size / 64) + half_step) : size / 1024;
                // Vertices are snapped to 1/256 pixel: the point that is seen lies a little aside, and beside
                // an edge within an object it is the neighbour's.
                beyond += error > precision + 0.004 + vectors.change[i] / 64;
                wrong += error > precision + 0.004 + vectors.change[i];
                worst = std::max(worst, error);
                mean += error;
            }
        }
        EXPECT_EQ(wrong, 0u) << "of " << vectors.expected.size();
        EXPECT_LE(static_cast<double>(beyond), 1e-4 * static_cast<double>(vectors.expected.size()));
        EXPECT_GE(longest, least);
        EXPECT_GE(vectors.expected.size(), shot.width * shot.height / 4);
        std::printf("    %s: up to %.2f pixels long, mean error %.5f, worst %.4f pixels\n",
                    bytes ? "bytes" : "half floats", longest,
                    mean / (2.0 * static_cast<double>(vectors.expected.size())), worst);
    }
    expect_validation_clean(test_device());
}

PlacedCamera moved(PlacedCamera camera, glm::dvec3 offset, double turn) {
    const glm::dmat3 turned(glm::rotate(glm::dmat4(1), turn, glm::dvec3(0.2, 1, 0.1)));
    camera.previous = CameraPose{camera.position + offset, turned * camera.axes};
    return camera;
}

TEST(MotionVectors, CameraAlone) {
    Garden garden;
    garden.camera = moved(garden.camera, {0.3, -0.1, 0.4}, 0.02);
    expect_motion(garden.shot(), 5);
    garden.camera.camera.kind = ProjectionKind::orthographic;
    garden.camera.camera.ymag = 3.5;
    garden.camera.camera.zfar = 30;
    expect_motion(garden.shot(), 5);
}

TEST(MotionVectors, CameraTenKilometresFromTheOrigin) {
    Garden garden(glm::dvec3(10000.03, -3.7, -10000.77));
    garden.camera = moved(garden.camera, {0.02, 0.01, 0}, 0);
    expect_motion(garden.shot(), 0.3);
}

TEST(MotionVectors, ObjectsAlone) {
    Garden garden;
    for (size_t i = 1; i < garden.world.instances.size(); ++i) { // spheres slide, turn and grow; the floor rests
        Instance& instance = garden.world.instances[i];
        glm::dmat4 before = glm::translate(instance.transform, {0.1 * static_cast<double>(i), 0.05, 0.02});
        before = glm::rotate(before, 0.2, glm::dvec3(0, 1, 0));
        instance.previous_transform = glm::scale(before, glm::dvec3(0.97));
    }
    expect_motion(garden.shot(), 8);
}

/// What skins and morph targets leave to a renderer: vertices that were elsewhere in their object.
TEST(MotionVectors, DeformedMeshes) {
    Garden garden;
    for (size_t i = 1; i < garden.world.instances.size(); i += 2) {
        Instance& instance = garden.world.instances[i];
        Mesh mesh = garden.scene.meshes[instance.mesh];
        for (Primitive& primitive : mesh.primitives)
            for (const glm::vec3& p : primitive.positions)
                primitive.previous_positions.push_back(p * (1 + 0.1f * p.y) + glm::vec3(0.1f * p.y, 0, 0));
        instance.deformed = static_cast<uint32_t>(garden.world.deformed.size());
        garden.world.deformed.push_back(std::move(mesh));
    }
    expect_motion(garden.shot(), 3);
    // With the object and the camera on the move at once.
    garden.world.instances[1].previous_transform = glm::translate(garden.world.instances[1].transform, {0, 0.2, 0});
    garden.camera = moved(garden.camera, {0.1, 0, 0.1}, 0.01);
    expect_motion(garden.shot(), 5);
}

/// The built-in scene: nodes, a skin, morph targets and a camera that flies.
TEST(MotionVectors, SceneMotion) {
    const Scene scene = make_scene("motion", 4, 1);
    const World world = resolve(scene, {}, Moment{.time = 1.3});
    for (const char* camera : {"front", "flight"}) {
        std::printf("    %s\n", camera);
        expect_motion({.world = &world, .camera = find_camera(world, camera)}, 1);
    }
}

TEST(MotionVectors, WhatStandsStillHasNone) {
    Garden garden;
    for (const passes::GBufferFormat& format : {passes::GBufferFormat{}, killzone2})
        for (const glm::dvec2& vector : vectors_of(garden.shot(), format).stored)
            ASSERT_EQ(vector, glm::dvec2(0));
}

// Signs, from one look: what moved right and down has positive X and Y.
TEST(MotionVectors, RightAndDownArePositive) {
    TestWorld test;
    test.add(square(20));
    test.world.instances[0].previous_transform = glm::translate(glm::dmat4(1), {-0.5, 0.25, 0});
    const Shot shot{.world = &test.world, .camera = front_camera(5)};
    const double pixels_per_metre = 90 / (5 * std::tan(0.4));
    for (const passes::GBufferFormat& format : {passes::GBufferFormat{}, killzone2})
        for (const glm::dvec2& vector : vectors_of(shot, format).stored) {
            ASSERT_NEAR(vector.x, 0.5 * pixels_per_metre, 0.3);
            ASSERT_NEAR(vector.y, 0.25 * pixels_per_metre, 0.3);
        }
}

// A point that passed the camera's plane, and one that is faster than 8 bits tell.
TEST(MotionVectors, FastOnesStayFiniteAndKeepTheirDirection) {
    TestWorld test;
    test.add(square(20));
    const Shot shot{.world = &test.world, .camera = front_camera(5)};
    test.world.instances[0].previous_transform = glm::translate(glm::dmat4(1), {0, 0, 10});
    for (const glm::dvec2& vector : vectors_of(shot, {}).stored)
        ASSERT_TRUE(std::isfinite(vector.x) && std::isfinite(vector.y));
    test.world.instances[0].previous_transform = glm::translate(glm::dmat4(1), {-12, 6, 0}); // 511, 255 pixels
    for (const glm::dvec2& vector : vectors_of(shot, killzone2).stored) {
        ASSERT_NEAR(vector.x, 64, 1e-6);
        ASSERT_NEAR(vector.y, 32, 0.4);
    }
    expect_validation_clean(test_device());
}

// The picture of it: hue is direction, black is rest.
TEST(MotionVectors, ViewIsAColourWheel) {
    struct Moved {
        glm::dvec2 pixels{0}; ///< right, down
        glm::vec3 colour{0};
    };
    const Moved squares[] = {{{0, 0}, {0, 0, 0}},
                             {{7, 0}, {0.5f, 0, 0}},     // right: red, half as bright
                             {{-7, 0}, {0, 0.5f, 0.5f}}, // left: cyan
                             {{0, 7}, {0.25f, 0.5f, 0}}, // down: yellow-green
                             {{0, -63}, {0.5f, 0, 1}}};  // up: violet, full
    TestWorld test;
    const double metre = 5 * std::tan(0.4) / 32; // of one pixel
    for (int i = 0; i < 5; ++i) {
        test.add(square(float(5 * metre)), glm::translate(glm::dmat4(1), {(12.0 * i - 24) * metre, 0, 0}));
        test.world.instances.back().previous_transform = glm::translate(
            test.world.instances.back().transform, {-squares[i].pixels.x * metre, squares[i].pixels.y * metre, 0});
    }
    for (const char* layout : {"wide", "killzone2"}) {
        RenderOptions options{.width = 64, .height = 64, .settings = {{"g-buffer", layout}}, .views = {"motion"}};
        const auto renderer = create_renderer("deferred", &test_device(), options);
        renderer->set_world(test.world);
        renderer->render(front_camera(5));
        const Image view = renderer->read("motion");
        for (int i = 0; i < 5; ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(view.at(uint32_t(8 + 12 * i), 32)[c], squares[i].colour[c], 0.02) << layout << ", " << i;
    }
}

} // namespace
} // namespace prelight
