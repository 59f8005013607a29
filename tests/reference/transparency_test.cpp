// Blended surfaces as layers, against closed forms from the farthest to the nearest, and pictures of opaque scenes.
#include "panes.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace prelight {
namespace {

constexpr glm::vec3 wall_colour{0.9f, 0.3f, 0.1f};

/// Panes of every colour and alpha, from the farthest to the nearest.
std::vector<Pane> stack(size_t count) {
    std::vector<Pane> panes;
    for (size_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        panes.push_back({{0.5f + 0.5f * std::sin(x), 0.5f + 0.5f * std::cos(2 * x), 0.1f * x},
                         0.1f + 0.8f * std::fmod(0.37f * x, 1.0f),
                         0.5 + 0.2 * double(i)});
    }
    return panes;
}

void add_panes(TestWorld& test, std::vector<Pane> panes, uint32_t shuffle) {
    std::shuffle(panes.begin(), panes.end(), std::mt19937(shuffle));
    for (const Pane& pane : panes) {
        test.add_material(blended(pane.colour, pane.alpha));
        test.add(square(30), at_height(pane.z));
    }
}

/// A picture in which every pixel is `wanted`.
void expect_everywhere(const Image& picture, glm::dvec3 wanted, const std::string& what = {}) {
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        expect_colour(picture.pixels[i], wanted, what + " pixel " + std::to_string(i));
}

TEST(Transparency, PanesInFrontOfAWallAndOfNothing) {
    for (const size_t count : {1u, 4u, 15u})
        for (const bool wall : {false, true})
            for (const ProjectionKind kind : {ProjectionKind::orthographic, ProjectionKind::perspective}) {
                const std::vector<Pane> panes = stack(count);
                std::vector<Image> pictures;
                for (const uint32_t shuffle : {1u, 2u, 3u}) {
                    TestWorld test;
                    const auto add_wall = [&] {
                        test.add_material(unlit(wall_colour));
                        test.add(square(30));
                    };
                    if (wall && shuffle != 3)
                        add_wall();
                    add_panes(test, panes, shuffle);
                    if (wall && shuffle == 3)
                        add_wall();
                    const auto picture = in_metres(test, in_layers, kind);
                    expect_everywhere(picture.linear, laid_over(wall ? wall_colour : glm::vec3(0), panes),
                                      std::to_string(count) + (wall ? " on the wall" : ""));
                    for (const uint32_t layers : picture.layer_count)
                        EXPECT_EQ(layers, count);
                    pictures.push_back(picture.linear);
                }
                EXPECT_TRUE(pictures[1].pixels == pictures[0].pixels); // whatever order the scene has them in
                EXPECT_TRUE(pictures[2].pixels == pictures[0].pixels);
            }
}

TEST(Transparency, APictureBehindIsTheBackgroundToo) {
    TestWorld test;
    test.scene.environment = surroundings([](size_t) { return glm::vec3(0.2f, 0.4f, 3); });
    const std::vector<Pane> panes = stack(3);
    const Image bare = in_metres(test).linear;
    ASSERT_GT(bare.pixels[0].b, 1); // it does show
    add_panes(test, panes, 1);
    expect_everywhere(in_metres(test).linear, laid_over(glm::dvec3(bare.pixels[0]), panes));
}

TEST(Transparency, AlphaIsFactorTimesTextureTimesVertexColour) {
    TestWorld test;
    test.add_material(unlit(wall_colour));
    test.add(square(30));
    Material pane = blended({1, 1, 1}, 0.8f);
    pane.base_colour_texture.image = test.add_image(1, 1, {255, 255, 255, 102});
    test.add_material(pane);
    Primitive coloured = square(30);
    coloured.colours.assign(4, glm::vec4(0.5f, 0.25f, 1, 0.6f));
    test.add(coloured, at_height(1));
    const double alpha = 0.8f * (102 / 255.0) * 0.6f;
    expect_everywhere(in_metres(test).linear, alpha * glm::dvec3(0.5, 0.25, 1) + (1 - alpha) * glm::dvec3(wall_colour));
    // 0 … 1, whatever a file says.
    test.scene.materials[1].base_colour.a = 9;
    expect_everywhere(in_metres(test).linear, {0.5, 0.25, 1});
}

TEST(Transparency, LayersWithoutAlphaAddNothing) {
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(sphere(16), glm::scale(glm::dmat4(1), glm::dvec3(4)));
    test.add_light({.intensity = 50}, {3, 2, 9});
    const auto bare = in_metres(test);
    test.add_material({.base_colour = {1, 1, 1, 0}, .emissive = {5, 5, 5}, .alpha_mode = AlphaMode::blend});
    test.add(square(30), at_height(4.5));
    const auto picture = in_metres(test);
    EXPECT_TRUE(picture.linear.pixels == bare.linear.pixels);
}

TEST(Transparency, PanesThatCrossAreInThePixelsOwnOrder) {
    for (const bool turned : {false, true}) {
        TestWorld test;
        test.add_material(unlit(wall_colour));
        test.add(square(60), at_height(-30));
        const Pane red{{1, 0, 0}, 0.6f}, green{{0, 1, 0}, 0.3f};
        for (const bool first : {!turned, turned}) {
            const Pane& pane = first ? red : green;
            test.add_material(blended(pane.colour, pane.alpha));
            // Red rises to the right, green to the left.
            test.add(square(40), glm::rotate(glm::dmat4(1), first ? -0.3 : 0.3, glm::dvec3(0, 1, 0)));
        }
        const Image picture = in_metres(test).linear;
        for (uint32_t y = 0; y < rows; ++y)
            for (uint32_t x = 0; x < columns; ++x)
                expect_colour(picture.at(x, y),
                              x < columns / 2 ? laid_over(wall_colour, {red, green})
                                              : laid_over(wall_colour, {green, red}),
                              std::to_string(x));
    }
}

TEST(Transparency, AMaskStandsInFrontOrBehind) {
    for (const double z : {0.5, 1.5}) {
        TestWorld test;
        test.add_material(unlit(wall_colour));
        test.add(square(30));
        const Pane pane{{0.1f, 0.2f, 1}, 0.7f};
        test.add_material(blended(pane.colour, pane.alpha));
        test.add(square(30), at_height(1));
        Material mask = unlit({0, 1, 0});
        mask.alpha_mode = AlphaMode::mask;
        mask.base_colour_texture.image = test.add_image(2, 1, {255, 255, 255, 0, 255, 255, 255, 255});
        test.add_material(mask);
        test.add(square(12), at_height(z));
        const auto picture = in_metres(test);
        for (uint32_t x = 0; x < columns; ++x) {
            const bool there = x >= columns / 2; // the other half is a hole
            const glm::dvec3 behind = there ? glm::dvec3(0, 1, 0) : glm::dvec3(wall_colour);
            const bool before = there && z > 1;
            expect_colour(picture.linear.at(x, 8), before ? behind : laid_over(behind, {pane}), std::to_string(x));
            EXPECT_EQ(picture.layer_count[8 * columns + x], before ? 0u : 1u);
        }
    }
}

TEST(Transparency, FacesAreThereAsOfOpaqueSurfaces) {
    const Pane pane{{0, 0, 1}, 0.25f};
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 3.14159265358979, glm::dvec3(0, 1, 0));
    const glm::dmat4 mirrored = glm::scale(glm::dmat4(1), {-1, 1, 1});
    for (const bool double_sided : {false, true})
        for (const auto& [transform, front] :
             {std::pair(glm::dmat4(1), true), {turned, false}, {mirrored, true}, {turned * mirrored, false}}) {
            TestWorld test;
            test.add_material(unlit(wall_colour));
            test.add(square(30), at_height(-1));
            test.add_material(blended(pane.colour, pane.alpha)).double_sided = double_sided;
            test.add(square(30), transform);
            const bool there = front || double_sided;
            expect_everywhere(in_metres(test).linear, there ? laid_over(wall_colour, {pane}) : glm::dvec3(wall_colour));
        }
}

TEST(Transparency, WhatIsBehindTheCameraIsNot) {
    for (const ProjectionKind kind : {ProjectionKind::orthographic, ProjectionKind::perspective}) {
        TestWorld test;
        const PlacedCamera camera = metre_camera(kind);
        const Pane before{{1, 0, 0}, 0.5f, camera.position.z - 1}, behind{{0, 1, 0}, 0.5f, camera.position.z + 1};
        add_panes(test, {before, behind}, 1);
        expect_everywhere(in_metres(test, in_layers, kind).linear, {0.5, 0, 0});
    }
}

TEST(Transparency, ASurfaceOfManyTrianglesIsOneLayer) {
    // The rays go through edges and corners of a grid, where Embree meets every triangle around.
    Primitive grid;
    constexpr int side = 6;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) {
            grid.positions.push_back({x - side / 2, y - side / 2, 0});
            grid.normals.push_back({0, 0, 1});
        }
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = y * (side + 1) + x, b = a + side + 1;
            for (const uint32_t index : {a, a + 1, b + 1, a, b + 1, b})
                grid.indices.push_back(index);
        }
    TestWorld test;
    const Pane pane{{1, 0.5f, 0}, 0.5f};
    test.add_material(blended(pane.colour, pane.alpha));
    test.add(grid);
    // Five pixels of a metre: their centres are corners.
    const PlacedCamera camera =
        look_at({.kind = ProjectionKind::orthographic, .ymag = 2.5, .znear = 0.1f}, {0, 0, 5}, {0, 0, 0});
    const auto picture = render_reference(test.world, camera, 5, 5, 0, in_layers);
    expect_everywhere(picture.linear, laid_over({0, 0, 0}, {pane}));
    // Twice the same triangle is two layers.
    const std::vector<uint32_t> once = grid.indices;
    std::vector<uint32_t>& twice = test.scene.meshes[0].primitives[0].indices;
    twice.insert(twice.end(), once.begin(), once.end());
    expect_everywhere(
        render_reference(test.world, look_at(camera.camera, {0.3, 0.2, 5}, {0.3, 0.2, 0}), 5, 5, 0, in_layers).linear,
        laid_over({0, 0, 0}, {pane, pane}));
}

TEST(Transparency, WhatLiesInOnePlaneIsInTheScenesOrder) {
    const Pane red{{1, 0, 0}, 0.5f}, green{{0, 1, 0}, 0.5f};
    const glm::dmat4 tilted = glm::rotate(glm::dmat4(1), 0.2, glm::normalize(glm::dvec3(1, 2, 0)));
    for (const bool red_first : {false, true}) {
        TestWorld test;
        for (const Pane& pane : red_first ? std::vector{red, green} : std::vector{green, red}) {
            test.add_material(blended(pane.colour, pane.alpha));
            test.add(square(pane.colour.r > 0 ? 31.3f : 47.1f), tilted);
        }
        expect_everywhere(in_metres(test).linear,
                          red_first ? laid_over({0, 0, 0}, {green, red}) : laid_over({0, 0, 0}, {red, green}));
        // On an opaque surface of the same triangles it is seen, and not a hundredth of a millimetre behind one.
        test.add_material(unlit(wall_colour));
        test.add(square(31.3f), tilted);
        EXPECT_EQ(in_metres(test).layers.size(), size_t(columns) * rows * 2);
        test.world.instances.back().transform = at_height(1e-5) * tilted;
        EXPECT_TRUE(in_metres(test).layers.empty());
    }
}

} // namespace
} // namespace prelight
