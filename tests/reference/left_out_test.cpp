#include "worlds.hpp"
#include <gtest/gtest.h>
#include <numeric>

namespace prelight {
namespace {

constexpr uint32_t wall_size = 8;

/// A flat wall 10 m away, all in one instance; tests change pixel (4, 4) of it.
ReferencePicture wall() {
    ReferencePicture picture;
    const size_t pixels = wall_size * wall_size;
    picture.linear = Image(wall_size, wall_size);
    picture.instance.assign(pixels, 3);
    picture.primitive.assign(pixels, 0);
    picture.normal.assign(pixels, {0, 0, 1});
    picture.geometric_normal.assign(pixels, {0, 0, 1});
    picture.depth.assign(pixels, 10);
    picture.shadow_mask.assign(pixels, 0);
    picture.mask_outcome.assign(pixels, 0);
    for (size_t i = 0; i < pixels; ++i)
        picture.position.push_back({static_cast<double>(i % wall_size), static_cast<double>(i / wall_size), 0});
    return picture;
}

constexpr size_t wall_middle = 4 * wall_size + 4;

uint32_t count(const ReferencePicture& picture) {
    const auto left_out = picture.left_out();
    return std::accumulate(left_out.begin(), left_out.end(), 0u);
}

TEST(LeftOut, NothingOnAFlatWall) { EXPECT_EQ(count(wall()), 0u); }

TEST(LeftOut, OtherInstanceMaskOrShadow) {
    ReferencePicture picture = wall();
    picture.instance[wall_middle] = 4;
    EXPECT_EQ(count(picture), 9u); // the pixel and its eight neighbours
    const auto left_out = picture.left_out();
    EXPECT_EQ(left_out[3 * wall_size + 3], 1);
    EXPECT_EQ(left_out[2 * wall_size + 4], 0);
    picture = wall();
    picture.shadow_mask[wall_middle] = 1;
    EXPECT_EQ(count(picture), 9u);
    picture = wall();
    picture.mask_outcome[wall_middle] = 1;
    EXPECT_EQ(count(picture), 9u);
    picture = wall();
    picture.primitive[wall_middle] = 1; // another primitive alone is no edge
    EXPECT_EQ(count(picture), 0u);
}

TEST(LeftOut, NormalBeyondThirtyDegrees) {
    ReferencePicture picture = wall();
    const auto tilted = [](double degrees) {
        const double angle = degrees * 3.14159265358979 / 180;
        return glm::dvec3(std::sin(angle), 0, std::cos(angle));
    };
    picture.normal[wall_middle] = tilted(29.9);
    EXPECT_EQ(count(picture), 0u);
    picture.normal[wall_middle] = tilted(30.1);
    EXPECT_EQ(count(picture), 9u);
}

TEST(LeftOut, OffThePlaneByAPercentOfDepth) {
    ReferencePicture picture = wall();
    picture.position[wall_middle].z = 0.099;
    EXPECT_EQ(count(picture), 0u);
    picture.position[wall_middle].z = -0.101;
    EXPECT_EQ(count(picture), 9u);
    picture.depth.assign(wall_size * wall_size, 11);
    EXPECT_EQ(count(picture), 0u);
}

TEST(LeftOut, BackgroundIsAnotherInstanceAndHasNoEdgesItself) {
    ReferencePicture picture = wall();
    for (uint32_t y = 0; y < wall_size; ++y)
        for (uint32_t x = 4; x < wall_size; ++x) {
            const size_t i = y * wall_size + x;
            picture.instance[i] = 0xffffffffu;
            picture.normal[i] = glm::dvec3(0);
            picture.depth[i] = std::numeric_limits<double>::infinity();
        }
    EXPECT_EQ(count(picture), 2 * wall_size);
}

/// On rendered worlds.
uint32_t count_of(const TestWorld& test, const ReferenceForm& form, uint32_t pixels = 64) {
    return count(render_reference(test.world, front_camera(4), pixels, pixels, 0, form));
}

TEST(LeftOut, ShadowBorderOnlyWithShadows) {
    TestWorld test;
    test.add_material();
    test.add(square(10));
    // Off to the side, out of the picture, between the light and the plane.
    test.add(square(0.5f), glm::translate(glm::dmat4(1), {4, 0, 2}));
    test.add_light({.intensity = 100}, {8, 0, 4});
    EXPECT_EQ(count_of(test, {}), 0u);
    const uint32_t left_out = count_of(test, {.shadows = true});
    EXPECT_GT(left_out, 40u);
    EXPECT_LT(left_out, 1200u);
}

TEST(LeftOut, MaskBorderWithinOnePrimitive) {
    TestWorld test;
    Material masked{.alpha_mode = AlphaMode::mask};
    masked.base_colour_texture.image = test.add_image(2, 1, {255, 255, 255, 255, 255, 255, 255, 0});
    masked.base_colour_texture.sampler = {.wrap_s = Wrap::clamp_to_edge, .mag = Filter::nearest};
    test.add_material(masked);
    // One primitive: a wall, and 5 mm in front of it another one with a hole in its right half.
    // Depth and normals do not tell them apart.
    Primitive two = square(10);
    const Primitive front = square(10);
    for (size_t i = 0; i < 4; ++i) {
        two.texcoords[0][i] = {0, 0}; // the wall is opaque everywhere
        two.positions.push_back(front.positions[i] + glm::vec3(0, 0, 0.005f));
        two.normals.push_back(front.normals[i]);
        two.tangents.push_back(front.tangents[i]);
        two.texcoords[0].push_back(front.texcoords[0][i]);
    }
    for (const uint32_t index : {4u, 5u, 6u, 4u, 6u, 7u})
        two.indices.push_back(index);
    test.add(two);
    EXPECT_EQ(count_of(test, {.bilinear_level0 = false}), 2u * 64); // two columns of pixels
}

} // namespace
} // namespace prelight
