// Where shadow maps lie in their atlas, how lights look through them, and what casts in them; without a device.
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>
#include <resident/shadow_plan.hpp>

namespace prelight::resident {
namespace {

bool overlap(const ShadowTilePlace& a, const ShadowTilePlace& b) {
    return a.corner.x < b.corner.x + b.side && b.corner.x < a.corner.x + a.side && a.corner.y < b.corner.y + b.side &&
           b.corner.y < a.corner.y + a.side;
}

TEST(ShadowAtlas, IsAsLargeAsTheBudgetLets) {
    for (const auto& [budget, texels] :
         {std::pair(1u, 1u), {2u, 2u}, {3u, 2u}, {4u, 4u}, {1000u, 512u}, {1u << 24, 1u << 24}, {1u << 25, 1u << 25}})
        EXPECT_EQ(ShadowAtlas(budget, 16384).texels(), texels) << budget;
    EXPECT_EQ(ShadowAtlas(1u << 24, 1024).size(), glm::uvec2(1024)); // the device makes no larger image
}

TEST(ShadowAtlas, HoldsWhateverFitsBySum) {
    ShadowAtlas atlas(1 << 13, 4096); // 128 × 64: two squares
    std::vector<ShadowTilePlace> places;
    for (uint32_t round = 0; round < 40; ++round) {
        std::vector<ShadowAtlas::Wish> wishes;
        uint64_t texels = 0;
        for (uint32_t i = 0; texels < atlas.texels(); ++i) { // sizes that change from round to round, until all is full
            uint32_t side = 1u << ((i * 7 + round * 3 + i * i * round) % 7);
            while (texels + uint64_t(side) * side > atlas.texels())
                side /= 2;
            texels += uint64_t(side) * side;
            wishes.push_back({{i / 6, i % 6}, side});
        }
        atlas.place(wishes, places);
        ASSERT_EQ(places.size(), wishes.size());
        std::vector<uint8_t> taken(atlas.texels());
        for (size_t i = 0; i < places.size(); ++i) {
            ASSERT_EQ(places[i].side, wishes[i].side);
            for (uint32_t y = 0; y < places[i].side; ++y)
                for (uint32_t x = 0; x < places[i].side; ++x) {
                    const glm::uvec2 at = places[i].corner + glm::uvec2(x, y);
                    ASSERT_LT(at.x, atlas.size().x);
                    ASSERT_LT(at.y, atlas.size().y);
                    ASSERT_EQ(taken[at.y * atlas.size().x + at.x]++, 0) << "two tiles on a texel";
                }
        }
    }
}

TEST(ShadowAtlas, TilesOfUnchangedSizeStay) {
    ShadowAtlas atlas(1 << 14, 4096);
    std::vector<ShadowTilePlace> before, after;
    atlas.place({{{0, 0}, 32}, {{1, 0}, 16}, {{2, 0}, 64}, {{3, 0}, 8}}, before);
    atlas.place({{{0, 0}, 32}, {{1, 0}, 32}, {{3, 0}, 8}, {{4, 0}, 16}}, after);
    EXPECT_EQ(after[0], before[0]);
    EXPECT_EQ(after[2], before[3]);
    for (size_t i = 0; i < after.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlap(after[i], after[j]));
}

const WorldBox world{{-30, 0, -40}, {30, 12, 40}};

PlacedCamera camera_at(glm::dvec3 eye, double turn) {
    Camera lens;
    lens.yfov = 0.8;
    return look_at(lens, eye, eye + glm::dvec3(std::sin(turn), -0.2, std::cos(turn)));
}

// Cascades move in whole texels and do not change as the camera turns: edges of shadows do not crawl.
TEST(ShadowViews, CascadesAreStable) {
    const PlacedLight sun{{.kind = LightKind::directional}, glm::dvec3(0), glm::normalize(glm::dvec3(-0.4, -1, 0.3))};
    const uint32_t side = 1024, guard = 6;
    std::vector<ShadowView> first, views;
    find_shadow_views(sun, camera_at({1, 2, 3}, 0), 16.0 / 9, world, side, guard, first);
    ASSERT_EQ(first.size(), 4u);
    const glm::dvec4 origin(0, 0, 0, 1);
    for (int step = 1; step < 200; ++step) {
        const PlacedCamera camera = camera_at({1 + 0.031 * step, 2, 3 - 0.017 * step}, 0.13 * step);
        find_shadow_views(sun, camera, 16.0 / 9, world, side, guard, views);
        for (size_t c = 0; c < 4; ++c) {
            ASSERT_EQ(views[c].texel, first[c].texel) << "cascade " << c << " changes size";
            const glm::dvec4 moved =
                (views[c].clip_from_centre * origin - first[c].clip_from_centre * origin) * (side / 2.0);
            ASSERT_NEAR(moved.x, std::round(moved.x), 1e-6);
            ASSERT_NEAR(moved.y, std::round(moved.y), 1e-6);
            ASSERT_EQ(moved.z, 0) << "depth is the world's, not the camera's";
        }
    }
}

// Every point that the camera sees lies in its cascade, at least the guard band away from the edge.
TEST(ShadowViews, CascadesHoldTheirSliceOfTheView) {
    const PlacedLight sun{{.kind = LightKind::directional}, glm::dvec3(0), glm::normalize(glm::dvec3(0.2, -0.5, 0.8))};
    const uint32_t side = 512, guard = 6;
    for (const ProjectionKind kind : {ProjectionKind::perspective, ProjectionKind::orthographic}) {
        PlacedCamera camera = camera_at({4, 3, -8}, 0.7);
        camera.camera.kind = kind;
        camera.camera.ymag = 5;
        if (kind == ProjectionKind::orthographic)
            camera.camera.zfar = 60;
        std::vector<ShadowView> views;
        find_shadow_views(sun, camera, 2, world, side, guard, views);
        const glm::dvec4 ends = cascade_ends(camera, world);
        const double half = kind == ProjectionKind::perspective ? std::tan(camera.camera.yfov / 2) : 5;
        for (int c = 0; c < 4; ++c)
            for (int corner = 0; corner < 8; ++corner) {
                const double depth = corner & 1 ? ends[c] : c ? ends[c - 1] : 0;
                const double across = half * (kind == ProjectionKind::perspective ? depth : 1);
                const glm::dvec3 point = camera.position - camera.axes[2] * depth +
                                         camera.axes[0] * (corner & 2 ? 2 * across : -2 * across) +
                                         camera.axes[1] * (corner & 4 ? across : -across);
                const glm::dvec4 clip = views[size_t(c)].clip_from_centre * glm::dvec4(point - world.centre(), 1);
                const double most = 1 - 2.0 * (guard - 1) / side; // snapping takes up to half a texel
                EXPECT_LE(std::abs(clip.x), most);
                EXPECT_LE(std::abs(clip.y), most);
            }
    }
}

// Lighting derives the axes of faces and spots, and reads no matrix: both have to be the plan's.
TEST(ShadowViews, LightingDerivesTheirAxes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1, 1);
    const uint32_t side = 64, guard = 6;
    const auto expect = [&](const ShadowView& view, glm::dvec3 point, glm::vec3 along, const std::string& what) {
        const glm::dvec4 clip = view.clip_from_centre * glm::dvec4(point - world.centre(), 1);
        const double texels = 2 / (view.texel_per_w * side);
        EXPECT_NEAR(clip.x, along.x * texels, 1e-5) << what;
        EXPECT_NEAR(clip.y, along.y * texels, 1e-5) << what;
        EXPECT_NEAR(clip.w, along.z, 1e-5) << what;
    };
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 offset(any(random), any(random), any(random));
        const glm::dvec3 eye(1, 2, 3);
        std::vector<ShadowView> views;
        find_shadow_views({{.kind = LightKind::point, .range = 5}, eye}, camera_at({0, 0, 0}, 0), 1, world, side, guard,
                          views);
        const shared::CubeFace face = shared::cube_face(offset);
        const uint32_t number = shared::number_of(face);
        ASSERT_EQ(views.size(), 6u);
        expect(views[number], eye + glm::dvec3(offset), shared::along_face(face, offset),
               "face " + std::to_string(number));
        glm::vec3 axis = glm::normalize(glm::vec3(any(random), any(random), any(random)));
        axis = i < 2 ? glm::vec3(0, 0, i == 0 ? 1 : -1) : axis;
        const Light spot{.kind = LightKind::spot, .range = 5, .inner_cone = 0.2f, .outer_cone = 0.6f};
        find_shadow_views({spot, eye, axis}, camera_at({0, 0, 0}, 0), 1, world, side, guard, views);
        ASSERT_EQ(views.size(), 1u);
        expect(views[0], eye + glm::dvec3(offset),
               {glm::dot(shared::spot_right(axis), offset), glm::dot(shared::spot_up(axis), offset),
                glm::dot(axis, offset)},
               "spot");
    }
}

// Faces share their edges: a direction on one lies as far from the tile's middle in both.
TEST(ShadowViews, FacesMeetAtTheirEdges) {
    const PlacedLight lamp{{.kind = LightKind::point, .range = 5}, {1, 2, 3}};
    const uint32_t side = 256, guard = 8;
    std::vector<ShadowView> faces;
    find_shadow_views(lamp, camera_at({0, 0, 0}, 0), 1, world, side, guard, faces);
    ASSERT_EQ(faces.size(), 6u);
    const auto place = [&](size_t face, glm::dvec3 direction) {
        const glm::dvec4 clip =
            faces[face].clip_from_centre * glm::dvec4(lamp.position + direction - world.centre(), 1);
        return glm::dvec3(clip.x / clip.w, clip.y / clip.w, clip.w);
    };
    const double edge = double(side - 2 * guard) / side;
    for (const auto& [a, b, direction] :
         {std::tuple(0, 2, glm::dvec3(1, 1, 0.3)), {0, 5, glm::dvec3(1, -0.4, -1)}, {1, 3, glm::dvec3(-1, -1, 0.2)}}) {
        for (const int face : {a, b}) {
            const glm::dvec3 p = place(size_t(face), direction);
            EXPECT_NEAR(std::max(std::abs(p.x), std::abs(p.y)), edge, 1e-9);
            EXPECT_NEAR(p.z, 1, 1e-9);
        }
    }
}

/// A floor, and a box on either side of the middle.
std::vector<Draw> floor_and_boxes() {
    std::vector<Draw> draws(3);
    draws[0].low = {-10, -0.1, -10}, draws[0].high = {10, 0, 10};
    draws[1].low = {-4, 0.5, -1}, draws[1].high = {-3, 1.5, 1};
    draws[2].low = {3, 0.5, -1}, draws[2].high = {4, 1.5, 1};
    return draws;
}

std::vector<ShadowTile> tiles_of(ShadowPlan& plan, const std::vector<PlacedLight>& lights) {
    std::vector<uint32_t> visible(lights.size());
    for (uint32_t i = 0; i < visible.size(); ++i)
        visible[i] = i;
    plan.update(lights, visible, camera_at({0, 3, -1}, 0), 16.0 / 9, 320, 180); // in range: sizes stay
    return plan.tiles();
}

// A plan that knew the light before it changed has the maps that a new plan has.
TEST(ShadowPlan, CastersAreThoseOfTheLightAsItIs) {
    const std::vector<Draw> draws = floor_and_boxes();
    const PlacedLight light{
        {.kind = LightKind::spot, .range = 20, .outer_cone = 0.3f}, {0, 4, 0}, glm::normalize(glm::dvec3(-3.5, -3, 0))};
    std::vector<PlacedLight> changed(6, light);
    changed[0].direction = glm::normalize(glm::dvec3(3.5, -3, 0));
    changed[1].light.outer_cone = 1.0f;
    changed[2].light.kind = LightKind::point;
    changed[3].light.kind = LightKind::directional;
    changed[4].position = {1, 4, 0};
    changed[5].light.range = 3; // the matrix stays, the casters don't
    for (const PlacedLight& next : changed) {
        ShadowPlan plan(draws, {}, 4096), fresh(draws, {}, 4096);
        const std::vector<ShadowTile> before = tiles_of(plan, {light});
        ASSERT_EQ(before.size(), 1u);
        EXPECT_EQ(before[0].map.casters, (std::vector<uint32_t>{0, 1}));
        const std::vector<ShadowTile> after = tiles_of(plan, {next}), right = tiles_of(fresh, {next});
        ASSERT_EQ(after.size(), right.size());
        for (size_t i = 0; i < after.size(); ++i) {
            EXPECT_TRUE(after[i].map == right[i].map) << "change " << &next - changed.data() << ", tile " << i;
            EXPECT_FALSE(after[i].map == before[0].map);
        }
        EXPECT_TRUE(tiles_of(plan, {next})[0].map == right[0].map);
    }
}

// A change that no caster and no texel of the maps depends on leaves them equal: they are not drawn again.
TEST(ShadowPlan, MapsStayWhereNothingThatTheyShowChanged) {
    const std::vector<Draw> draws = floor_and_boxes();
    PlacedLight light{{.kind = LightKind::point, .range = 20}, {0, 4, 0}};
    ShadowPlan plan(draws, {}, 4096);
    const std::vector<ShadowTile> before = tiles_of(plan, {light});
    light.light.intensity = 9;
    light.light.range = 19.5f;
    light.direction = {1, 0, 0}; // of a point
    const std::vector<ShadowTile> after = tiles_of(plan, {light});
    ASSERT_EQ(after.size(), before.size());
    for (size_t i = 0; i < after.size(); ++i)
        EXPECT_TRUE(after[i].map == before[i].map) << i;
}

// A light asks for no more than it could have alone, so that what is left out is what others took.
TEST(ShadowPlan, LightsAskForWhatFits) {
    const std::vector<Draw> draws = floor_and_boxes();
    const PlacedLight sun{{.kind = LightKind::directional}, glm::dvec3(0), glm::normalize(glm::dvec3(-0.4, -1, 0.3))};
    const PlacedLight lamp{{.kind = LightKind::point, .range = 30}, {0, 4, 0}};
    for (const PlacedLight& light : {sun, lamp}) {
        ShadowPlan plan(draws, {}, 16384);
        tiles_of(plan, {light});
        EXPECT_EQ(plan.stats().lights_reduced, 0u);
    }
    ShadowPlan plan(draws, {}, 16384), small(draws, {.budget = 1 << 12}, 16384);
    tiles_of(plan, {sun, lamp});
    EXPECT_EQ(plan.stats().lights_reduced, 0u);
    tiles_of(small, {sun, lamp});
    EXPECT_EQ(small.stats().lights_reduced, 2u);
}

} // namespace
} // namespace prelight::resident
