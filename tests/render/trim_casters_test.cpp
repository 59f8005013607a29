// Shadow maps are the same texels without the triangles that cover none of them.
#include "garden.hpp"
#include <gpu/context.hpp>
#include <prelight/scene_io.hpp>
#include <resident/trim_casters.hpp>

namespace prelight {
namespace {

/// A light of each kind over spheres; two masked, turned and mirrored squares.
struct CastingGarden : MixedMaterials {
    PlacedCamera camera = look_at(Camera{}, {4, 5, 8}, {0, 0, 0});
    CastingGarden() {
        add_material({.name = "floor"});
        add(square(12), glm::rotate(glm::translate(glm::dmat4(1), {0, -2, 0}), -1.57, {1, 0, 0}));
        for (int i = 0; i < 4; ++i)
            add(sphere(48), glm::translate(glm::dmat4(1), {2.2 * i - 3, 0.3 * i - 1, 0.7 * i}));
        add_light({.kind = LightKind::point, .intensity = 30, .range = 12}, {0, 3, 2}, {0, -1, 0});
        add_light({.kind = LightKind::spot, .intensity = 60, .range = 14, .outer_cone = 0.7f}, {4, 5, 3},
                  {-0.6, -1, -0.4});
        add_light({.kind = LightKind::directional, .intensity = 0.5f}, {0, 0, 0}, {-0.3, -1, -0.5});
    }
};

TEST(TrimCasters, LeaveMapsAsTheyAre) {
    const CastingGarden garden;
    for (const char* renderer : {"light-prepass", "z-prepass"})
        for (const char* budget : {"65536", "1048576"}) { // small tiles and large ones
            SCOPED_TRACE(std::string(renderer) + " " + budget);
            Shot shot{.world = &garden.world, .camera = garden.camera, .renderer = renderer};
            shot.settings = {{"shadows", "on"}, {"shadow-budget", budget}, {"index-trimming", "off"}};
            const Image whole = render_linear(test_device(), shot);
            shot.settings["index-trimming"] = "host";
            EXPECT_EQ(render_linear(test_device(), shot).pixels, whole.pixels);
            shot.settings = {{"index-trimming", "host"}};
            EXPECT_NE(render_linear(test_device(), shot).pixels, whole.pixels) << "there are shadows to compare";
        }
    expect_validation_clean(test_device());
}

/// Maps of sphere after sphere, seen from straight above in tiles of `side` texels.
struct Maps {
    TestWorld test;
    std::vector<resident::ShadowMap> maps;
    std::optional<resident::GpuScene> scene;
    explicit Maps(uint32_t side) {
        for (int i = 0; i < 3; ++i)
            test.add(sphere(64), glm::translate(glm::dmat4(1), {3.0 * i, 0, 0}));
        scene.emplace(dynamic_cast<const gpu::Context&>(test_device()), test.world,
                      resident::GpuSceneSettings{.casters = true});
        const glm::mat4 onto(0.2f, 0, 0, 0, 0, 0.2f, 0, 0, 0, 0, 0.05f, 0, 0, 0, 0.5f, 1);
        for (uint32_t m = 0; m < 40; ++m)
            maps.push_back(
                {.place = {{0, 0}, side, 0},
                 .clip_from_centre = glm::translate(glm::mat4(1), {0.05f * static_cast<float>(m), 0, 0}) * onto,
                 .casters = {0, 1, 2},
                 .versions = {0, 0, 0}});
    }
    size_t indices() const { return scene->geometry().draws[0].index_count; }
};

TEST(TrimCasters, SmallTilesAreLeftFewTriangles) {
    const Maps small(8), large(1024);
    std::vector<uint32_t> room(1u << 24);
    const auto kept = [&](const Maps& maps) {
        size_t sum = 0;
        const std::vector<resident::VisibleDraw> casters = resident::trim_casters(*maps.scene, maps.maps, room);
        EXPECT_EQ(casters.size(), 120u);
        for (const resident::VisibleDraw& caster : casters) {
            EXPECT_TRUE(caster.trimmed);
            EXPECT_EQ(caster.first_index, sum); // one after the other, however many threads there are
            sum += caster.index_count;
        }
        return sum;
    };
    EXPECT_LT(kept(small), 120 * small.indices() / 50);
    const size_t most = kept(large);
    EXPECT_GT(most, 120 * large.indices() / 5) << "both faces";
    EXPECT_LT(most, 120 * large.indices() * 9 / 10) << "what lies beside the tile";
}

TEST(TrimCasters, WhatDoesNotFitIsDrawnWhole) {
    const Maps maps(1024);
    std::vector<uint32_t> room(40 * maps.indices());
    const std::vector<resident::VisibleDraw> casters = resident::trim_casters(*maps.scene, maps.maps, room);
    size_t trimmed = 0, whole = 0;
    for (size_t c = 0; c < casters.size(); ++c) {
        const resident::Draw& draw = maps.scene->geometry().draws[c % 3];
        trimmed += casters[c].trimmed;
        if (casters[c].trimmed) {
            EXPECT_LE(casters[c].first_index + casters[c].index_count, room.size());
            continue;
        }
        ++whole;
        EXPECT_EQ(casters[c].first_index, draw.first_index);
        EXPECT_EQ(casters[c].index_count, draw.index_count);
    }
    EXPECT_GT(trimmed, 0u);
    EXPECT_GT(whole, 0u);
}

} // namespace
} // namespace prelight
