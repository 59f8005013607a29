// Light lists hold every light that contributes, wherever the camera is.
#include "garden.hpp"
#include <cstring>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <random>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;
Settings with(Settings settings, const Settings& more) {
    settings.insert(more.begin(), more.end());
    return settings;
}

/// Lists find exactly the pairs that contribute, and evaluate no more than every light on every pixel.
/// Returns what they evaluate.
uint64_t expect_every_contributing_light(const Shot& shot, const std::string& culling, const std::string& where) {
    Shot full = shot, lists = shot;
    full.settings["light-culling"] = "fullscreen";
    full.settings.erase("tile-size"); // refused where there are no tiles
    lists.settings["light-culling"] = culling;
    const Rendered baseline = render_counting_pairs(full), found = render_counting_pairs(lists);
    EXPECT_EQ(found.stats.pairs_contributing, baseline.stats.pairs_contributing) << culling << ", " << where;
    EXPECT_LE(found.stats.pairs_evaluated, baseline.stats.pairs_evaluated) << culling << ", " << where;
    // Blended half floats are rounded light by light, sums of a list once.
    EXPECT_GE(compare_pixels(found.linear, baseline.linear).psnr, 60) << culling << ", " << where;
    return found.stats.pairs_evaluated;
}

bool same_bytes(const Image& a, const Image& b) {
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(a.pixels[0])) == 0;
}

struct ListCase {
    const char* name;
    const char* culling;
    const char* tile_size;
};
void PrintTo(const ListCase& c, std::ostream* out) { *out << c.name; }
std::string case_name(const testing::TestParamInfo<ListCase>& info) { return info.param.name; }

class LightLists : public testing::TestWithParam<ListCase> {
protected:
    Settings settings(const Settings& more = {}) const {
        return with({{"light-culling", GetParam().culling}, {"tile-size", GetParam().tile_size}}, more);
    }
};
INSTANTIATE_TEST_SUITE_P(Tiles, LightLists,
                         testing::Values(ListCase{"tiles_8", "tiles", "8"}, ListCase{"tiles_32", "tiles", "32"}),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Clusters, LightLists,
                         testing::Values(ListCase{"clusters_8", "clusters", "8"},
                                         ListCase{"clusters_16", "clusters", "16"}),
                         case_name);

TEST_P(LightLists, AgreeWithTheReferenceFromOutsideInsideAndCutByTheNearPlane) {
    static std::map<std::pair<bool, double>, References> references; // of all cases
    for (const bool spot : {false, true})
        for (const double share : {1.5, 1.0, 0.3}) { // distance of the light from the camera, in ranges
            Garden garden;
            garden.camera.camera.znear = 0.25;
            Light light = spot ? garden.spot(0.6f, 8, 60) : garden.point(8, 30);
            garden.add_light(light, garden.camera.position - garden.camera.axes[2] * (share * 8), {0, -1, -0.4});
            garden.add_lights(5, 3, 4);
            Shot shot = garden.shot();
            shot.settings = settings();
            shot.width = 317; // no multiple of a tile
            shot.height = 179;
            SCOPED_TRACE(std::to_string(share) + (spot ? " spot" : " point"));
            references[{spot, share}].expect_agrees(shot);
        }
}

TEST_P(LightLists, AgreeWithTheReferenceWithLightsThatAreEverywhere) {
    Garden garden;
    garden.add_lights(24, 2.5f, 4);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
    garden.add_light(garden.point(std::numeric_limits<float>::infinity(), 6), {2, 4, 2});
    Shot shot = garden.shot();
    static References references; // of all cases
    for (const Settings& more : {Settings{{"ambient", "light"}}, Settings{{"light-buffer", "packed-rgba16f"}},
                                 Settings{{"depth", "r32f"}, {"position", "matrix"}}}) {
        shot.settings = settings(more);
        references.expect_agrees(shot);
    }
}

TEST_P(LightLists, HoldEveryContributingLightOfRandomScenes) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int scene = 0; scene < 6; ++scene) {
        Garden garden;
        for (int i = 0; i < 60; ++i) {
            const float range = static_cast<float>(std::exp(uniform(-2.5, 2)));
            const Light light =
                i % 2 ? garden.spot(static_cast<float>(uniform(0.02, 1.57)), range, 4) : garden.point(range, 4);
            const glm::dvec3 axis(uniform(-1, 1), uniform(-1, 0.2), uniform(-1, 1));
            garden.add_light(light, garden.at(uniform(-6, 6), uniform(-0.2, 4), uniform(-6, 9)), axis);
        }
        Shot shot = garden.shot();
        shot.width = static_cast<uint32_t>(uniform(20, 200));
        shot.height = static_cast<uint32_t>(uniform(20, 120));
        Camera& lens = shot.camera.camera;
        lens.yfov = uniform(0.15, 2.4);
        if (scene % 3 == 1)
            lens.zfar = uniform(9, 14);
        if (scene % 3 == 2) {
            lens.kind = ProjectionKind::orthographic;
            lens.ymag = uniform(0.5, 6);
            lens.znear = uniform(0, 8);
            lens.zfar = lens.znear + uniform(3, 20);
        }
        shot.settings =
            with({{"tile-size", GetParam().tile_size}}, scene % 2 == 1 ? Settings{{"depth", "r32f"}} : Settings{});
        expect_every_contributing_light(shot, GetParam().culling, "scene " + std::to_string(scene));
    }
    expect_validation_clean(test_device());
}

TEST_P(LightLists, GiveTheSameBytesTwice) {
    Garden garden;
    garden.add_lights(300, 2, 3);
    Shot shot = garden.shot();
    shot.settings = settings();
    const Rendered once = render_counting_pairs(shot, 2), twice = render_counting_pairs(shot, 3);
    EXPECT_TRUE(same_bytes(once.linear, twice.linear));
    EXPECT_EQ(once.stats.pairs_evaluated, twice.stats.pairs_evaluated);
}

// Blocks without light keep what they held, and that must be none.
TEST_P(LightLists, LeaveNoLightWhereNoneIsAnyMore) {
    Garden garden;
    garden.add_lights(12, 1.2f, 4);
    for (const auto& [shading, more] : {std::pair(Shading::ggx, Settings{}),
                                        {Shading::ggx, {{"light-buffer", "packed-rgba16f"}}},
                                        {Shading::phong, {{"specular", "luv"}, {"ambient", "light"}}}}) {
        Shot shot = garden.shot();
        shot.shading = shading;
        shot.settings = settings(more);
        RenderOptions options = options_of(shot);
        options.views = {"diffuse-light", "specular-light", "light-count"};
        const auto renderer = create_renderer(shot.renderer, &test_device(), options);
        const auto fresh = create_renderer(shot.renderer, &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(shot.camera, 2);
        std::vector<PlacedLight> lights = garden.world.lights;
        for (PlacedLight& light : lights)
            light.position += glm::dvec3(1.5, 0.3, -2);
        lights.resize(7);
        PlacedCamera camera = shot.camera;
        camera.position += glm::dvec3(0.4, 1, 0.5);
        renderer->set_lights(lights);
        renderer->render(camera, 3);
        World world = garden.world;
        world.lights = lights;
        fresh->set_world(world);
        fresh->render(camera);
        for (const std::string& view : options.views)
            EXPECT_TRUE(same_bytes(renderer->read(view), fresh->read(view)))
                << view << ", " << options.settings.at("tile-size");
    }
    expect_validation_clean(test_device());
}

TEST_P(LightLists, AgreeOnSwiftShader) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    Garden garden;
    garden.add_lights(40, 2.5f, 4);
    garden.add_light(garden.spot(0.6f, 8, 30), {1, 4, 2}, {0, -1, -0.2});
    Shot shot = garden.shot();
    shot.width = 160;
    shot.height = 90;
    shot.settings = settings();
    const Comparison c = against_reference(*device, shot);
    EXPECT_GE(c.psnr, half_float_bound.psnr);
    EXPECT_LE(c.block, half_float_bound.block);
    expect_validation_clean(*device);
}

/// Many half-shells of light between a near square and a far wall that it stands before.
struct DepthEdge : TestWorld {
    DepthEdge() {
        add(square(6), glm::translate(glm::dmat4(1), {0, 0, -20}));
        for (int i = 0; i < 7; ++i)
            add(square(0.1f), glm::translate(glm::dmat4(1), {-0.9 + 0.3 * i, 0, 2}));
        for (int i = 0; i < 60; ++i)
            add_light({.intensity = 1, .range = 1.5f}, {std::cos(2.4 * i), std::sin(2.4 * i), -17.0 + 0.28 * i});
        camera = look_at(Camera{.yfov = 0.4}, {0, 0, 5}, {0, 0, 0});
    }
    PlacedCamera camera;
};

TEST(LightClusters, ADepthEdgeDoesNotPullInTheLightsBetween) {
    DepthEdge world;
    Shot shot{.world = &world.world, .camera = world.camera};
    shot.settings = {{"tile-size", "16"}};
    const uint64_t tiles = expect_every_contributing_light(shot, "tiles", "depth edge");
    const uint64_t clusters = expect_every_contributing_light(shot, "clusters", "depth edge");
    EXPECT_LT(clusters * 2, tiles);
}

TEST(LightTiles, SixteenThousandLightsKeepTheBoundThatBlendingLoses) {
    const Scene scene = make_scene("lights", 16384, 1);
    const World world = resolve(scene);
    Shot shot{.world = &world, .camera = world.cameras.at(0)};
    shot.width = 960; // smaller, and too many pixels lie beside an edge to count
    shot.height = 540;
    shot.settings = {{"light-culling", "tiles"}};
    expect_agrees(shot);
}

TEST(LightTiles, LightsOffScreenOrDarkCostNothing) {
    Garden garden;
    garden.add_light(garden.point(3, 10), {0, 2, 60});
    garden.add_light(garden.point(3, 0), {0, 2, 0});
    Shot shot = garden.shot();
    shot.settings = {{"light-culling", "tiles"}};
    EXPECT_EQ(render_counting_pairs(shot).stats.pairs_evaluated, 0u);
    World nothing = garden.world;
    nothing.lights.clear();
    shot.world = &nothing;
    EXPECT_EQ(render_counting_pairs(shot).stats.pairs_evaluated, 0u);
    expect_validation_clean(test_device());
}

TEST(LightListContents, AreTrimmedForTilesOnly) {
    Garden garden;
    garden.add_lights(24, 2.5f, 4);
    Shot shot = garden.shot();
    shot.settings = {{"light-culling", "tiles"}};
    const Rendered built = render_counting_pairs(shot);
    shot.settings["light-lists"] = "perfect";
    const Rendered perfect = render_counting_pairs(shot);
    EXPECT_EQ(perfect.stats.pairs_contributing, built.stats.pairs_contributing);
    EXPECT_LT(perfect.stats.pairs_evaluated, built.stats.pairs_evaluated);
    EXPECT_TRUE(same_bytes(perfect.linear, built.linear)); // the others add nothing
    shot.settings["light-lists"] = "empty";
    EXPECT_EQ(render_counting_pairs(shot).stats.pairs_evaluated, 0u);
    shot.settings["light-culling"] = "clusters";
    EXPECT_THROW(create_renderer("light-prepass", &test_device(), options_of(shot)), UsageError);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
